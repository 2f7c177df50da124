#pragma once

#include <array>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/experiment.hpp"
#include "metrics/correspondence.hpp"

namespace kappabench::ekappa {

/// What the experiments on the figures of Miura et al. 2022 share.

inline constexpr std::string_view paper = "ekappa-2022-miura";

/// A value of the shape parameter a and how it is written.
struct Shape {
  double a;
  std::string_view words;
};

/// The values of Figs. 3 and 7; with the first the curve is the kappa-curve.
inline constexpr std::array<Shape, 4> figure_shapes{
    {{2.0 / 3.0, "2/3"}, {0.75, "0.75"}, {0.85, "0.85"}, {0.95, "0.95"}}};

[[nodiscard]] SchemePtr cubic(const Registry& registry, double a);
[[nodiscard]] SchemePtr trigonometric(const Registry& registry, double a);

/// The drawings that the context asks for, otherwise the named ones.
[[nodiscard]] std::vector<Drawing> drawings_or(const Context& context, std::initializer_list<std::string_view> names);

/// The same drawing with a = `a` at the points where `chosen(curve, point)`; what it said about a before is dropped.
[[nodiscard]] Drawing with_shape_at(Drawing drawing, double a, const std::function<bool(int, int)>& chosen);

/// A cell to draw: no metrics, a label of our own.
[[nodiscard]] CellJob drawn_job(const Drawing& drawing, const SchemePtr& scheme, std::string label);

/// A drawn cell for each of figure_shapes: "κ-curve" by the scheme `kappa`, then "εκ, a = 0.75", ...
void add_shape_jobs(std::vector<CellJob>& jobs, const Context& context, const Drawing& drawing);
[[nodiscard]] std::string label_of_shape(const Shape& shape);

/// A cell of numbers about one drawing under many parameters: `measure` calls `put`. Raise `version` when its
/// results change. `measure` must depend on the drawing, the registry's schemes and constants of the program alone.
[[nodiscard]] CellJob study_job(const Drawing& drawing, const SchemePtr& scheme, std::string_view name, int version,
                                std::function<void(const Drawing&, store::CellRecord&)> measure);

/// Appends a measurement. A column may come several times: one value for each joint, point, curve, ...
void put(store::CellRecord& cell, std::string column, double value, Method method = Method::exact);

/// All values of a column over all cells, in order; their sum; those of cells of one drawing.
[[nodiscard]] std::vector<double> values(const store::ExperimentRecord& record, std::string_view column);
[[nodiscard]] std::vector<double> values(const store::ExperimentRecord& record, std::string_view column,
                                         std::string_view dataset);
[[nodiscard]] double total(const store::ExperimentRecord& record, std::string_view column);

/// Index of the drawn cell with this label, or nothing.
[[nodiscard]] std::optional<int> drawn_cell(const store::ExperimentRecord& record, std::string_view dataset,
                                            std::string_view label);
/// The drawings that have drawn cells, in order.
[[nodiscard]] std::vector<std::string> drawn_datasets(const store::ExperimentRecord& record);

/// A square window around (x, y), `part` of the size of the cell's curve wide.
[[nodiscard]] std::vector<double> window_at(const store::CurveRecord& curve, double x, double y, double part);

/// |kappa| at a node; NaN where it is not finite.
[[nodiscard]] double curvature_at(const Curve& curve, const Node& node);

/// At most `most` of the numbers 0 ... n - 1, evenly spread.
[[nodiscard]] std::vector<int> evenly(int n, int most);

/// The nodes of points that have a segment of their own: on an open curve not the first and the last.
[[nodiscard]] std::vector<Node> inner_nodes(const Fit& fit);

/// Is the fit one to count? Converged, with a curve.
[[nodiscard]] bool solved(const Fit& fit);

/// The largest of the spans' deviations at each distance 1 ... farthest from the point, in spans: those that meet at
/// the point are at distance 1. NaN where there is no span.
[[nodiscard]] std::vector<double> largest_by_distance(std::span<const Span> spans, std::span<const double> deviations,
                                                      int point, bool closed, int farthest);

/// Share of cases that agree, "1234 of 1240 (99.5 %)".
[[nodiscard]] std::string share(double agree, double cases);

/// For a statement about every case: one counterexample contradicts it; nothing is shown by no case.
[[nodiscard]] std::string verdict_for_all(double counterexamples, double cases);
/// For a statement about what generally happens: reproduced from 95 % of the cases, contradicted below half.
[[nodiscard]] std::string verdict_in_general(double agree, double cases);

[[nodiscard]] store::ClaimRecord claim(std::string_view id, std::string verdict, std::string ours,
                                       std::string evidence);

}  // namespace kappabench::ekappa
