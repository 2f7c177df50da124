#include "schemes/euler_spiral/euler_spiral.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "schemes/euler_spiral/continuation.hpp"
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

/// A span of more chords is a circle that nearly misses its end, as large as its turn is near 2 pi: it runs away.
constexpr double longest = 100.0;

std::size_t longest_of(const std::vector<Span>& spans) {
  const auto along = [](const Span& span) { return span.clothoid.along; };
  return static_cast<std::size_t>(std::ranges::min_element(spans, {}, along) - spans.begin());
}

/// The point at an open end of span `i` whose heading nobody gave, if there is one: an arc bends by 2 / chord at most.
std::optional<std::size_t> free_end(const Polygon& polygon, std::size_t i) {
  if (polygon.closed) return std::nullopt;
  if (i == 0 && !polygon.start) return 0;
  if (i + 1 == polygon.chords() && !polygon.end) return i + 1;
  return std::nullopt;
}

/// Why these spans are no spline; empty if they are one.
std::string reason_unsolved(const Reached& reached, const std::vector<Span>& spans, const Polygon& polygon) {
  const std::size_t i = longest_of(spans);
  const G1Clothoid& span = spans[i].clothoid;
  const bool runs_away = span.along * longest < 1.0;
  if (reached.at.solved() && !runs_away) return {};
  std::string text = fmt::format("{}: the span from point {} to {} turns by {:.4g} degrees and is {:.3g} chords long",
                                 runs_away ? "a span runs away" : "no curve was found", i, (i + 1) % polygon.points(),
                                 span.turn() * 180.0 / std::numbers::pi, 1.0 / span.along);
  if (reached.bend < 1.0)
    text += fmt::format(", with all turns of the polygon at {:.4g} % of what they are", 100.0 * reached.bend);
  if (const auto end = free_end(polygon, i); end && runs_away)
    text += fmt::format("; a tangent given at point {} may help", *end);
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
  System system(polygon);
  Reached reached{newton(system, circle_headings(polygon), 1.0), 1.0};
  const bool continued = !reached.at.solved();
  if (continued) {
    const int iterations = reached.at.iterations;
    reached = from_small_turns(system, polygon.points());
    reached.at.iterations += iterations;
  }
  (void)system.evaluate(reached.at.headings, reached.bend);
  Report report{.outcome = Outcome::converged,
                .message = reason_unsolved(reached, system.spans(), polygon),
                .iterations = reached.at.iterations,
                .residual = reached.at.residual,
                .counters = {{"continued", continued ? 1 : 0}}};
  if (!report.message.empty()) {
    report.outcome = Outcome::not_converged;
    return {.input = input, .curve = std::nullopt, .report = std::move(report)};
  }
  std::vector<SpanPieces> spans;
  for (std::size_t i = 0; i < polygon.chords(); ++i)
    spans.push_back({.segments = {std::make_shared<ClothoidSegment>(placed(system.spans()[i].clothoid, input.points[i],
                                                                           polygon.lengths[i], polygon.directions[i]))},
                     .inside = Continuity::g2,
                     .at_end = Continuity::g2});
  return {.input = input, .curve = curve_of_spans(std::move(spans), input.closed), .report = std::move(report)};
}

void register_euler_spiral(Registry& registry) { registry.add<EulerSpiral>(); }

}  // namespace kappabench
