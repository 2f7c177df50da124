#pragma once

#include <optional>

#include "schemes/curve/exact_curvature.hpp"

namespace kappabench {

/// Polynomial, rational and trigonometric segments: all are planar control polygons.
struct ControlPolygon {
  std::vector<Vec2> points;
  bool trigonometric = false;
  std::vector<double> weights{};  ///< of a rational segment, positive; else none

  [[nodiscard]] bool finite() const;
};

/// nullopt for other segments.
[[nodiscard]] std::optional<ControlPolygon> control_polygon(const ExactForm& form);

/// Extrema (`of_slope`) and sign changes of the curvature.
[[nodiscard]] SignChanges polygon_sign_changes(const ControlPolygon& polygon, bool of_slope);

/// Local minima of the speed that may be a cusp: ascending, none where the speed surely stays above 1e-8 of its mean.
[[nodiscard]] std::vector<RootBracket> polygon_slow_places(const ControlPolygon& polygon);

}  // namespace kappabench
