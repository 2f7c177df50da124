#include "schemes/classical/catmull_rom.hpp"

#include <memory>
#include <utility>

#include "schemes/classical/parametrization.hpp"
#include "schemes/segments/polynomial.hpp"

namespace kappabench {

SchemeInfo CatmullRom::describe() {
  return {.id = "catmull-rom",
          .title = "Cubic Catmull-Rom spline",
          .citation =
              "Catmull and Rom, A class of local interpolating splines, 1974; Barry and Goldman, A recursive "
              "evaluation algorithm for a class of Catmull-Rom splines, SIGGRAPH 1988",
          .parameters = {{.name = "alpha",
                          .default_value = 0.5,
                          .help = "power of the chords: 0 uniform, 0.5 centripetal, 1 chord length",
                          .least = 0.0,
                          .most = 1.0}},
          .traits = {.fewest_open_points = 2,
                     .continuity = Continuity::g1,
                     .continuity_exceptions = "points where the speed vanishes: G0",
                     .locality = 2},
          .version = 2};
}

CatmullRom::CatmullRom(Parameters parameters) : Scheme(describe(), std::move(parameters)) {}

namespace {

/// Derivative at a point with respect to the global parameter: that of the parabola through the point and its
/// neighbours at span lengths h0 and h1 (Barry and Goldman 1988).
Vec2 tangent(const Vec2& before, const Vec2& at, const Vec2& after, double h0, double h1) {
  return (h1 * (at - before) / h0 + h0 * (after - at) / h1) / (h0 + h1);
}

/// Tangents at all points. The reflected neighbour of an open end makes its tangent the slope of its span.
std::vector<Vec2> tangents(const Input& input, const std::vector<double>& h) {
  const std::size_t n = input.points.size();
  const auto& p = input.points;
  std::vector<Vec2> result(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    if (!input.closed && i == 0)
      result[i] = (p[1] - p[0]) / h[0];
    else if (!input.closed && i == n - 1)
      result[i] = (p[i] - p[i - 1]) / h[i - 1];
    else
      result[i] = tangent(p[before], p[i], p[after], h[before], h[i]);
  }
  return result;
}

}  // namespace

Fit CatmullRom::solve(const Input& input) const {
  const std::vector<double> h = span_lengths(input, parameters().real("alpha"));
  const std::vector<Vec2> v = tangents(input, h);
  std::vector<SegmentPtr> segments;
  for (std::size_t i = 0; i < h.size(); ++i) {
    const std::size_t next = (i + 1) % input.points.size();
    const Vec2 &p0 = input.points[i], &p1 = input.points[next];
    const std::array<Vec2, 4> control{p0, p0 + h[i] / 3.0 * v[i], p1 - h[i] / 3.0 * v[next], p1};
    segments.push_back(std::make_shared<PolynomialSegment>(control));
  }
  return {.input = input,
          .curve = curve_through_joints(std::move(segments), input.closed, Continuity::g1),
          .report = {.outcome = Outcome::converged}};
}

void register_catmull_rom(Registry& registry) { registry.add<CatmullRom>(); }

}  // namespace kappabench
