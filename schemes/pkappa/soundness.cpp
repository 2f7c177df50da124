#include "schemes/pkappa/soundness.hpp"

#include <algorithm>
#include <cmath>

#include "schemes/pkappa/near_cusp.hpp"
#include "schemes/pkappa/published_start.hpp"
#include "schemes/pkappa/segment_energy.hpp"

namespace kappabench::pkappa {
namespace {

template <int Degree>
double polygon_length(const ControlPolygon<Degree>& c) {
  return (c.template rightCols<Degree>() - c.template leftCols<Degree>()).colwise().norm().sum();
}

/// Control polygons over chords: from the first joint to the first point, of every span, from the last point to the
/// last joint; over a closed curve that last piece and the first one are a span.
template <int Degree>
void find_detours(std::span<const ControlPolygon<Degree>> control, std::span<const double> t,
                  std::span<const Vec2> points, bool cyclic, std::vector<SegmentCheck>& checks) {
  const std::size_t n = control.size();
  std::vector<double> before(n), after(n);
  for (std::size_t i = 0; i < n; ++i) {
    before[i] = polygon_length<Degree>(part<Degree>(control[i], 0.0, t[i]));
    after[i] = polygon_length<Degree>(part<Degree>(control[i], t[i], 1.0));
  }
  const auto note = [&](std::size_t i, double length, double chord) {
    checks[i].detour = std::max(checks[i].detour, length / chord);
  };
  for (std::size_t i = 0; i + 1 < n || (cyclic && i < n); ++i) {
    const std::size_t next = i + 1 < n ? i + 1 : 0;
    const double length = after[i] + before[next], chord = (points[next] - points[i]).norm();
    note(i, length, chord);
    note(next, length, chord);
  }
  if (cyclic) return;
  note(0, before.front(), (control.front().col(0) - points.front()).norm());
  note(n - 1, after.back(), (control.back().col(Degree) - points[n - 1]).norm());
}

}  // namespace

template <int Degree>
std::vector<SegmentCheck> check_segments(std::span<const ControlPolygon<Degree>> control, std::span<const double> t,
                                         std::span<const Vec2> points, std::span<const double> units, bool cyclic,
                                         const QuadratureRule& rule) {
  constexpr double agreement = 0.02, negligible = 1e-6, longest = 3.0, vanished = 1e-6;
  // Turns within less than the mean distance of nodes may lie between them.
  const double narrow = 1.0 / static_cast<double>(finest_gauss_rule().nodes().size());
  SegmentEnergy<Degree> coarse(rule), fine(finest_gauss_rule());
  std::vector<SegmentCheck> checks(control.size());
  for (std::size_t i = 0; i < control.size(); ++i) {
    const ControlPolygon<Degree>& c = control[i];
    const double unit = units[i];
    const double expected = unit * coarse.terms(c, t[i]).parabola, found = unit * fine.terms(c, t[i]).parabola;
    const double shortest = std::min((c.col(1) - c.col(0)).norm(), (c.col(Degree) - c.col(Degree - 1)).norm());
    const double direct = (c.col(0) - points[i]).norm() + (c.col(Degree) - points[i]).norm();
    checks[i].parabola = found;
    checks[i].near_cusp = near_cusp<Degree>(c, narrow, Degree * vanished * unit);
    checks[i].sound = std::abs(found - expected) <= agreement * found + negligible && shortest > vanished * unit &&
                      polygon_length<Degree>(c) <= longest * direct && !checks[i].near_cusp;
  }
  find_detours<Degree>(control, t, points, cyclic, checks);
  return checks;
}

template <Continuity K>
std::vector<SegmentCheck> check_segments(const JointChain& chain, const QuadratureRule& rule) {
  constexpr int degree = Layout<K>::degree;
  std::vector<ControlPolygon<degree>> control;
  std::vector<double> units;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    control.push_back(polygon<K>(chain, i));
    units.push_back(chain.unit(i));
  }
  return check_segments<degree>(std::span<const ControlPolygon<degree>>(control), chain.t, chain.points, units,
                                chain.cyclic, rule);
}

bool all_sound(std::span<const SegmentCheck> checks) { return std::ranges::all_of(checks, &SegmentCheck::sound); }
bool all_good(std::span<const SegmentCheck> checks) { return std::ranges::all_of(checks, &SegmentCheck::good); }

bool better(const Judgement& a, const Judgement& b, double part) {
  return a.sound != b.sound ? a.sound : a.energy < part * b.energy;
}

template std::vector<SegmentCheck> check_segments<4>(std::span<const ControlPolygon<4>>, std::span<const double>,
                                                     std::span<const Vec2>, std::span<const double>, bool,
                                                     const QuadratureRule&);
template std::vector<SegmentCheck> check_segments<5>(std::span<const ControlPolygon<5>>, std::span<const double>,
                                                     std::span<const Vec2>, std::span<const double>, bool,
                                                     const QuadratureRule&);
template std::vector<SegmentCheck> check_segments<Continuity::c1>(const JointChain&, const QuadratureRule&);
template std::vector<SegmentCheck> check_segments<Continuity::g1>(const JointChain&, const QuadratureRule&);
template std::vector<SegmentCheck> check_segments<Continuity::c2>(const JointChain&, const QuadratureRule&);
template std::vector<SegmentCheck> check_segments<Continuity::g2>(const JointChain&, const QuadratureRule&);

}  // namespace kappabench::pkappa
