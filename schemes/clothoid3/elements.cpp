#include "schemes/clothoid3/elements.hpp"

#include <cmath>
#include <optional>

#include "schemes/clothoid3/local_conic.hpp"
#include "schemes/segments/g1_clothoid.hpp"

namespace kappabench::clothoid3 {

namespace {

double direction(const Vec2& from, const Vec2& to) { return std::atan2(to.y() - from.y(), to.x() - from.x()); }

/// A run's points with neighbours: those of an open end are the two next ones on the other side.
class Neighbourhoods {
 public:
  Neighbourhoods(const Input& input, const Run& run) : input_(input), run_(run) {}

  [[nodiscard]] std::size_t size() const { return run_.points.size(); }
  [[nodiscard]] const Vec2& point(std::size_t i) const { return input_.points[run_.points[i % size()]]; }
  [[nodiscard]] Place place(std::size_t i) const {
    if (run_.closed) return Place::middle;
    return i == 0 ? Place::start : i + 1 == size() ? Place::end : Place::middle;
  }
  /// The first of the three points of the conic at point i.
  [[nodiscard]] std::size_t first(std::size_t i) const {
    const Place where = place(i);
    return where == Place::start ? i : where == Place::end ? i - 2 : (i + size() - 1) % size();
  }

 private:
  const Input& input_;
  const Run& run_;
};

/// 1 where the polygon turns left, -1 right, 0 straight; ends of open runs like their neighbours.
std::vector<int> turns(const Neighbourhoods& points, const Rules& rules) {
  const std::size_t n = points.size();
  std::vector<int> turn(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    if (points.place(i) != Place::middle) continue;
    const Vec2 before = points.point(i) - points.point(i + n - 1), after = points.point(i + 1) - points.point(i);
    const double sine = cross(before, after) / (before.norm() * after.norm());
    if (std::abs(sine) >= rules.aligned_sine) turn[i] = sine > 0.0 ? 1 : -1;
  }
  for (const std::size_t i : {std::size_t{0}, n - 1})
    if (points.place(i) != Place::middle) turn[i] = turn[i == 0 ? 1 : n - 2];
  return turn;
}

/// The heading where the legs are aligned. The published rule takes one leg; else it is that of the line through
/// the neighbours, the same from both sides.
double aligned_heading(const Neighbourhoods& points, const std::vector<int>& turn, std::size_t i, const Rules& rules) {
  const std::size_t n = points.size(), a = points.first(i);
  const Place place = points.place(i);
  if (place == Place::start) return direction(points.point(a), points.point(a + 1));
  if (place == Place::end) return direction(points.point(a + 1), points.point(a + 2));
  if (!rules.compat) return direction(points.point(a), points.point(i + 1));
  if (turn[(i + n - 1) % n] == 0) return direction(points.point(a), points.point(i));
  return direction(points.point(i), points.point(i + 1));
}

/// Curvature from the single clothoids to both neighbours: the mean of what they have at the point. nullopt where they
/// disagree in sign with each other or with the turning.
std::optional<double> clothoid_curvature(const std::optional<ClothoidForm>& before,
                                         const std::optional<ClothoidForm>& after, int turn) {
  if (!before || !after) return std::nullopt;
  const double left = before->curvature + before->curvature_rate * before->length, right = after->curvature;
  const double mean = 0.5 * (left + right);
  if (left * right < 0.0 || mean * turn < 0.0) return std::nullopt;
  return mean;
}

void take_clothoid_curvatures(const Neighbourhoods& points, bool closed, std::vector<PointElement>& elements) {
  const std::size_t n = elements.size();
  std::vector<std::optional<ClothoidForm>> clothoids;
  for (std::size_t i = 0; i < (closed ? n : n - 1); ++i) {
    const CurveElement &from = elements[i].at, &to = elements[(i + 1) % n].at;
    clothoids.push_back(g1_clothoid(from.point, from.heading, to.point, to.heading));
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (points.place(i) != Place::middle || elements[i].turn == 0) continue;
    const auto mean = clothoid_curvature(clothoids[(i + n - 1) % n], clothoids[i], elements[i].turn);
    if (mean) elements[i].at.curvature = *mean;
  }
}

}  // namespace

std::vector<PointElement> elements_of(const Input& input, const Run& run, const Rules& rules) {
  const Neighbourhoods points(input, run);
  const std::size_t n = points.size();
  const std::vector<int> turn = turns(points, rules);
  std::vector<PointElement> elements;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = points.first(i);
    const G2Data data =
        turn[i] == 0 ? G2Data{aligned_heading(points, turn, i, rules), 0.0}
                     : local_conic(points.point(a), points.point(a + 1), points.point(a + 2), points.place(i), rules);
    elements.push_back({{points.point(i), data.heading, data.curvature}, turn[i], false});
  }
  if (rules.g1_curvature) take_clothoid_curvatures(points, run.closed, elements);

  for (std::size_t i = 0; i < n; ++i) {
    const PointOptions& options = input.options_of(static_cast<int>(run.points[i]));
    if (options.tangent) elements[i].at.heading = *options.tangent;
    if (options.curvature) elements[i].at.curvature = *options.curvature;
    elements[i].given_curvature = options.curvature.has_value();
  }
  return elements;
}

}  // namespace kappabench::clothoid3
