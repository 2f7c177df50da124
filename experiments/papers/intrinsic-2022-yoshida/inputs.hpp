#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "schemes/intrinsic/hermite_data.hpp"

namespace kappabench::yoshida {

/// Random Hermite conditions with a chord of 1. Each depends on its arguments alone.

/// Angles that Yoshida 2022 looks at, 0 < theta_e < theta_d - theta_e < pi / 2, and any up to 0.95 pi against the
/// chord.
enum class Angles { ordinary, any };
[[nodiscard]] std::string_view name(Angles angles);
[[nodiscard]] Angles angles_named(std::string_view name);

[[nodiscard]] intrinsic::StandardData random_angles(Angles angles, std::uint64_t seed, std::uint64_t index);

/// What is hard about G2 data. All of them are viable: xi - 1 is log-uniform in [1e-3, 1e3] and X / Y in [1e-2, 1e2]
/// (schemes/intrinsic/viable_region.hpp) unless the kind says otherwise.
enum class Kind {
  ordinary,        ///< the angles of the paper
  inflection,      ///< those, with end curvatures of opposite signs
  s_shape,         ///< the chord's angles at the ends have opposite signs
  mirrored,        ///< falling curvature
  near_symmetric,  ///< end angles that differ by 1e-6 to 1e-2 rad: nearly a circular arc
  wide,            ///< angles up to 0.95 pi
  near_border,     ///< xi - 1 in [1e-9, 1e-3]: nearly a step of curvature
  deep             ///< xi in [1e3, 1e6]
};
inline constexpr std::array<Kind, 8> all_kinds{
    Kind::ordinary,       Kind::inflection, Kind::s_shape,     Kind::mirrored,
    Kind::near_symmetric, Kind::wide,       Kind::near_border, Kind::deep};
[[nodiscard]] std::string_view name(Kind kind);
[[nodiscard]] Kind kind_named(std::string_view name);

[[nodiscard]] intrinsic::StandardData random_viable(Kind kind, std::uint64_t seed, std::uint64_t index);

/// Data that are not viable, with the angles of the paper or any: circles that do not nest, xi in [1e-3, 1), or an end
/// curvature on the wrong side of the circle through both points.
[[nodiscard]] intrinsic::StandardData random_infeasible(std::uint64_t seed, std::uint64_t index);

/// A curve with rising control curvatures that turns by less than 3 rad, and the data of its ends: viable by
/// construction. Scaled so that its chord is 1.
struct Spiral {
  intrinsic::StandardCurve curve;
  intrinsic::StandardData data;
};
[[nodiscard]] Spiral random_spiral(std::uint64_t seed, std::uint64_t index);

}  // namespace kappabench::yoshida
