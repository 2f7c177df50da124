#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/run/experiment.hpp"
#include "experiments/study/findings.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/table.hpp"
#include "schemes/api/fit.hpp"
#include "schemes/intrinsic/hermite_data.hpp"
#include "schemes/intrinsic/solve.hpp"

namespace kappabench::yoshida {

/// What the experiments on the figures of Yoshida and Saito 2022 share, besides what those on every paper do.

inline constexpr std::string_view paper = "intrinsic-2022-yoshida";

/// Angles of Figs. 6 to 8, and of Fig. 5 (there the caption lacks the factor pi).
[[nodiscard]] intrinsic::StandardData angles_of_figure_6();
[[nodiscard]] intrinsic::StandardData angles_of_figure_5();

/// A stand-in for the conditions of Figs. 3 and 9, which the paper does not print: curvature rises from next to
/// nothing.
[[nodiscard]] intrinsic::StandardData condition_of_figure_3();

/// The data with curvatures at both ends, times the chord.
[[nodiscard]] intrinsic::StandardData with_curvatures(intrinsic::StandardData angles, double start, double end);

/// The standard form as the paper draws it: the start at the origin, its tangent along the x axis, a chord of 1.
[[nodiscard]] intrinsic::HermiteData placed_at_origin(const intrinsic::StandardData& data);

/// What the previous methods fix before they solve: knots and p, Fig. 6(a) to (e).
struct FixedFamily {
  std::string_view title;
  BSplineBasis basis;
  double p;

  [[nodiscard]] intrinsic::Settings settings() const;
};
[[nodiscard]] const std::vector<FixedFamily>& families_of_figure_6();

/// The settings of a family by its title; "automatic" is the one that moves its knots.
inline constexpr std::string_view automatic = "automatic";
[[nodiscard]] intrinsic::Settings settings_of(std::string_view family);

/// Does the curvature of a converged fit rise from end to end? The curvature function is looked at, span by span:
/// rising controls are enough, but not needed. Differences below 1e-12 of the largest curvature are rounding.
[[nodiscard]] bool rises(const intrinsic::HermiteFit& fit);
/// The same for either direction, or constant curvature.
[[nodiscard]] bool monotone(const intrinsic::HermiteFit& fit);

/// How many of each an experiment computes, which a plan can change: datasets = ["random-g1:n=100000"]. Returns the
/// numbers in the order of `defaults`; throws std::invalid_argument for a name that is not among them.
struct Amount {
  std::string_view name;
  long n;
};
[[nodiscard]] std::vector<long> amounts(const Context& context, std::string_view experiment,
                                        const std::vector<Amount>& defaults);

/// Cells of at most 5000 each: [from, to).
[[nodiscard]] std::vector<std::pair<long, long>> parts_of(long n);

// ---- cells

/// A solution as the fit of two points, drawn as the paper does.
[[nodiscard]] Fit as_fit(const intrinsic::StandardData& data, const intrinsic::HermiteFit& solution);

/// The label of the control curvatures of a drawn curve.
inline constexpr std::string_view controls_label = "control curvatures (square), knots (tick)";

/// What the two cells of a drawn curve keep of it.
void keep_curve(const Scheme& scheme, const Fit& fit, store::CellRecord& cell);
void keep_controls(const Fit& fit, store::CellRecord& cell);

/// Two more cells: the curve that `Make` makes of its Uses and nothing else, labelled `label`, and its control
/// curvatures over their Greville abscissae with a tick for every knot: marks for panels of curvature. All segments
/// have B-spline curvature.
template <Fit (*Make)(const Uses&)>
// NOLINTNEXTLINE(performance-unnecessary-value-param): both are moved from
void draw(std::vector<CellJob>& jobs, Uses uses, const std::string& dataset, std::string label = "curve") {
  Uses marks = uses;
  marks.work += ", control curvatures";
  jobs.push_back({.dataset = dataset,
                  .label = std::move(label),
                  .uses = std::move(uses),
                  .compute = [](const Uses& used, store::CellRecord& cell) {
                    keep_curve(*used.schemes.front(), Make(used), cell);
                  }});
  jobs.push_back({.dataset = dataset,
                  .label = std::string(controls_label),
                  .uses = std::move(marks),
                  .compute = [](const Uses& used, store::CellRecord& cell) { keep_controls(Make(used), cell); }});
}

/// The curve with its comb, and its curvature with control curvatures; nothing to draw adds no panel. Each drawn
/// dataset has one curve.
void add_curve_panel(store::FigureRecord& figure, const study::Findings& found, std::string_view dataset,
                     std::string title);
void add_curvature_panel(store::FigureRecord& figure, const study::Findings& found, std::string_view dataset,
                         std::string title);

/// A row for every drawn curve of one segment: outcome, steps, gap, length over chord, end curvatures times the chord.
[[nodiscard]] study::Table drawn_table(const study::Findings& found);

}  // namespace kappabench::yoshida
