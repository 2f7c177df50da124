#pragma once

#include <span>

#include "schemes/curve/vec.hpp"

namespace kappabench {

/// A clothoid by its shape: curvature k0 + k1 s over s in [-1/2, 1/2], for unit length, as libspiro gives it.
struct SpiroBend {
  double k0, k1;
};

/// Bends that are almost those of a spline of continuous heading and curvature, made to be so to rounding, as far as
/// Newton's method can within a few steps: libspiro stops at jumps of about 1e-8. The open ends stay circular
/// arcs (k1 = 0). `chords[i]` is what bend i spans; bend i meets bend i + 1, and the last one the first if `closed`.
void polish(std::span<SpiroBend> bends, std::span<const Vec2> chords, bool closed);

}  // namespace kappabench
