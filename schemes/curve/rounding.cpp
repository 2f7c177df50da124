#include "schemes/curve/rounding.hpp"

#include <algorithm>
#include <limits>

namespace kappabench {

RoundingError rounding_error(int degree, const Vec2& position, double known_to) {
  constexpr double roundings = 2.0;  // a coordinate that was solved for and stored has been rounded a few times
  constexpr double last_place = std::numeric_limits<double>::epsilon();
  const double error = roundings * std::max(known_to, last_place * position.cwiseAbs().maxCoeff());
  // Sums of two and of four control points times degree and degree (degree - 1).
  return {error, 2.0 * degree * error, 4.0 * degree * (degree - 1) * error};
}

RoundingError rounding_error(const Segment& segment, const Vec2& position, double known_to) {
  const auto points = static_cast<int>(segment.bezier_points().size());
  return rounding_error(points > 0 ? points - 1 : 3, position, known_to);
}

double curvature_error(const Vec2& first, const Vec2& second, const RoundingError& error) {
  const double v = first.norm(), a = second.norm();
  return (error.second + error.first * 4.0 * a / v) / (v * v);
}

}  // namespace kappabench
