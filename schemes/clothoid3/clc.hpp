#pragma once

#include <optional>
#include <vector>

#include "schemes/clothoid3/hermite.hpp"
#include "schemes/clothoid3/rules.hpp"

namespace kappabench::clothoid3 {

/// Clothoid, line, clothoid: curvature falls to 0 from the first point, and grows to that of the second one. The line
/// is the chord between the two inner ends, and need not have their heading.
struct ClothoidLineClothoid {
  std::vector<ClothoidForm> pieces;  ///< a clothoid that is too short to count is left out
  double misalignment;               ///< sine of the angle between the line and the clothoids' inner ends
};

/// Sine of the largest kink that is let pass (the published constant).
inline constexpr double allowed_misalignment = 1e-2;

/// The best of 32 headings of the line, improved by halving steps and, with rules of our own, by solving for a line
/// without kink where one is near. Neither curvature may be 0. nullopt if the line would run backwards for every
/// heading.
[[nodiscard]] std::optional<ClothoidLineClothoid> clothoid_line_clothoid(const CurveElement& from,
                                                                         const CurveElement& to, const Rules& rules);

}  // namespace kappabench::clothoid3
