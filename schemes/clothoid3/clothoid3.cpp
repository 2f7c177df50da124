#include "schemes/clothoid3/clothoid3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "schemes/clothoid3/clc.hpp"
#include "schemes/clothoid3/refine.hpp"
#include "schemes/segments/clothoid.hpp"
#include "schemes/segments/g1_clothoid.hpp"
#include "schemes/segments/joint_claim.hpp"
#include "schemes/segments/spans.hpp"

namespace kappabench {

using namespace clothoid3;

SchemeInfo Clothoid3::describe() {
  return {.id = "clothoid3",
          .title = "Local clothoid spline",
          .citation =
              "Binninger and Sorkine-Hornung, Smooth interpolating curves with local control and monotone alternating "
              "curvature, Computer Graphics Forum 41(5), 2022; Bertolazzi and Frego, On the G2 Hermite interpolation "
              "problem with clothoids, J. Comput. Appl. Math. 341, 2018",
          .parameters = {{.name = "pieces",
                          .default_value = std::string("3arcs"),
                          .help = "between two points: three clothoids, or clothoid, line, clothoid",
                          .choices = {"3arcs", "clc"}},
                         {.name = "curvature",
                          .default_value = std::string("g1"),
                          .help = "at a point: mean of the clothoids to its neighbours, or that of the local conic",
                          .choices = {"g1", "conic"}},
                         {.name = "refine",
                          .default_value = true,
                          .help = "raise the curvature at points so that spans have no peak of curvature inside"},
                         {.name = "compat",
                          .default_value = false,
                          .help = "the published code's absolute limits, differences and bisections"}},
          .traits = {.fewest_open_points = 2,
                     .continuity = Continuity::g2,
                     .continuity_exceptions = "corners (G0) where the legs turn straight back",
                     .locality = 4,
                     .hermite = true},
          .version = 4};
}

namespace {

/// Of these parameters: which points a span depends on is counted in README.md.
SchemeInfo described(const Parameters& parameters) {
  SchemeInfo info = Clothoid3::describe();
  SchemeTraits& traits = info.traits;
  traits.locality = 2 + (parameters.text("curvature") == "g1" ? 1 : 0) + (parameters.flag("refine") ? 1 : 0);
  const bool clc = parameters.text("pieces") == "clc", compat = parameters.flag("compat");
  if (compat) {
    traits.continuity_exceptions =
        "corners (G0) at points closer than 0.01; G0 where kinks of up to 0.001 rad stay at aligned points";
  }
  if (clc)
    traits.continuity_exceptions +=
        "; lines (G0 where kinks of up to 0.01 rad stay at their ends, G1 where a clothoid vanishes)";
  traits.similarity_invariant = !compat;
  traits.reversal_invariant = !compat && !clc;
  return info;
}

/// One span, and how it was made.
struct Span {
  std::vector<ClothoidForm> pieces;
  Continuity claimed = Continuity::g2;  ///< at its ends
  int iterations = 0;
  double residual = 0.0;
  bool clc = false;
  bool lacks_property = false;  ///< after refinement
};

Span straight(const Vec2& from, const Vec2& to, Continuity claimed) {
  const Vec2 chord = to - from;
  return {.pieces = {{from, std::atan2(chord.y(), chord.x()), 0.0, 0.0, chord.norm()}}, .claimed = claimed};
}

bool runs_along_chord(const CurveElement& from, const CurveElement& to, const Rules& rules) {
  const Vec2 chord = to.point - from.point;
  const double direction = std::atan2(chord.y(), chord.x());
  const auto off = [&](double heading) {
    return std::abs(std::remainder(heading - direction, 2.0 * std::numbers::pi));
  };
  return std::max(off(from.heading), off(to.heading)) <= 4.0 * rules.aligned_sine;
}

/// Step 5: what lies between two points.
Span arcs_between(const CurveElement& from, const CurveElement& to, Pieces pieces, const Rules& rules) {
  if (pieces == Pieces::clc && from.curvature != 0.0 && to.curvature != 0.0) {
    auto found = clothoid_line_clothoid(from, to, rules);
    if (found && found->misalignment < allowed_misalignment)
      return {.pieces = std::move(found->pieces), .residual = found->misalignment, .clc = true};
  }
  if (const auto found = three_arcs(from, to)) {
    const bool curved = std::min(std::abs(from.curvature), std::abs(to.curvature)) > rules.least_curvature;
    return {.pieces = {found->arcs.begin(), found->arcs.end()},
            .iterations = found->iterations,
            .residual = found->residual,
            .lacks_property = curved && !good(*found, from.curvature, to.curvature, rules)};
  }
  // What the published code does then.
  return straight(from.point, to.point, Continuity::g0);
}

Span span_between(const CurveElement& from, const CurveElement& to, Pieces pieces, const Rules& rules) {
  const bool flat = from.curvature == 0.0 && to.curvature == 0.0;
  if (flat && runs_along_chord(from, to, rules)) return straight(from.point, to.point, Continuity::g2);
  return arcs_between(from, to, pieces, rules);
}

/// Two points that stand alone. A heading that nobody gave is that of the circle which the other one determines, a
/// curvature that of the clothoid with both headings; that clothoid itself where no curvature is given. Nothing is
/// refined, and data that are all but straight are met like any others.
Span lone_span(const Input& input, const Run& run, Pieces pieces, const Rules& rules) {
  const Vec2 &start = input.points[run.points.front()], &end = input.points[run.points.back()];
  const PointOptions& at_start = input.options_of(static_cast<int>(run.points.front()));
  const PointOptions& at_end = input.options_of(static_cast<int>(run.points.back()));
  const bool curvature_given = at_start.curvature || at_end.curvature;
  if (!at_start.tangent && !at_end.tangent && !curvature_given) return straight(start, end, Continuity::g2);

  const double direction = std::atan2(end.y() - start.y(), end.x() - start.x());
  const auto mirrored = [direction](double heading) { return 2.0 * direction - heading; };
  CurveElement from{start, at_start.tangent.value_or(mirrored(at_end.tangent.value_or(direction))), 0.0};
  CurveElement to{end, at_end.tangent.value_or(mirrored(from.heading)), 0.0};
  const auto clothoid = g1_clothoid(from.point, from.heading, to.point, to.heading);
  if (!clothoid) return straight(start, end, Continuity::g0);
  if (!curvature_given) return {.pieces = {*clothoid}};
  from.curvature = at_start.curvature.value_or(clothoid->curvature);
  to.curvature = at_end.curvature.value_or(clothoid->curvature + clothoid->curvature_rate * clothoid->length);
  Span span = arcs_between(from, to, pieces, rules);
  // Where a clothoid has vanished, the line next to it cannot have the given heading and curvature.
  if (span.clc && span.pieces.size() < 3) span = arcs_between(from, to, Pieces::three_arcs, rules);
  return span;
}

std::vector<Span> spans_of(const Input& input, const Run& run, Pieces pieces, bool refined, const Rules& rules) {
  if (run.points.size() == 2) return {lone_span(input, run, pieces, rules)};
  std::vector<PointElement> elements = elements_of(input, run, rules);
  if (refined) refine(elements, run.closed, pieces, rules);
  std::vector<Span> spans;
  for (std::size_t i = 0; i < run.spans(); ++i)
    spans.push_back(span_between(elements[i].at, elements[(i + 1) % elements.size()].at, pieces, rules));
  return spans;
}

/// All spans in the order of the points they start at, and which points are corners.
struct Layout {
  std::vector<Span> spans;
  std::vector<bool> corner;
};

Layout layout_of(const Input& input, Pieces pieces, bool refined, const Rules& rules) {
  const std::size_t n = input.points.size();
  Layout layout{std::vector<Span>(input.closed ? n : n - 1), std::vector<bool>(n, false)};
  for (const Run& run : runs_of(input, rules)) {
    std::vector<Span> spans = spans_of(input, run, pieces, refined, rules);
    for (std::size_t i = 0; i < spans.size(); ++i) layout.spans[run.points[i]] = std::move(spans[i]);
    if (!run.closed) layout.corner[run.points.front()] = layout.corner[run.points.back()] = true;
  }
  return layout;
}

Report report_of(const Layout& layout) {
  Report report{.outcome = Outcome::converged};
  long clc = 0, unsolved = 0, lacking = 0;
  for (const Span& span : layout.spans) {
    report.iterations = std::max(report.iterations, span.iterations);
    report.residual = std::max(report.residual, span.residual);
    clc += span.clc ? 1 : 0;
    lacking += span.lacks_property ? 1 : 0;
    unsolved += span.claimed == Continuity::g0 ? 1 : 0;
  }
  report.counters = {{"clc_spans", clc}, {"spans_missing_property", lacking}, {"unsolved_spans", unsolved}};
  if (unsolved > 0) {
    report.outcome = Outcome::not_converged;
    report.message =
        fmt::format("no three arcs were found for {} of {} spans; they are straight", unsolved, layout.spans.size());
  }
  return report;
}

bool is_line(const Segment& segment) {
  return static_cast<const ClothoidSegment&>(segment).form().curvature == 0.0 &&
         static_cast<const ClothoidSegment&>(segment).form().curvature_rate == 0.0;
}

/// The published rules accept lines and aligned points that are a little off.
bool lets_kinks_pass(const Parameters& parameters) {
  return parameters.flag("compat") || parameters.text("pieces") == "clc";
}

/// The curve with no more claimed at its joints than is true: at all of them, or at those of lines, for data that are
/// straight to rounding are made so.
Curve as_found(const Curve& curve, bool at_all_joints) {
  std::vector<Joint> joints = curve.joints();
  for (Joint& joint : joints) {
    const Segment &before = curve.segment(joint.segment), &after = curve.segment(curve.next(joint.segment));
    if (joint.claimed == Continuity::g2 && (at_all_joints || is_line(before) || is_line(after)))
      joint.claimed = claim_found(before, after, joint.claimed);
  }
  return {curve.segments(), std::move(joints), curve.nodes(), curve.closed()};
}

}  // namespace

Clothoid3::Clothoid3(const Parameters& parameters) : Scheme(described(parameters), parameters) {}

Fit Clothoid3::solve(const Input& input) const {
  const bool g1 = parameters().text("curvature") == "g1";
  const Rules rules = parameters().flag("compat") ? published_rules(g1) : relative_rules(mean_chord(input), g1);
  const Pieces pieces = parameters().text("pieces") == "clc" ? Pieces::clc : Pieces::three_arcs;
  const Layout layout = layout_of(input, pieces, parameters().flag("refine"), rules);

  std::vector<SpanPieces> spans;
  for (std::size_t i = 0; i < layout.spans.size(); ++i) {
    const std::size_t next = (i + 1) % layout.spans.size(), end = (i + 1) % input.points.size();
    std::vector<SegmentPtr> segments;
    for (const ClothoidForm& piece : layout.spans[i].pieces)
      segments.push_back(std::make_shared<ClothoidSegment>(piece));
    const bool kept = !layout.corner[end] && layout.spans[i].claimed == Continuity::g2 &&
                      layout.spans[next].claimed == Continuity::g2;
    spans.push_back(
        {.segments = std::move(segments), .inside = Continuity::g2, .at_end = kept ? Continuity::g2 : Continuity::g0});
  }
  const Curve curve = curve_of_spans(std::move(spans), input.closed);
  return {.input = input, .curve = as_found(curve, lets_kinks_pass(parameters())), .report = report_of(layout)};
}

void register_clothoid3(Registry& registry) { registry.add<Clothoid3>(); }

}  // namespace kappabench
