#include "experiments/papers/intrinsic-2022-yoshida/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "datasets/random_source.hpp"
#include "schemes/segments/intrinsic.hpp"

namespace kappabench::yoshida {

using namespace intrinsic;
using std::numbers::pi;

namespace {

constexpr double widest = 0.95 * pi;

RandomSource source(std::uint64_t seed, std::uint64_t index) {
  return RandomSource(seed * 0x9e3779b97f4a7c15ULL + index);
}

StandardData of_angles(double chord_angle, double end_angle) { return {chord_angle, chord_angle + end_angle, {}, {}}; }

StandardData paper_angles(RandomSource& random) {
  const double chord_angle = random.uniform(0.0, 0.5 * pi);
  return of_angles(chord_angle, random.uniform(chord_angle, 0.5 * pi));
}

StandardData any_angles(RandomSource& random) {
  const double chord_angle = random.uniform(-widest, widest);
  return of_angles(chord_angle, random.uniform(-widest, widest));
}

/// Angles that want a rising curvature.
StandardData rising_angles(Kind kind, RandomSource& random) {
  switch (kind) {
    case Kind::s_shape: {
      const double chord_angle = -random.uniform(0.05, 0.5 * pi);
      return of_angles(chord_angle, random.uniform(0.05, 0.5 * pi));
    }
    case Kind::near_symmetric: {
      const double chord_angle = random.uniform(0.05, 0.5 * pi);
      return of_angles(chord_angle, chord_angle + random.log_uniform(1e-6, 1e-2));
    }
    case Kind::wide: {
      const double one = random.uniform(-widest, widest), other = random.uniform(-widest, widest);
      return of_angles(std::min(one, other), std::max(one, other));
    }
    default:
      return paper_angles(random);
  }
}

/// End curvatures by where they are in the region: xi and X / Y.
StandardData placed_in_region(const StandardData& angles, double xi, double ratio) {
  const double half = std::sin(0.5 * (angles.turning - 2.0 * angles.chord_angle));
  const double product = xi * 4.0 * half * half;
  StandardData data = angles;
  data.start_curvature = 2.0 * std::sin(angles.chord_angle) - std::sqrt(product * ratio);
  data.end_curvature = 2.0 * std::sin(angles.end_angle()) + std::sqrt(product / ratio);
  return data;
}

}  // namespace

std::string_view name(Angles angles) {
  return angles == Angles::ordinary ? "0 < theta_e < theta_d - theta_e < pi/2" : "up to 0.95 pi";
}

Angles angles_named(std::string_view words) { return words == name(Angles::ordinary) ? Angles::ordinary : Angles::any; }

StandardData random_angles(Angles angles, std::uint64_t seed, std::uint64_t index) {
  RandomSource random = source(seed, index);
  return angles == Angles::ordinary ? paper_angles(random) : any_angles(random);
}

std::string_view name(Kind kind) {
  switch (kind) {
    case Kind::ordinary:
      return "the paper's angles";
    case Kind::inflection:
      return "inflection";
    case Kind::s_shape:
      return "S-shape";
    case Kind::mirrored:
      return "mirrored";
    case Kind::near_symmetric:
      return "nearly symmetric";
    case Kind::wide:
      return "angles to 0.95 pi";
    case Kind::near_border:
      return "near the border";
    case Kind::deep:
      return "deep inside";
  }
  return "";
}

Kind kind_named(std::string_view words) {
  return *std::ranges::find_if(all_kinds, [words](Kind kind) { return name(kind) == words; });
}

StandardData random_viable(Kind kind, std::uint64_t seed, std::uint64_t index) {
  RandomSource random = source(seed, index);
  const StandardData angles = rising_angles(kind, random);
  const double xi = kind == Kind::near_border ? 1.0 + random.log_uniform(1e-9, 1e-3)
                    : kind == Kind::deep      ? random.log_uniform(1e3, 1e6)
                                              : 1.0 + random.log_uniform(1e-3, 1e3);
  StandardData data = placed_in_region(angles, xi, random.log_uniform(1e-2, 1e2));
  if (kind == Kind::inflection && *data.start_curvature > 0.0) {
    // X grows, and xi with it: the data stay viable.
    data.start_curvature = -random.log_uniform(1e-2, 10.0);
  }
  return kind == Kind::mirrored ? mirrored(data) : data;
}

StandardData random_infeasible(std::uint64_t seed, std::uint64_t index) {
  RandomSource random = source(seed, index);
  const StandardData angles = rising_angles(index % 2 == 0 ? Kind::ordinary : Kind::wide, random);
  const double ratio = random.log_uniform(1e-1, 1e1);
  if (index % 3 < 2) return placed_in_region(angles, random.log_uniform(1e-3, 1.0), ratio);
  // Mirrored in the circle through both points: X or Y is negative.
  StandardData data = placed_in_region(angles, random.log_uniform(1e-1, 1e2), ratio);
  if (index % 2 == 0)
    data.start_curvature = 4.0 * std::sin(angles.chord_angle) - *data.start_curvature;
  else
    data.end_curvature = 4.0 * std::sin(angles.end_angle()) - *data.end_curvature;
  return data;
}

Spiral random_spiral(std::uint64_t seed, std::uint64_t index) {
  RandomSource random = source(seed, index);
  std::vector<double> controls{random.uniform(-2.0, 2.0)};
  for (int i = 1; i < 6; ++i) controls.push_back(controls.back() + random.log_uniform(1e-2, 2.0));
  Spiral spiral{{uniform_basis(3, 6), std::move(controls), 1.0}, {}};
  std::vector<double>& k = spiral.curve.controls;
  const std::vector<double> integrals = basis_integrals(spiral.curve.basis);
  double absolute = 0.0;
  for (std::size_t i = 0; i < k.size(); ++i) absolute += std::abs(k[i]) * integrals[i];
  spiral.curve.length = random.uniform(0.1, 3.0) / absolute;
  const double turning = spiral.curve.length * std::inner_product(k.begin(), k.end(), integrals.begin(), 0.0);
  const IntrinsicSegment segment(
      {Vec2::Zero(), 0.0, spiral.curve.length, spiral.curve.basis.degree, spiral.curve.basis.knots, k});
  const Vec2 end = segment.jet(1.0, 0).position();
  const double chord = end.norm();
  spiral.curve.length /= chord;
  for (double& value : k) value *= chord;
  spiral.data = {std::atan2(end.y(), end.x()), turning, k.front(), k.back()};
  return spiral;
}

}  // namespace kappabench::yoshida
