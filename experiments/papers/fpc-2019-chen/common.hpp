#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/run/experiment.hpp"
#include "experiments/study/study.hpp"
#include "experiments/study/verdicts.hpp"

namespace kappabench::fpc {

/// What the experiments on the figures of Chen et al. 2019 share, besides what those on every paper do.

inline constexpr std::string_view paper = "fpc-2019-chen";

[[nodiscard]] store::ClaimRecord claim(std::string_view id, std::string verdict, std::string ours,
                                       std::string evidence);

/// The typed drawings of the gallery: stand-ins for Figs. 1 and 8.
[[nodiscard]] const std::vector<std::string_view>& gallery();

/// The gallery's drawings, or those that the context asks for.
[[nodiscard]] std::vector<Drawing> gallery_or(const Context& context);

/// A panel that shows one cell in the plane.
[[nodiscard]] store::PanelRecord curve_panel(int cell, std::string title, bool comb = false);

/// The loops of a drawing's first curve by the metric `features`, and how many of them close at a point. A cell of -1
/// says that there is no such curve.
struct Loops {
  int cell = -1;
  double points = 0.0, loops = 0.0, at_points = 0.0;
};
[[nodiscard]] Loops loops_of(const store::ExperimentRecord& record, std::string_view dataset, std::string_view scheme);

/// How many of the points are of a type.
[[nodiscard]] int count_of(const Input& input, PointType type);

/// Arc length of one segment between two parameters, to about 1e-6 of it.
[[nodiscard]] double length_between(const Segment& segment, double from, double to);

/// The parameters at which the curve passes point `point`: two for a loop.
[[nodiscard]] std::vector<Node> nodes_of(const Curve& curve, int point);

/// A cell of numbers about many random inputs: `measure` puts what it likes for each index from 0 to inputs - 1. Raise
/// `version` when its results change; `name` must tell the seed.
[[nodiscard]] CellJob random_job(const SchemePtr& scheme, std::string_view name, int version, int inputs,
                                 std::function<void(std::uint64_t index, store::CellRecord&)> measure);

}  // namespace kappabench::fpc
