#include "schemes/euler_spiral/polygon.hpp"

#include <cmath>
#include <numbers>

namespace kappabench::euler_spiral {

namespace {

using std::numbers::pi;

std::optional<double> given(const Input& input, std::size_t point, double direction) {
  const auto& tangent = input.options_of(static_cast<int>(point)).tangent;
  if (!tangent) return std::nullopt;
  return std::remainder(*tangent - direction, 2.0 * pi);
}

/// The side of a turn is lost in the rounding of the coordinates, of which each leg is a difference.
bool turns_straight_back(const Vec2& before, const Vec2& after, double rounding) {
  return before.dot(after) < 0.0 && std::abs(cross(before, after)) <= 2.0 * rounding * (before.norm() + after.norm());
}

void choose_sides(std::vector<double>& turns, const std::vector<std::size_t>& back) {
  if (back.empty()) return;
  const std::size_t n = turns.size();
  for (const std::size_t k : back) turns[k] = 0.0;
  const std::vector<double> others = turns;
  for (const std::size_t k : back) turns[k] = others[(k + n - 1) % n] + others[(k + 1) % n] < 0.0 ? -pi : pi;
}

}  // namespace

Polygon polygon_of(const Input& input) {
  const std::size_t n = input.points.size(), chords = input.closed ? n : n - 1;
  Polygon polygon{.lengths = {}, .directions = {}, .turns = std::vector<double>(n, 0.0), .closed = input.closed};
  const auto chord = [&](std::size_t k) -> Vec2 { return input.points[(k + 1) % n] - input.points[k]; };
  for (std::size_t k = 0; k < chords; ++k) {
    polygon.lengths.push_back(chord(k).norm());
    polygon.directions.push_back(std::atan2(chord(k).y(), chord(k).x()));
  }
  const double rounding = rounding_of(input);
  std::vector<std::size_t> back;
  for (std::size_t k = input.closed ? 0 : 1; k < chords; ++k) {
    const Vec2 before = chord(polygon.before(k)), after = chord(k);
    polygon.turns[k] = std::atan2(cross(before, after), before.dot(after));
    if (turns_straight_back(before, after, rounding)) back.push_back(k);
  }
  choose_sides(polygon.turns, back);
  if (!input.closed) {
    polygon.start = given(input, 0, polygon.directions.front());
    polygon.end = given(input, n - 1, polygon.directions.back());
  }
  return polygon;
}

Headings circle_headings(const Polygon& polygon) {
  const std::size_t n = polygon.points();
  const std::vector<double>& turns = polygon.turns;
  Headings headings(n, 0.0);
  for (std::size_t k = polygon.closed ? 0 : 1; k < polygon.chords(); ++k) {
    const double before = polygon.lengths[polygon.before(k)], after = polygon.lengths[k];
    // The heading against the leg before is the angle at which that leg is seen from the next point.
    const double to_leg = std::atan2(before * std::sin(turns[k]), after + before * std::cos(turns[k]));
    headings[k] = to_leg - 0.5 * turns[k];
  }
  if (!polygon.closed) {
    headings.front() = polygon.start.value_or(-headings[1] - 0.5 * turns[1]);
    headings.back() = polygon.end.value_or(-headings[n - 2] + 0.5 * turns[n - 2]);
  }
  return headings;
}

}  // namespace kappabench::euler_spiral
