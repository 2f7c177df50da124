#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/run/experiment.hpp"
#include "experiments/study/findings.hpp"
#include "experiments/study/study.hpp"
#include "experiments/study/verdicts.hpp"

namespace kappabench::wang {

/// What the experiments on the figures and tables of Wang et al. 2024 share, besides what those on every
/// paper do.

inline constexpr std::string_view paper = "pkappa-2024-wang";

[[nodiscard]] store::ClaimRecord claim(std::string_view id, std::string verdict, std::string ours,
                                       std::string evidence);

/// The scheme with these options: "mode=global,continuity=c1", or "" for the defaults.
[[nodiscard]] SchemePtr pkappa(const Registry& registry, std::string_view options);

/// The built-in drawing.
[[nodiscard]] Drawing drawing(std::string_view id);

/// The drawing scaled so that the mean chord of its first curve is `chord`: the energies have units.
[[nodiscard]] Drawing scaled_to(Drawing drawing, double chord);
[[nodiscard]] Input scaled_to(Input input, double chord);

/// Random input number `index` of n points and mean chord 1: walks, stars, zigzags and spirals in turn.
[[nodiscard]] Input random_curve(std::uint64_t seed, int index, int n, bool closed);

/// The node inside every segment.
[[nodiscard]] std::vector<Node> inner_nodes(const Curve& curve);

/// E_p of every segment, 1/length: Eq. (3) for the best parabola with its vertex at the segment's point. Infinite at a
/// cusp.
[[nodiscard]] std::vector<double> parabola_energies(const Curve& curve);

/// What stage 1 minimises with weights 0.1, summed over the segments (Eqs. (3) to (6)), with `unit` as the length 1.
[[nodiscard]] double first_stage_energy(const Curve& curve, double unit);

/// Are the two Bézier segments the same bit for bit?
[[nodiscard]] bool same(const Segment& a, const Segment& b);

/// Fits, measures and keeps the parabola of every segment, for `parabola_table`.
[[nodiscard]] CellJob profiled_job(const Drawing& drawing, const SchemePtr& scheme, std::string label,
                                   std::vector<const Metric*> metrics);

/// Curvature and parabola against t + the segment's number from 0, for the cells that profiled_job made, `steps`
/// intervals a segment (a divisor of 64). Columns "curve" (label), "segment + t", "curvature", "parabola",
/// "difference".
[[nodiscard]] study::Table parabola_table(const study::Findings& found, std::string id, const std::vector<int>& cells,
                                          int steps);

/// A graph of parabola_table for a single cell.
[[nodiscard]] study::Panel parabola_panel(std::string title, std::string table, std::string x_label);

/// The same for curvature minus parabola.
[[nodiscard]] study::Panel difference_panel(std::string title, std::string table);

/// A panel of cells in the plane.
[[nodiscard]] store::PanelRecord curve_panel(std::vector<int> cells, std::string title, bool comb);

/// A job over many inputs that keeps numbers only: `measure(index, cell)` is called for every index.
[[nodiscard]] CellJob sweep_job(std::string dataset, const SchemePtr& scheme, std::string_view name, int version,
                                int count, std::function<void(int index, store::CellRecord&)> measure);

/// The cells whose label is this, as indices.
[[nodiscard]] std::vector<int> cells_labelled(const store::ExperimentRecord& record, std::string_view label);

/// Counts of cases that agree, for a verdict.
struct Tally {
  double agree = 0.0, cases = 0.0;
  void add(bool holds) {
    cases += 1.0;
    agree += holds ? 1.0 : 0.0;
  }
};

/// For a statement about what happens often or tends to happen: reproduced from two thirds of the cases, contradicted
/// below half.
[[nodiscard]] std::string verdict_often(const Tally& tally);

/// Spearman's rank correlation; equal values share their ranks. NaN for fewer than three pairs or constant values.
[[nodiscard]] double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace kappabench::wang
