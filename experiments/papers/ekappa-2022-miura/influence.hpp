#pragma once

#include <set>

#include "experiments/study/findings.hpp"

namespace kappabench::miura {

/// How far along the curve one point is felt: one a set to `raised_a` where the others are the curve's, and one point
/// moved. Part of the experiment ekappa-local-shape.

inline constexpr double kappa_a = 2.0 / 3.0, raised_a = 0.85;

/// The input with a = `raised_a` at these points; what it said about single points before is dropped.
[[nodiscard]] Input with_raised(Input input, const std::set<int>& points);

[[nodiscard]] CellJob influence_job(const Registry& registry, const Drawing& drawing);
[[nodiscard]] study::Table influence_table(const study::Findings& found);
[[nodiscard]] store::FigureRecord influence_figure();
void claim_influence(study::Findings& found);

}  // namespace kappabench::miura
