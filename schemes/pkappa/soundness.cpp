#include "schemes/pkappa/soundness.hpp"

#include <algorithm>
#include <cmath>

#include "schemes/pkappa/segment_energy.hpp"

namespace kappabench::pkappa {

template <Continuity K>
Verification verify(const Chain& chain, const QuadratureRule& rule) {
  constexpr int degree = Layout<K>::degree;
  constexpr double agreement = 0.02, negligible = 1e-6, longest = 3.0;
  SegmentEnergy<degree> coarse(rule), fine(fine_gauss_rule());
  Verification v{.sound = true};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const ControlPolygon<degree> control = polygon<K>(chain, i);
    const double expected = coarse.terms(control, chain.t[i]).parabola;
    const double found = fine.terms(control, chain.t[i]).parabola;
    if (!(std::abs(found - expected) <= agreement * found + negligible)) v.sound = false;
    double edges = 0.0;
    for (int j = 0; j < degree; ++j) edges += (control.col(j + 1) - control.col(j)).norm();
    const double direct = (control.col(0) - chain.points[i]).norm() + (control.col(degree) - chain.points[i]).norm();
    if (edges > longest * direct) v.sound = false;
    v.worst_parabola = std::max(v.worst_parabola, found);
  }
  return v;
}

template Verification verify<Continuity::c1>(const Chain&, const QuadratureRule&);
template Verification verify<Continuity::g1>(const Chain&, const QuadratureRule&);
template Verification verify<Continuity::c2>(const Chain&, const QuadratureRule&);
template Verification verify<Continuity::g2>(const Chain&, const QuadratureRule&);

}  // namespace kappabench::pkappa
