#include "schemes/intrinsic/controls.hpp"

#include <cstddef>
#include <vector>

namespace kappabench::intrinsic {

ControlRule interpolated(const BSplineBasis& basis, int i1, int im, double p) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(basis.size());
  ControlRule rule{zero, zero, zero};
  const std::vector<double> x = greville_abscissae(basis);
  const auto at = [&](int i) { return x[static_cast<std::size_t>(i)]; };
  for (int i = i1; i <= im; ++i) {
    // Yoshida 2022, Eq. (10): the share of y on the straight line.
    const double share = (at(i) - at(i1)) / (at(im) - at(i1));
    // Eq. (11) draws the controls between towards one of the two.
    const bool inner = i > i1 && i < im;
    rule.last[i] = !inner ? share : p >= 0.0 ? (1.0 - p) * share : (1.0 + p) * share - p;
    rule.first[i] = 1.0 - rule.last[i];
  }
  return rule;
}

void fix(ControlRule& rule, int i, double value) {
  rule.first[i] = rule.last[i] = 0.0;
  rule.fixed[i] = value;
}

void tie(ControlRule& rule, int i, int to) {
  rule.first[i] = rule.first[to];
  rule.last[i] = rule.last[to];
  rule.fixed[i] = rule.fixed[to];
}

}  // namespace kappabench::intrinsic
