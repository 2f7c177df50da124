#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/run/experiment.hpp"
#include "experiments/study/findings.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/study.hpp"
#include "experiments/study/verdicts.hpp"
#include "schemes/api/fit.hpp"
#include "schemes/intrinsic/hermite_data.hpp"
#include "schemes/intrinsic/solve.hpp"

namespace kappabench::yoshida {

/// What the experiments on the figures of Yoshida and Saito 2022 share, besides what those on every paper do.

inline constexpr std::string_view paper = "intrinsic-2022-yoshida";

[[nodiscard]] store::ClaimRecord claim(std::string_view id, std::string verdict, std::string ours,
                                       std::string evidence);

/// Angles of Figs. 6 to 8, and of Fig. 5 (there the caption lacks the factor pi).
[[nodiscard]] intrinsic::StandardData angles_of_figure_6();
[[nodiscard]] intrinsic::StandardData angles_of_figure_5();

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

// ---- cells

/// A cell of numbers: `measure` puts what it likes. `what` names all that its results depend on; raise `version` when
/// they change.
[[nodiscard]] CellJob numbers_job(const SchemePtr& scheme, std::string dataset, std::string_view what, int version,
                                  std::function<void(store::CellRecord&)> measure);

/// A solution as the fit of two points, drawn as the paper does.
[[nodiscard]] Fit as_fit(const intrinsic::StandardData& data, const intrinsic::HermiteFit& solution);

/// Two cells: the curve, labelled `label`, and its control curvatures over their Greville abscissae with a tick for
/// every knot, labelled `controls_label`: marks for panels of curvature. All its segments have B-spline curvature.
[[nodiscard]] std::vector<CellJob> drawn_jobs(const SchemePtr& scheme, const std::string& dataset,
                                              const std::string& label, int version, std::function<Fit()> make);
inline constexpr std::string_view controls_label = "control curvatures (square), knots (tick)";

/// What the two cells keep of a fit.
void keep_curve(const Scheme& scheme, const Fit& fit, store::CellRecord& cell);
void keep_controls(const Fit& fit, store::CellRecord& cell);

/// The two cells of the curve that `Make` makes of its Uses and nothing else.
template <Fit (*Make)(const Uses&)>
[[nodiscard]] std::vector<CellJob> drawn_jobs(Uses uses, const std::string& dataset, const std::string& label) {
  Uses marks = uses;
  marks.work += ", control curvatures";
  return {{.dataset = dataset,
           .label = label,
           .uses = std::move(uses),
           .compute = [](const Uses& used,
                         store::CellRecord& cell) { keep_curve(*used.schemes.front(), Make(used), cell); }},
          {.dataset = dataset,
           .label = std::string(controls_label),
           .uses = std::move(marks),
           .compute = [](const Uses& used, store::CellRecord& cell) { keep_controls(Make(used), cell); }}};
}

/// Index of the cell with the curve of a dataset, and of that with its control curvatures, or nothing.
[[nodiscard]] std::optional<int> curve_of(const store::ExperimentRecord& record, std::string_view dataset);
[[nodiscard]] std::optional<int> controls_of(const store::ExperimentRecord& record, std::string_view dataset);

/// The curve with its comb, and its curvature with control curvatures; nothing to draw adds no panel. Each drawn
/// dataset has one curve.
void add_curve_panel(store::FigureRecord& figure, const store::ExperimentRecord& record, std::string_view dataset,
                     std::string title);
void add_curvature_panel(store::FigureRecord& figure, const store::ExperimentRecord& record, std::string_view dataset,
                         std::string title);

void add_curve_panel(store::FigureRecord& figure, const study::Findings& found, std::string_view dataset,
                     std::string title);
void add_curvature_panel(store::FigureRecord& figure, const study::Findings& found, std::string_view dataset,
                         std::string title);

/// A row for every drawn curve of one segment: outcome, steps, gap, length over chord, end curvatures times the chord.
[[nodiscard]] store::TableRecord drawn_table(const store::ExperimentRecord& record);
[[nodiscard]] study::Table drawn_table(const study::Findings& found);

}  // namespace kappabench::yoshida
