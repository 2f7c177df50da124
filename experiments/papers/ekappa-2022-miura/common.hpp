#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/run/experiment.hpp"
#include "experiments/study/quantity.hpp"

namespace kappabench::miura {

/// What the experiments on the figures of Miura et al. 2022 share, besides what those on every paper do.

inline constexpr std::string_view paper = "ekappa-2022-miura";

/// A value of the shape parameter a and how it is written.
struct Shape {
  double a;
  std::string_view words;
};

/// The values of Figs. 3 and 7; with the first the curve is the kappa-curve.
inline constexpr std::array<Shape, 4> figure_shapes{
    {{2.0 / 3.0, "2/3"}, {0.75, "0.75"}, {0.85, "0.85"}, {0.95, "0.95"}}};

/// What tells rows apart: the a, as in Shape::words, and the place in a drawing.
inline const study::Key shape_key{"a"}, curve_key{"curve"}, point_key{"point"}, joint_key{"joint"};

[[nodiscard]] SchemePtr cubic(const Registry& registry, double a);
[[nodiscard]] SchemePtr trigonometric(const Registry& registry, double a);
/// `cubic` at each of figure_shapes.
[[nodiscard]] std::vector<SchemePtr> figure_schemes(const Registry& registry);

/// The same drawing with a = `a` at the points where `chosen(curve, point)`; what it said about a before is dropped.
[[nodiscard]] Drawing with_shape_at(Drawing drawing, double a, const std::function<bool(int, int)>& chosen);

/// A drawn cell for each of figure_shapes: "κ-curve" by the scheme `kappa`, then "εκ, a = 0.75", ...
void add_shape_jobs(std::vector<CellJob>& jobs, const Context& context, const Drawing& drawing);
[[nodiscard]] std::string label_of_shape(const Shape& shape);

/// A square window around (x, y), `part` of the size of the cell's curve wide.
[[nodiscard]] std::vector<double> window_at(const store::CurveRecord& curve, double x, double y, double part);

/// |kappa| at a node; NaN where it is not finite.
[[nodiscard]] double curvature_at(const Curve& curve, const Node& node);

/// At most `most` of the numbers 0 ... n - 1, evenly spread.
[[nodiscard]] std::vector<int> evenly(int n, int most);

/// The numbers without NaNs.
[[nodiscard]] std::vector<double> defined(std::vector<double> numbers);

/// The nodes of points that have a segment of their own: on an open curve not the first and the last.
[[nodiscard]] std::vector<Node> inner_nodes(const Fit& fit);

}  // namespace kappabench::miura
