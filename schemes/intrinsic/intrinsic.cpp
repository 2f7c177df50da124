#include "schemes/intrinsic/intrinsic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "schemes/numerics/sine_cosine.hpp"
#include "schemes/segments/intrinsic.hpp"
#include "schemes/segments/spans.hpp"
#include "schemes/segments/three_point_arcs.hpp"

namespace kappabench {

using namespace intrinsic;

SchemeInfo Intrinsic::describe() {
  return {
      .id = "intrinsic",
      .title = "B-spline curvature over arc length",
      .citation =
          "Yoshida and Saito, Intrinsically defined planar curves based on explicit B-spline curvature "
          "functions, Computer-Aided Design and Applications 19(1), 2022",
      .parameters = {{.name = "continuity",
                      .default_value = std::string("g2"),
                      .help = "g1: each span with as little bending as its headings allow; g2: one curvature a point",
                      .choices = {"g1", "g2"}},
                     {.name = "auto",
                      .default_value = true,
                      .help = "between two curvatures the monotone family with its own knots, where the data allow it"},
                     {.name = "degree",
                      .default_value = 3L,
                      .help = "of the curvature, where auto has no part",
                      .least = 1,
                      .most = 9},
                     {.name = "controls",
                      .default_value = 6L,
                      .help = "control curvatures of a span, equal knots; more than the degree",
                      .least = 2,
                      .most = 100},
                     {.name = "knots",
                      .default_value = std::string(""),
                      .help = "t1/t2/... in [0, 1], controls + degree - 1 of them, clamped; instead of controls"},
                     {.name = "p",
                      .default_value = 0.0,
                      .help = "inner controls between the unknown ones: 0 linear, 1 as the first, -1 as the last",
                      .least = -1.0,
                      .most = 1.0},
                     {.name = "solver",
                      .default_value = std::string("newton"),
                      .help = "simplex: the published downhill simplex, on fixed knots",
                      .choices = {"newton", "simplex"}},
                     {.name = "tangent",
                      .default_value = std::string("circle"),
                      .help = "heading at a point: of the circle through it and its neighbours, or between the legs",
                      .choices = {"circle", "bisector"}},
                     {.name = "rounds",
                      .default_value = 3L,
                      .help = "how often headings give way to the curvatures around them",
                      .least = 0,
                      .most = 100},
                     {.name = "curvature",
                      .default_value = std::string("clothoid"),
                      .help = "at a point: from the clothoids of both spans, or of the circle",
                      .choices = {"clothoid", "circle"}}},
      .traits = {.fewest_open_points = 2, .continuity = Continuity::g2, .locality = 6, .hermite = true},
      .version = 2,
      .libraries = {{"xsimd", xsimd_version()}}};
}

namespace {

BSplineBasis basis_of(const Parameters& parameters) {
  const int degree = static_cast<int>(parameters.integer("degree"));
  const std::string& text = parameters.text("knots");
  if (text.empty()) {
    const int controls = static_cast<int>(parameters.integer("controls"));
    if (controls <= degree)
      throw std::invalid_argument(fmt::format("intrinsic: controls={} must be more than degree={}", controls, degree));
    return uniform_basis(degree, controls);
  }
  BSplineBasis basis{degree, {}};
  const char *at = text.data(), *const end = text.data() + text.size();
  while (true) {
    double knot = 0.0;
    const auto [after, error] = std::from_chars(at, end, knot);
    if (error != std::errc{} || (after != end && *after != '/'))
      throw std::invalid_argument(
          fmt::format("intrinsic: knots: \"{}\" is not a number; write 0/0/0/0.5/1/1/1", std::string(at, end)));
    basis.knots.push_back(knot);
    if (after == end) break;
    at = after + 1;
  }
  if (const std::string reason = reason_ill_formed(basis); !reason.empty())
    throw std::invalid_argument("intrinsic: knots: " + reason);
  return basis;
}

/// Of these parameters.
SchemeInfo described(const Parameters& parameters) {
  SchemeInfo info = Intrinsic::describe();
  SchemeTraits& traits = info.traits;
  const bool g2 = parameters.text("continuity") == "g2";
  if (!g2) traits.continuity = Continuity::g1;
  // Span i depends on the headings of its points, these on their neighbours; and curvatures on the spans around.
  traits.locality = g2 && parameters.text("curvature") == "clothoid" ? 3 : 2;
  traits.locality += static_cast<int>(parameters.integer("rounds"));
  // Eq. (11) draws controls to one end, and knots may lie nearer to one.
  const BSplineBasis basis = basis_of(parameters);
  const std::size_t n = basis.knots.size();
  for (std::size_t i = 0; i < n; ++i)
    if (std::abs(basis.knots[i] + basis.knots[n - 1 - i] - 1.0) > 1e-15) traits.reversal_invariant = false;
  if (parameters.real("p") != 0.0 || parameters.text("solver") == "simplex") traits.reversal_invariant = false;
  return info;
}

}  // namespace

Intrinsic::Intrinsic(const Parameters& parameters)
    : Scheme(described(parameters), parameters),
      settings_{.automatic = parameters.flag("auto"),
                .basis = basis_of(parameters),
                .p = parameters.real("p"),
                .method = parameters.text("solver") == "simplex" ? Method::simplex : Method::newton},
      estimates_{
          .heading = parameters.text("tangent") == "circle" ? HeadingRule::circle : HeadingRule::bisector,
          .rounds = static_cast<int>(parameters.integer("rounds")),
          .curvature = parameters.text("curvature") == "circle" ? CurvatureRule::circle : CurvatureRule::clothoid},
      g2_(parameters.text("continuity") == "g2") {}

namespace {

std::string reason_folded(const Input& input) {
  const int n = input.size();
  const auto point = [&](int i) { return input.points[static_cast<std::size_t>((i + n) % n)]; };
  for (int i = input.closed ? 0 : 1; i < (input.closed ? n : n - 1); ++i)
    if (!input.options_of(i).tangent && folds_back(point(i - 1), point(i), point(i + 1)))
      return fmt::format(
          "the legs at point {} turn straight back, so that it has no direction; give its tangent or move a "
          "point off the line",
          i);
  return "";
}

/// Said where the user gave both curvatures and they have no monotone solution.
constexpr std::string_view what_else_meets_it =
    "; the scheme clothoid3 meets such data by three clothoids, auto=false on fixed knots";

/// The worst of the spans' outcomes, and what they count.
Report report_of(const std::vector<SpanFit>& spans) {
  Report report{.outcome = Outcome::converged};
  long not_monotone = 0, fallen_back = 0, missed = 0, without_curvature = 0;
  for (const SpanFit& span : spans) {
    report.iterations += span.fit.iterations;
    report.residual = std::max(report.residual, span.fit.residual);
    not_monotone += span.trend == Trend::not_monotone ? 1 : 0;
    fallen_back += span.fell_back ? 1 : 0;
    missed += span.fit.outcome == Outcome::converged ? 0 : 1;
    without_curvature += span.keeps_curvature ? 0 : 1;
  }
  report.counters = {{"spans_not_monotone", not_monotone}, {"spans_fallen_back", fallen_back}};
  if (missed == 0 && without_curvature == 0) return report;
  report.outcome = Outcome::not_converged;
  report.message =
      missed > 0
          ? fmt::format("{} of {} spans miss their end, by up to {:.3g} chords", missed, spans.size(), report.residual)
          : fmt::format("{} of {} spans have no solution with the curvature at their ends and are G1",
                        without_curvature, spans.size());
  return report;
}

}  // namespace

Fit Intrinsic::solve(const Input& input) const {
  const auto without_curve = [&](Outcome outcome, std::string message) {
    return Fit{input, std::nullopt, {.outcome = outcome, .message = std::move(message)}};
  };
  if (std::string reason = reason_folded(input); !reason.empty())
    return without_curve(Outcome::unsupported_input, std::move(reason));
  std::vector<double> headings = headings_of(input, estimates_.heading);
  relax_headings(input, headings, estimates_.rounds);
  std::vector<HermiteData> data = spans_with_headings(input, headings);
  if (!g2_)
    for (HermiteData& span : data) span.from.curvature = span.to.curvature = std::nullopt;
  const std::vector<HermiteData> given = data;
  // Two points have nothing that a curvature could be estimated from: what is not given stays free.
  if (g2_ && data.size() > 1) estimate_curvatures(input, data, estimates_.curvature);

  std::vector<SpanFit> spans;
  for (std::size_t i = 0; i < data.size(); ++i) {
    // What the user gave whole is met or refused.
    const bool prescribed = given[i].from.curvature && given[i].to.curvature;
    spans.push_back(fit_span(data[i], settings_, !prescribed));
    const HermiteFit& fit = spans.back().fit;
    if (!fit.curve)
      return without_curve(fit.outcome, fmt::format("from point {} to {}: {}{}", i, (i + 1) % input.points.size(),
                                                    fit.message, prescribed ? what_else_meets_it : ""));
  }
  const Continuity claimed = info().traits.continuity;
  std::vector<SpanPieces> pieces;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const bool kept = spans[i].keeps_curvature && spans[(i + 1) % data.size()].keeps_curvature;
    pieces.push_back({.segments = {std::make_shared<IntrinsicSegment>(placed(*spans[i].fit.curve, data[i]))},
                      .inside = claimed,
                      .at_end = kept ? claimed : Continuity::g1});
  }
  return {.input = input, .curve = curve_of_spans(std::move(pieces), input.closed), .report = report_of(spans)};
}

void register_intrinsic(Registry& registry) { registry.add<Intrinsic>(); }

}  // namespace kappabench
