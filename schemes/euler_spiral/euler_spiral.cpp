#include "schemes/euler_spiral/euler_spiral.hpp"

#include <fmt/format.h>

#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "schemes/euler_spiral/solution.hpp"
#include "schemes/segments/clothoid.hpp"
#include "schemes/segments/spans.hpp"

namespace kappabench {

using namespace euler_spiral;

SchemeInfo EulerSpiral::describe() {
  return {.id = "euler-spiral",
          .title = "Euler-spiral spline",
          .citation =
              "Levien, From spiral to spline: optimal techniques in interactive curve design, PhD thesis, University "
              "of California, Berkeley, 2009; Bertolazzi and Frego, Interpolating clothoid splines with curvature "
              "continuity, Math. Meth. Appl. Sci. 41, 2018",
          .traits = {.fewest_open_points = 2, .continuity = Continuity::g2}};
}

EulerSpiral::EulerSpiral(Parameters parameters) : Scheme(describe(), std::move(parameters)) {}

namespace {

/// The point at an open end of span `i` whose heading nobody gave, if there is one: an arc bends by 2 / chord at most.
std::optional<std::size_t> free_end(const Polygon& polygon, std::size_t i) {
  if (polygon.closed) return std::nullopt;
  if (i == 0 && !polygon.start) return 0;
  if (i + 1 == polygon.chords() && !polygon.end) return i + 1;
  return std::nullopt;
}

/// Where and how it runs away, or what else keeps it from being a spline.
std::string reason_unsolved(const Solution& solution, const Polygon& polygon) {
  const std::size_t i = solution.longest_span();
  const G1Clothoid& span = solution.spans[i].clothoid;
  std::string text = fmt::format("{}: the span from point {} to {} turns by {:.4g} degrees and is {:.3g} chords long",
                                 solution.runs_away() ? "a span runs away" : "no curve was found", i,
                                 (i + 1) % polygon.points(), span.turn() * 180.0 / std::numbers::pi, 1.0 / span.along);
  if (solution.bend < 1.0)
    text += fmt::format(", with all turns of the polygon at {:.4g} % of what they are", 100.0 * solution.bend);
  if (const auto end = free_end(polygon, i)) text += fmt::format("; a tangent given at point {} may help", *end);
  return text;
}

ClothoidForm placed(const G1Clothoid& clothoid, const Vec2& from, double chord, double direction) {
  const double length = chord / clothoid.along;
  return {.start = from,
          .angle = direction + clothoid.start,
          .curvature = (clothoid.end - clothoid.start - clothoid.shape) / length,
          .curvature_rate = 2.0 * clothoid.shape / (length * length),
          .length = length};
}

}  // namespace

Fit EulerSpiral::solve(const Input& input) const {
  const Polygon polygon = polygon_of(input);
  const Solution solution = solution_of(polygon);
  Report report{.outcome = Outcome::converged,
                .iterations = solution.iterations,
                .residual = solution.residual,
                .counters = {{"continued", solution.continued ? 1 : 0}, {"other_side", solution.other_side}}};
  if (!solution.is_spline()) {
    report.outcome = Outcome::not_converged;
    report.message = reason_unsolved(solution, polygon);
    return {.input = input, .curve = std::nullopt, .report = std::move(report)};
  }
  std::vector<SpanPieces> spans;
  for (std::size_t i = 0; i < polygon.chords(); ++i)
    spans.push_back({.segments = {std::make_shared<ClothoidSegment>(placed(solution.spans[i].clothoid, input.points[i],
                                                                           polygon.lengths[i], polygon.directions[i]))},
                     .inside = Continuity::g2,
                     .at_end = Continuity::g2});
  return {.input = input, .curve = curve_of_spans(std::move(spans), input.closed), .report = std::move(report)};
}

void register_euler_spiral(Registry& registry) { registry.add<EulerSpiral>(); }

}  // namespace kappabench
