#include "schemes/intrinsic/chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include "schemes/intrinsic/fixed_knots.hpp"
#include "schemes/numerics/bracketed_newton.hpp"

namespace kappabench::intrinsic {

namespace {

double direction(const Vec2& v) { return std::atan2(v.y(), v.x()); }

std::optional<double> given_heading(const Input& input, std::size_t i) {
  return input.options_of(static_cast<int>(i)).tangent;
}

/// Open ends that are not given make the end angles of their span equal; of two points the chord's direction.
void set_end_headings(const Input& input, std::vector<double>& heading) {
  const std::size_t n = input.points.size();
  const auto set = [&](std::size_t end, std::size_t inner) {
    if (given_heading(input, end)) return;
    const double chord =
        direction(end > inner ? input.points[end] - input.points[inner] : input.points[inner] - input.points[end]);
    heading[end] = n == 2 && !given_heading(input, inner) ? chord : 2.0 * chord - heading[inner];
  };
  set(0, 1);
  set(n - 1, n - 2);
}

}  // namespace

std::vector<double> headings_of(const Input& input, HeadingRule rule) {
  const std::size_t n = input.points.size();
  std::vector<double> heading(n);
  const auto leg = [&](std::size_t i) -> Vec2 { return input.points[(i + 1) % n] - input.points[i % n]; };
  for (std::size_t i = input.closed ? 0 : 1; i < (input.closed ? n : n - 1); ++i) {
    const Vec2 before = leg(i + n - 1), after = leg(i);
    // Inversion at the point sends the circle to a line. The same direction has the parabola in chord lengths.
    heading[i] = rule == HeadingRule::circle ? direction(before / before.squaredNorm() + after / after.squaredNorm())
                                             : direction(before.normalized() + after.normalized());
  }
  for (std::size_t i = 0; i < n; ++i) heading[i] = given_heading(input, i).value_or(heading[i]);
  if (!input.closed) set_end_headings(input, heading);
  return heading;
}

std::vector<HermiteData> spans_with_headings(const Input& input, const std::vector<double>& headings) {
  const std::size_t n = input.points.size();
  const auto end_at = [&](std::size_t i) {
    return CurveEnd{input.points[i], headings[i], input.options_of(static_cast<int>(i)).curvature};
  };
  std::vector<HermiteData> spans;
  for (std::size_t i = 0; i < (input.closed ? n : n - 1); ++i) spans.push_back({end_at(i), end_at((i + 1) % n)});
  return spans;
}

namespace {

/// The curvatures at the ends of the G1 clothoid of a span.
struct ClothoidEnds {
  double start, end;
  [[nodiscard]] bool rising() const { return end > start; }
};

ClothoidEnds clothoid_of(const HermiteData& data) {
  const Solved solved = g1_clothoid(standard_form(data));
  const double chord = (data.to.point - data.from.point).norm();
  return {solved.x / chord, solved.y / chord};
}

std::vector<ClothoidEnds> clothoids_of(const std::vector<HermiteData>& spans) {
  std::vector<ClothoidEnds> ends(spans.size());
  std::ranges::transform(spans, ends.begin(), clothoid_of);
  return ends;
}

double joined(const ClothoidEnds& before, const ClothoidEnds& after) {
  if (before.rising() && !after.rising()) return std::max(before.end, after.start);
  if (!before.rising() && after.rising()) return std::min(before.end, after.start);
  return 0.5 * (before.end + after.start);
}

double of_circle(const Vec2& p0, const Vec2& p1, const Vec2& p2) {
  const Vec2 a = p1 - p0, b = p2 - p1;
  return 2.0 * cross(a, b) / (a.norm() * b.norm() * (p2 - p0).norm());
}

}  // namespace

void relax_headings(const Input& input, std::vector<double>& headings, int rounds) {
  constexpr double largest_turn = 0.3;
  const std::size_t n = input.points.size();
  for (int round = 0; round < rounds; ++round) {
    const std::vector<HermiteData> spans = spans_with_headings(input, headings);
    const std::vector<ClothoidEnds> clothoids = clothoids_of(spans);
    for (std::size_t i = input.closed ? 0 : 1; i < (input.closed ? n : n - 1); ++i) {
      if (given_heading(input, i)) continue;
      const std::size_t before = (i + spans.size() - 1) % spans.size();
      // For small angles the clothoid's end curvatures change by 4 / chord with the heading there.
      const auto stiffness = [&](std::size_t k) { return 4.0 / (spans[k].to.point - spans[k].from.point).norm(); };
      const double turn = (clothoids[i].start - clothoids[before].end) / (stiffness(before) + stiffness(i));
      headings[i] += std::clamp(turn, -largest_turn, largest_turn);
    }
    if (!input.closed) set_end_headings(input, headings);
  }
}

namespace {

HermiteData reversed(const HermiteData& data) {
  const auto turned = [](const CurveEnd& end) {
    return CurveEnd{end.point, end.heading + std::numbers::pi,
                    end.curvature ? std::optional(-*end.curvature) : std::nullopt};
  };
  return {turned(data.to), turned(data.from)};
}

/// An open start whose heading and curvature nobody gave: those of the clothoid that has the next point's curvature
/// there, if there is one that starts within 2.8 rad of the chord, else its curvature alone is estimated.
void finish_start(HermiteData& span, bool heading_given) {
  const Vec2 chord = span.to.point - span.from.point;
  const double towards = direction(chord), wanted = *span.to.curvature;
  // The end curvature falls as the start turns to the right of the chord, by about 2 a radian and chord.
  const auto excess = [&](double angle) -> ValueAndSlope {
    HermiteData tried = span;
    tried.from.heading = towards - angle;
    return {clothoid_of(tried).end - wanted, -2.0 / chord.norm()};
  };
  constexpr double most = 2.8;
  if (!heading_given && !span.from.curvature && excess(-most).value >= 0.0 && excess(most).value <= 0.0)
    span.from.heading = towards - falling_root_in(excess, -most, most, 0.0);
  if (!span.from.curvature) span.from.curvature = clothoid_of(span).start;
}

}  // namespace

void estimate_curvatures(const Input& input, std::vector<HermiteData>& spans, CurvatureRule rule) {
  const std::vector<ClothoidEnds> clothoids = clothoids_of(spans);
  const std::size_t n = spans.size();
  const bool closed = input.closed;
  const auto at_point = [&](std::size_t i) {
    const std::size_t before = (i + n - 1) % n;
    // A span at an open end adapts to its inner neighbour; where both are at ends, the circle joins them.
    const bool starts = !closed && before == 0, ends = !closed && i == n - 1;
    if (rule == CurvatureRule::circle || (starts && ends))
      return of_circle(spans[before].from.point, spans[i].from.point, spans[i].to.point);
    return starts ? clothoids[i].start : ends ? clothoids[before].end : joined(clothoids[before], clothoids[i]);
  };
  for (std::size_t i = closed ? 0 : 1; i < n; ++i)
    if (!spans[i].from.curvature) spans[(i + n - 1) % n].to.curvature = spans[i].from.curvature = at_point(i);
  if (closed) return;
  finish_start(spans.front(), given_heading(input, 0).has_value());
  HermiteData last = reversed(spans.back());
  finish_start(last, given_heading(input, input.points.size() - 1).has_value());
  spans.back() = reversed(last);
}

namespace {

double variation(const StandardCurve& curve) {
  double sum = 0.0;
  for (std::size_t i = 1; i < curve.controls.size(); ++i) sum += std::abs(curve.controls[i] - curve.controls[i - 1]);
  return sum;
}

/// A fit and what its curvature does.
struct Judged {
  HermiteFit fit;
  Verdict verdict;
};

/// Fewest extrema over all p, then least variation; nullopt if no p has a solution.
std::optional<Judged> on_fixed_knots(const StandardData& data, Settings settings) {
  settings.automatic = false;
  std::optional<Judged> best;
  std::pair<int, double> best_cost;
  for (const double p : {0.0, 0.5, -0.5, 1.0, -1.0}) {
    settings.p = p;
    HermiteFit tried = solve(data, settings);
    if (tried.outcome != Outcome::converged) continue;
    const Verdict verdict = verdict_of(*tried.curve);
    const std::pair cost{verdict.extrema, variation(*tried.curve)};
    if (best && cost >= best_cost) continue;
    best = Judged{std::move(tried), verdict};
    best_cost = cost;
  }
  return best;
}

}  // namespace

SpanFit fit_span(const HermiteData& data, const Settings& settings, bool may_fall_back) {
  StandardData standard = standard_form(data);
  SpanFit span{solve(standard, settings), Trend::not_monotone, false, true};
  if (span.fit.outcome != Outcome::converged && may_fall_back) {
    span.fell_back = true;
    if (auto fixed = on_fixed_knots(standard, settings)) {
      span.fit = std::move(fixed->fit);
      span.trend = fixed->verdict.trend;
      return span;
    }
    standard.start_curvature = standard.end_curvature = std::nullopt;
    span.fit = solve(standard, settings);
    span.keeps_curvature = false;
  }
  if (span.fit.curve) span.trend = verdict_of(*span.fit.curve).trend;
  return span;
}

}  // namespace kappabench::intrinsic
