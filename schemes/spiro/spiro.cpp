#include "schemes/spiro/spiro.hpp"

#include <bezctx.h>
#include <fmt/format.h>
#include <spiroentrypoints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include "schemes/segments/clothoid.hpp"
#include "schemes/segments/spans.hpp"
#include "schemes/spiro/polish.hpp"

namespace kappabench {

SchemeInfo Spiro::describe() {
  return {
      .id = "spiro",
      .title = "Euler-spiral spline of libspiro",
      .citation =
          "Levien, From spiral to spline: optimal techniques in interactive curve design, PhD thesis, University of "
          "California, Berkeley, 2009",
      .traits = {.fewest_open_points = 2, .continuity = Continuity::g2},
      .version = 2,
      .libraries = {{"libspiro", LibSpiroVersion()}}};
}

Spiro::Spiro(Parameters parameters) : Scheme(describe(), std::move(parameters)) {}

namespace {

struct FreeSpiro {
  void operator()(spiro_seg* segments) const { free_spiro(segments); }
};
using Solution = std::unique_ptr<spiro_seg, FreeSpiro>;

/// libspiro's answer for points that are all joined with continuous curvature; null if it did not converge.
Solution run_libspiro(const Input& input) {
  std::vector<spiro_cp> points;
  for (const Vec2& p : input.points) points.push_back({p.x(), p.y(), SPIRO_G2});
  if (!input.closed) {
    points.front().ty = SPIRO_OPEN_CONTOUR;
    points.back().ty = SPIRO_END_OPEN_CONTOUR;
  }
  std::array<double, 6> scale_and_offset{-1.0};  // to be chosen by the library
  return Solution(run_spiro0(points.data(), scale_and_offset.data(), 0, input.size()));
}

/// Largest jump of heading or curvature that counts as solved. It moves the end of a clothoid by about this part of its
/// length.
constexpr double accuracy = 1e-7;

/// From the start of a bend of unit length to its end, headings being those over s.
Vec2 end_of(const SpiroBend& bend) {
  return clothoid_displacement(-0.5 * bend.k0 + 0.125 * bend.k1, bend.k0 - 0.5 * bend.k1, bend.k1, 1.0);
}

/// Not where the chord is so short for its clothoid that the length is not known to a thousandth.
bool determined(const SpiroBend& bend) { return !(accuracy > 1e-3 * end_of(bend).norm()); }

/// Length and direction follow from the chord.
ClothoidForm clothoid_between(const SpiroBend& bend, const Vec2& chord, const Vec2& from) {
  const auto [k0, k1] = bend;
  const Vec2 end = end_of(bend);
  const double length = chord.norm() / end.norm(), start = k0 - 0.5 * k1;
  return {.start = from,
          .angle = std::atan2(chord.y(), chord.x()) - std::atan2(end.y(), end.x()) - 0.5 * k0 + 0.125 * k1,
          .curvature = start / length,
          .curvature_rate = k1 / (length * length),
          .length = length};
}

std::vector<ClothoidForm> clothoids_of(std::span<const SpiroBend> bends, std::span<const Vec2> chords,
                                       std::span<const Vec2> points) {
  std::vector<ClothoidForm> clothoids;
  for (std::size_t i = 0; i < bends.size(); ++i) clothoids.push_back(clothoid_between(bends[i], chords[i], points[i]));
  return clothoids;
}

/// The largest jump at the points: of heading in radians, or of curvature times the shorter of the two clothoids.
double largest_jump(std::span<const ClothoidForm> clothoids, bool closed) {
  double largest = 0.0;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < clothoids.size(); ++i) {
    const ClothoidForm &a = clothoids[i], &b = clothoids[(i + 1) % clothoids.size()];
    const double heading = a.angle + (a.curvature + 0.5 * a.curvature_rate * a.length) * a.length;
    const double curvature = a.curvature + a.curvature_rate * a.length - b.curvature;
    for (const double jump : {std::abs(std::remainder(heading - b.angle, 2.0 * std::numbers::pi)),
                              std::abs(curvature) * std::min(a.length, b.length)})
      largest = std::isfinite(jump) ? std::max(largest, jump) : std::numeric_limits<double>::infinity();
  }
  return largest;
}

}  // namespace

Fit Spiro::solve(const Input& input) const {
  const auto without_curve = [&input](Outcome outcome, std::string message) -> Fit {
    return {.input = input, .curve = std::nullopt, .report = {.outcome = outcome, .message = std::move(message)}};
  };
  const Solution solution = run_libspiro(input);
  if (!solution)
    return without_curve(Outcome::not_converged, "libspiro did not converge; points with gentler turns may help");
  std::vector<SpiroBend> bends;
  std::vector<Vec2> chords;
  const std::size_t n = input.points.size();
  for (std::size_t i = 0; i < (input.closed ? n : n - 1); ++i) {
    bends.push_back({solution.get()[i].ks[0], solution.get()[i].ks[1]});
    chords.push_back(input.points[(i + 1) % n] - input.points[i]);
  }
  for (std::size_t i = 0; i < bends.size(); ++i)
    if (!determined(bends[i]))
      return without_curve(Outcome::not_converged,
                           fmt::format("libspiro's solution from point {} to {} is over {:.0e} chords long, which its "
                                       "accuracy does not determine; points with gentler turns may help",
                                       i, (i + 1) % n, 1e-3 / accuracy));
  Report report{.outcome = Outcome::converged,
                .residual = largest_jump(clothoids_of(bends, chords, input.points), input.closed)};
  if (!std::isfinite(report.residual))
    return without_curve(Outcome::failed, "libspiro's solution is not finite; rescale the drawing");
  if (report.residual > accuracy) {
    report.outcome = Outcome::not_converged;
    report.message =
        fmt::format("libspiro's solution leaves a jump of {:.1e} in heading or curvature", report.residual);
  } else {
    polish(bends, chords, input.closed);
  }
  const std::vector<ClothoidForm> clothoids = clothoids_of(bends, chords, input.points);
  report.residual = largest_jump(clothoids, input.closed);

  std::vector<SpanPieces> spans;
  spans.reserve(clothoids.size());
  for (const ClothoidForm& clothoid : clothoids)
    spans.push_back({.segments = {std::make_shared<ClothoidSegment>(clothoid)},
                     .inside = Continuity::g2,
                     .at_end = Continuity::g2});
  return {.input = input, .curve = curve_of_spans(std::move(spans), input.closed), .report = std::move(report)};
}

void register_spiro(Registry& registry) { registry.add<Spiro>(); }

}  // namespace kappabench
