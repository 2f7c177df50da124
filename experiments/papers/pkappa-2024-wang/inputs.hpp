#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "datasets/drawing.hpp"

namespace kappabench::wang {

/// Points for the experiments: built-in drawings, scaled because the energies have units, and random curves.

/// The built-in drawing.
[[nodiscard]] Drawing drawing(std::string_view id);

/// A drawing of one curve.
[[nodiscard]] Drawing drawing_of(std::string id, Input input);

/// The drawing scaled so that the mean chord of its first curve is `chord`.
[[nodiscard]] Drawing scaled_to(Drawing drawing, double chord);
[[nodiscard]] Input scaled_to(Input input, double chord);

/// Random input number `index` of n points and mean chord 1: walks, stars, zigzags and spirals in turn.
[[nodiscard]] Input random_curve(std::uint64_t seed, int index, int n, bool closed);

}  // namespace kappabench::wang
