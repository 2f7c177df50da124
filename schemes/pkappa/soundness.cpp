#include "schemes/pkappa/soundness.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "schemes/pkappa/near_cusp.hpp"
#include "schemes/pkappa/segment_energy.hpp"

namespace kappabench::pkappa {

template <int Degree>
Verification verify(std::span<const ControlPolygon<Degree>> control, std::span<const double> t,
                    std::span<const Vec2> points, double unit, const QuadratureRule& rule) {
  constexpr double agreement = 0.02, negligible = 1e-6, longest = 3.0, vanished = 1e-6;
  // Turns within less than the mean distance of nodes may lie between them.
  const double narrow = 1.0 / static_cast<double>(finest_gauss_rule().nodes().size());
  SegmentEnergy<Degree> coarse(rule), fine(finest_gauss_rule());
  Verification v{.sound = true};
  for (std::size_t i = 0; i < control.size(); ++i) {
    const ControlPolygon<Degree>& c = control[i];
    const double expected = unit * coarse.terms(c, t[i]).parabola, found = unit * fine.terms(c, t[i]).parabola;
    bool sound = std::abs(found - expected) <= agreement * found + negligible;
    const double shortest = std::min((c.col(1) - c.col(0)).norm(), (c.col(Degree) - c.col(Degree - 1)).norm());
    sound = sound && shortest > vanished * unit;
    double edges = 0.0;
    for (int j = 0; j < Degree; ++j) edges += (c.col(j + 1) - c.col(j)).norm();
    const double direct = (c.col(0) - points[i]).norm() + (c.col(Degree) - points[i]).norm();
    sound = sound && edges <= longest * direct;
    const std::optional<double> cusp = near_cusp<Degree>(c, narrow);
    if ((!sound || cusp) && v.sound) {
      v.sound = false;
      v.unsound_segment = static_cast<int>(i);
      v.near_cusp = cusp;
    }
    v.worst_parabola = std::max(v.worst_parabola, found);
  }
  return v;
}

template <Continuity K>
Verification verify(const JointChain& chain, const QuadratureRule& rule) {
  constexpr int degree = Layout<K>::degree;
  std::vector<ControlPolygon<degree>> control;
  for (std::size_t i = 0; i < chain.size(); ++i) control.push_back(polygon<K>(chain, i));
  return verify<degree>(std::span<const ControlPolygon<degree>>(control), chain.t, chain.points, 1.0, rule);
}

template Verification verify<4>(std::span<const ControlPolygon<4>>, std::span<const double>, std::span<const Vec2>,
                                double, const QuadratureRule&);
template Verification verify<5>(std::span<const ControlPolygon<5>>, std::span<const double>, std::span<const Vec2>,
                                double, const QuadratureRule&);
template Verification verify<Continuity::c1>(const JointChain&, const QuadratureRule&);
template Verification verify<Continuity::g1>(const JointChain&, const QuadratureRule&);
template Verification verify<Continuity::c2>(const JointChain&, const QuadratureRule&);
template Verification verify<Continuity::g2>(const JointChain&, const QuadratureRule&);

}  // namespace kappabench::pkappa
