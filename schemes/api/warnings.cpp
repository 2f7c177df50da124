#include "schemes/api/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace kappabench {

namespace {

constexpr double long_span = 3.0;  // chords
constexpr std::size_t samples_a_segment = 33;

/// Slower than this part of the chord per unit of t, the direction is rounding: a cusp at a node.
constexpr double rest = 1e-9;

struct Span {
  const Node& from;
  const Node& to;
};

/// Calls `part(segment, t0, t1)` for what the span has of each of its segments.
template <class Part>
void for_parts(const Curve& curve, const Span& span, Part part) {
  int segment = span.from.segment;
  double t0 = span.from.t;
  // At a joint, two nodes of one place may name either segment; a closed curve goes round once at most.
  for (int steps = 0; steps <= curve.size(); ++steps) {
    const bool last = segment == span.to.segment && (span.to.t >= t0 || steps > 0);
    const double t1 = last ? span.to.t : 1.0;
    if (t1 > t0) part(curve.segment(segment), t0, t1);
    if (last) return;
    segment = curve.next(segment);
    t0 = 0.0;
  }
}

/// All control legs within acos(1/3) of the chord: then the span advances along it everywhere, so that it neither
/// winds nor crosses itself, and its length is below 3 chords.
bool legs_advance(std::span<const Vec2> b, const Vec2& chord) {
  const double squared = chord.squaredNorm();
  bool advance = true;
  for (std::size_t i = 0; i + 1 < b.size(); ++i) {
    const Vec2 leg = b[i + 1] - b[i];
    const double along = leg.dot(chord);
    advance &= along >= 0.0 && long_span * long_span * along * along >= leg.squaredNorm() * squared;
  }
  return advance;
}

bool plainly_tame(const Curve& curve, const Span& span, const Vec2& chord) {
  bool tame = true;
  for_parts(curve, span, [&](const Segment& segment, double, double) {
    const std::span<const Vec2> b = segment.bezier_points();
    tame = tame && !b.empty() && legs_advance(b, chord);
  });
  return tame;
}

/// The same for the commonest span, one Bézier segment from end to end: `to` is its end or the start of the next one.
bool plainly_tame_segment(const Curve& curve, const Span& span) {
  const int segment = span.from.segment;
  const bool whole =
      span.to.segment == segment ? span.to.t == 1.0 : span.to.t == 0.0 && span.to.segment == curve.next(segment);
  if (!whole) return false;
  const std::span<const Vec2> b = curve.segment(segment).bezier_points();
  return !b.empty() && legs_advance(b, b.back() - b.front());
}

struct Wildness {
  double length = 0.0, turning = 0.0;
  bool crosses = false;
};

/// Do the segments pq and rs cross, ends apart?
bool cross_each_other(const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
  const auto side = [](const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); };
  return side(p, q, r) * side(p, q, s) < 0.0 && side(r, s, p) * side(r, s, q) < 0.0;
}

bool crosses_itself(std::span<const Vec2> polygon) {
  for (std::size_t i = 0; i + 3 < polygon.size(); ++i)
    for (std::size_t j = i + 2; j + 1 < polygon.size(); ++j)
      if (cross_each_other(polygon[i], polygon[i + 1], polygon[j], polygon[j + 1])) return true;
  return false;
}

Wildness wildness_of(const Curve& curve, const Span& span, const Vec2& chord) {
  std::vector<Vec2> polygon;
  Wildness wild;
  Vec2 direction = Vec2::Zero();
  for_parts(curve, span, [&](const Segment& segment, double t0, double t1) {
    std::array<double, samples_a_segment> t;
    std::array<Jet, samples_a_segment> jets;
    for (std::size_t i = 0; i < t.size(); ++i)
      t[i] = t0 + (t1 - t0) * static_cast<double>(i) / static_cast<double>(t.size() - 1);
    segment.jets(t, 1, jets);
    for (std::size_t i = 0; i < jets.size(); ++i) {
      const Vec2& velocity = jets[i].d[1];
      if (velocity.squaredNorm() > rest * rest * chord.squaredNorm()) {
        wild.turning += std::abs(std::atan2(cross(direction, velocity), direction.dot(velocity)));
        direction = velocity;
      }
      if (i > 0) wild.length += (jets[i].position() - jets[i - 1].position()).norm();
      polygon.push_back(jets[i].position());
    }
  });
  // A curve that turns by less than pi does not meet itself.
  wild.crosses = wild.turning > std::numbers::pi && crosses_itself(polygon);
  return wild;
}

}  // namespace

std::vector<Warning> warnings_of(const Curve& curve) {
  std::array<Warning, 3> found{{{"long_span", 0, ""}, {"self_crossing_span", 0, ""}, {"winding_span", 0, ""}}};
  const auto note = [](Warning& warning, const std::string& first) {
    if (warning.spans++ == 0) warning.first = first;
  };
  const auto along = [](const Node& a, const Node& b) { return std::pair{a.segment, a.t} < std::pair{b.segment, b.t}; };
  std::vector<Node> sorted;
  if (!std::ranges::is_sorted(curve.nodes(), along)) {
    sorted = curve.nodes();
    std::ranges::stable_sort(sorted, along);
  }
  const std::vector<Node>& nodes = sorted.empty() ? curve.nodes() : sorted;
  const std::size_t spans = curve.closed() ? nodes.size() : std::max<std::size_t>(nodes.size(), 1) - 1;
  for (std::size_t i = 0; i < spans; ++i) {
    const Span span{nodes[i], nodes[i + 1 < nodes.size() ? i + 1 : 0]};
    if (span.from.point == span.to.point) continue;
    if (span.from.t == 0.0 && plainly_tame_segment(curve, span)) continue;
    const Vec2 chord = position_at(curve.segment(span.to.segment), span.to.t) -
                       position_at(curve.segment(span.from.segment), span.from.t);
    if (plainly_tame(curve, span, chord)) continue;
    const Wildness wild = wildness_of(curve, span, chord);
    const std::string place = fmt::format("the span from point {} to {}", span.from.point, span.to.point);
    if (wild.length > long_span * chord.norm())
      note(found[0], fmt::format("{} is {:.3g} times as long as its chord", place, wild.length / chord.norm()));
    if (wild.crosses) note(found[1], fmt::format("{} crosses itself", place));
    if (wild.turning > 2.0 * std::numbers::pi)
      note(found[2], fmt::format("{} turns by {:.0f} degrees", place, wild.turning * 180.0 / std::numbers::pi));
  }
  std::vector<Warning> warnings;
  std::ranges::copy_if(found, std::back_inserter(warnings), [](const Warning& w) { return w.spans > 0; });
  return warnings;
}

}  // namespace kappabench
