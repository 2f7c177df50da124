#include "schemes/yuksel/yuksel.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "schemes/segments/blend.hpp"
#include "schemes/segments/open_curve.hpp"
#include "schemes/segments/spans.hpp"
#include "schemes/yuksel/local_curve.hpp"

namespace kappabench {

SchemeInfo Yuksel::describe() {
  return {.id = "yuksel",
          .title = "Trigonometric blending of local arcs",
          .citation = "Yuksel, A class of C2 interpolating splines, ACM Transactions on Graphics 39(5), 2020",
          .parameters = {{.name = "arc",
                          .default_value = std::string("hybrid"),
                          .help = "the local curve through a point and its neighbours; hybrid: circular or elliptical",
                          .choices = {"bezier", "circular", "elliptical", "hybrid"}},
                         {.name = "parametrization",
                          .default_value = std::string("g2"),
                          .help = "g2: each half of a local curve at its own speed, as published; c2: one smooth speed",
                          .choices = {"g2", "c2"}}},
          .traits = {.fewest_open_points = 2,
                     .continuity = Continuity::g2,
                     .continuity_exceptions = "arc=bezier: G0 at points where the legs turn straight back",
                     .locality = 2},
          .version = 2};
}

namespace {

/// Of these parameters: the claim depends on the speed.
SchemeInfo described(const Parameters& parameters) {
  SchemeInfo info = Yuksel::describe();
  if (parameters.text("parametrization") == "c2") info.traits.continuity = Continuity::c2;
  return info;
}

}  // namespace

Yuksel::Yuksel(const Parameters& parameters) : Scheme(described(parameters), parameters) {}

Fit Yuksel::solve(const Input& input) const {
  const yuksel::Arc arc = yuksel::arc_of(parameters().text("arc"));
  const bool smooth_speed = parameters().text("parametrization") == "c2";
  const auto n = static_cast<std::size_t>(input.size());
  if (n == 2) return {.input = input, .curve = straight_line(input.points), .report = {.outcome = Outcome::converged}};

  // local[i] belongs to point i; those of open ends stay empty.
  std::vector<ArcPair> local(n);
  for (std::size_t i = input.closed ? 0 : 1; i < (input.closed ? n : n - 1); ++i) {
    const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    const auto pair = yuksel::local_curve(arc, input.points[before], input.points[i], input.points[after]);
    if (!pair)
      return {.input = input,
              .curve = std::nullopt,
              .report = {.outcome = Outcome::unsupported_input,
                         .message = fmt::format("the legs at point {} turn straight back, no circle or ellipse follows "
                                                "them; move a point off the line or use arc=bezier",
                                                i)}};
    local[i] = smooth_speed ? yuksel::with_equal_extents(*pair) : *pair;
  }

  const Continuity claimed = info().traits.continuity;
  std::vector<SpanPieces> spans;
  for (std::size_t i = 0; i < (input.closed ? n : n - 1); ++i) {
    const SegmentPtr& from = local[i].second;
    const SegmentPtr& to = local[(i + 1) % n].first;
    // The first and last span of an open curve are halves of a local curve, not blended.
    SegmentPtr segment = !from ? to : !to ? from : std::make_shared<BlendSegment>(from, to);
    spans.push_back({.segments = {std::move(segment)}, .inside = claimed, .at_end = claimed});
  }
  return {.input = input,
          .curve = curve_of_spans(std::move(spans), input.closed),
          .report = {.outcome = Outcome::converged}};
}

void register_yuksel(Registry& registry) { registry.add<Yuksel>(); }

}  // namespace kappabench
