#pragma once

#include <optional>

#include "schemes/segments/g1_clothoid.hpp"

namespace kappabench::euler_spiral {

/// A curvature times the chord, and its derivatives by the headings at both ends of the span.
struct EndCurvature {
  double value, by_start, by_end;
};

/// One clothoid over a chord, and its curvature where it starts and ends.
struct Span {
  G1Clothoid clothoid;
  EndCurvature at_start, at_end;
};

/// With headings against the chord, radians. nullopt where they are over 5/4 pi, or 2 pi or more apart: the length
/// grows beyond all bounds towards 2 pi (g1_clothoid).
[[nodiscard]] std::optional<Span> span_between(double start, double end);

}  // namespace kappabench::euler_spiral
