#include "schemes/intrinsic/angle_table.hpp"

#include <cstddef>
#include <vector>

#include "schemes/numerics/gauss.hpp"

namespace kappabench::intrinsic {

namespace {

constexpr int gauss_points = 16;

/// Integrals from 0 to v of the Bernstein basis of `degree`: sums of the basis of the next degree, over it.
Eigen::RowVectorXd integrated_bernstein(int degree, double v) {
  Eigen::RowVectorXd higher = Eigen::RowVectorXd::Zero(degree + 2);
  higher[0] = 1.0;
  for (int d = 1; d <= degree + 1; ++d) {
    for (int j = d; j > 0; --j) higher[j] = (1.0 - v) * higher[j] + v * higher[j - 1];
    higher[0] *= 1.0 - v;
  }
  Eigen::RowVectorXd integrals(degree + 1);
  double sum = 0.0;
  for (int j = degree; j >= 0; --j) integrals[j] = (sum += higher[j + 1]) / (degree + 1);
  return integrals;
}

}  // namespace

AngleTable angle_table(const BSplineBasis& basis, int panels) {
  const int n = basis.degree;
  const std::vector<KnotSpan> spans = spans_of(basis);
  const auto nodes = static_cast<Eigen::Index>(spans.size()) * panels * gauss_points;
  AngleTable table{Eigen::VectorXd(nodes), Eigen::MatrixXd(nodes, basis.size()), {}};
  Eigen::RowVectorXd before = Eigen::RowVectorXd::Zero(basis.size());
  Eigen::Index node = 0;
  for (const KnotSpan& span : spans) {
    for_composite_gauss_nodes<gauss_points>(panels, [&](double v, double weight) {
      table.weights[node] = weight * span.width();
      table.integrals.row(node) = before;
      table.integrals.row(node).segment(span.first, n + 1) +=
          span.width() * integrated_bernstein(n, v) * span.to_bernstein;
      ++node;
    });
    before.segment(span.first, n + 1) += span.width() * integrated_bernstein(n, 1.0) * span.to_bernstein;
  }
  table.totals = before.transpose();
  return table;
}

RuleTable::RuleTable(const AngleTable& table, const ControlRule& rule)
    : weights(table.weights),
      first(table.integrals * rule.first),
      last(table.integrals * rule.last),
      fixed(table.integrals * rule.fixed),
      first_total(table.totals.dot(rule.first)),
      last_total(table.totals.dot(rule.last)),
      fixed_total(table.totals.dot(rule.fixed)),
      first_moment((weights * first).sum()),
      last_moment((weights * last).sum()),
      fixed_moment((weights * fixed).sum()),
      second_moments{(weights * first * first).sum(), (weights * first * last).sum(), (weights * last * last).sum()},
      third_moments{(weights * first * first * first).sum(), (weights * first * first * last).sum(),
                    (weights * first * last * last).sum(), (weights * last * last * last).sum()} {}

int panels_for(const BSplineBasis& basis, double turning) {
  return 1 + static_cast<int>(0.25 * (basis.degree + 1) * turning);
}

}  // namespace kappabench::intrinsic
