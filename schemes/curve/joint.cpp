#include "schemes/curve/joint.hpp"

#include <algorithm>
#include <cmath>

#include "schemes/curve/tangents.hpp"

namespace kappabench {

namespace {

JointSide with_errors(const Vec2& position, const Vec2& first, const Vec2& second, const RoundingError& error) {
  const double v = first.norm();
  return {position, first, second, error, first / v, error.first / v};
}

JointSide moving_side_of(const Segment& segment, bool at_end, double known_to) {
  if (const std::span<const Vec2> b = segment.bezier_points(); !b.empty()) {
    const auto degree = static_cast<int>(b.size()) - 1;
    const auto at = [&](std::size_t i) -> const Vec2& { return at_end ? b[b.size() - 1 - i] : b[i]; };
    const double sign = at_end ? -1.0 : 1.0;
    const Vec2 first = sign * degree * (at(1) - at(0));
    const Vec2 second =
        degree > 1 ? Vec2(degree * (degree - 1.0) * ((at(2) - at(1)) - (at(1) - at(0)))) : Vec2(Vec2::Zero());
    return with_errors(at(0), first, second, rounding_error(degree, at(0), known_to));
  }
  const Jet jet = segment.jet(at_end ? 1.0 : 0.0, 2);
  return with_errors(jet.d[0], jet.d[1], jet.d[2], rounding_error(segment, jet.d[0], known_to));
}

JointSide side_of(const Segment& segment, bool at_end, double known_to) {
  JointSide side = moving_side_of(segment, at_end, known_to);
  // Coordinates say nothing of the direction of what is made from angles or axes, however short it is.
  const double rest = segment.bezier_points().empty() ? 0.0 : side.error.first;
  if (side.first.norm() > rest) return side;
  side.tangent = unit_tangent(segment, at_end ? 1.0 : 0.0, at_end ? Side::before : Side::after, side.error.first);
  side.tangent_error = side.error.second / side.second.norm();
  return side;
}

/// Holds `measured` against `allowed`; what is not a number misses.
std::optional<JointMiss> held(JointMiss::Of of, double before, double after, double measured, double allowed) {
  if (measured <= allowed) return std::nullopt;
  return JointMiss{of, before, after, measured, allowed};
}

std::optional<JointMiss> tangent_miss(const JointSide& before, const JointSide& after) {
  const double allowed = std::min(visible_jump, solver_accuracy + before.tangent_error + after.tangent_error);
  const double sine = std::abs(cross(before.tangent, after.tangent)), cosine = before.tangent.dot(after.tangent);
  if (sine <= allowed && cosine > 0.0) return std::nullopt;
  const auto angle = [](const Vec2& d) { return std::atan2(d.y(), d.x()); };
  return JointMiss{JointMiss::Of::tangent, angle(before.tangent), angle(after.tangent), std::atan2(sine, cosine),
                   allowed};
}

std::optional<JointMiss> curvature_miss(const JointSide& before, const JointSide& after, bool signs_too, double chord) {
  const double k0 = before.curvature(), k1 = after.curvature();
  const double scale = std::max({std::abs(k0), std::abs(k1), 1.0 / chord});
  const double allowed =
      std::min(visible_jump * scale, solver_accuracy * scale + before.curvature_error() + after.curvature_error());
  return held(JointMiss::Of::curvature, k0, k1, std::abs(signs_too ? k1 - k0 : std::abs(k1) - std::abs(k0)), allowed);
}

std::optional<JointMiss> derivative_miss(JointMiss::Of of, const Vec2& before, const Vec2& after, double error,
                                         double chord) {
  const double scale = std::max({before.norm(), after.norm(), chord});
  return held(of, 0.0, 0.0, (after - before).norm(), std::min(visible_jump * scale, solver_accuracy * scale + error));
}

}  // namespace

double JointSide::curvature() const {
  const double v = first.norm();
  return cross(first, second) / (v * v * v);
}

double JointSide::curvature_error() const { return kappabench::curvature_error(first, second, error); }

JointSides sides_of(const Segment& before, const Segment& after, double known_to) {
  return {side_of(before, true, known_to), side_of(after, false, known_to)};
}

std::optional<JointMiss> miss_of(const JointSides& sides, Continuity claimed, double chord) {
  using enum Continuity;
  const auto& [before, after] = sides;
  if (auto miss = held(JointMiss::Of::position, 0.0, 0.0, (after.position - before.position).norm(),
                       solver_accuracy * chord + before.error.position + after.error.position))
    return miss;
  if (claimed == g0) return std::nullopt;
  if (auto miss = tangent_miss(before, after)) return miss;
  if (claimed == g1) return std::nullopt;
  if (claimed == c1 || claimed == c2)
    if (auto miss = derivative_miss(JointMiss::Of::first_derivative, before.first, after.first,
                                    before.error.first + after.error.first, chord))
      return miss;
  if (claimed == c1) return std::nullopt;
  if (claimed == c2)
    if (auto miss = derivative_miss(JointMiss::Of::second_derivative, before.second, after.second,
                                    before.error.second + after.error.second, chord))
      return miss;
  return curvature_miss(before, after, claimed != g1_equal_magnitude, chord);
}

bool plainly_keeps(std::span<const Vec2> before, std::span<const Vec2> after, Continuity claimed, double chord) {
  using enum Continuity;
  if (before.empty() || after.empty() || before.back() != after.front()) return false;
  if (claimed == g0) return true;
  const std::size_t m = before.size() - 1;
  const Vec2 a = before[m] - before[m - 1], b = after[1] - after[0];
  const double aa = a.squaredNorm(), bb = b.squaredNorm(), sine = cross(a, b);
  constexpr double tight = solver_accuracy * solver_accuracy;
  constexpr double slow =
      1e-12;  // of the square of the chord: legs that rounding might matter to are looked at closely
  if (!(std::min(aa, bb) > slow * chord * chord && a.dot(b) > 0.0 && sine * sine <= tight * aa * bb)) return false;
  if (claimed == g1) return true;
  if (m < 2 || after.size() < 3) return false;
  const auto degree0 = static_cast<double>(m), degree1 = static_cast<double>(after.size() - 1);
  const Vec2 second0 = degree0 * (degree0 - 1.0) * (a - (before[m - 1] - before[m - 2]));
  const Vec2 second1 = degree1 * (degree1 - 1.0) * ((after[2] - after[1]) - b);
  const double close = tight * chord * chord;
  if ((claimed == c1 || claimed == c2) && !((degree1 * b - degree0 * a).squaredNorm() <= close)) return false;
  if (claimed == c1) return true;
  if (claimed == c2 && !((second1 - second0).squaredNorm() <= close)) return false;
  const double k0 = cross(a, second0) / (degree0 * degree0 * aa * std::sqrt(aa));
  const double k1 = cross(b, second1) / (degree1 * degree1 * bb * std::sqrt(bb));
  const double jump = claimed == g1_equal_magnitude ? std::abs(k1) - std::abs(k0) : k1 - k0;
  return std::abs(jump) <= solver_accuracy * std::max(std::abs(k0), 1.0 / chord);
}

}  // namespace kappabench
