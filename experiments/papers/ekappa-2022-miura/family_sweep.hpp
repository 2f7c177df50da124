#pragma once

#include <optional>
#include <string>
#include <vector>

#include "datasets/drawing.hpp"
#include "datasets/random_points.hpp"
#include "experiments/run/cell.hpp"
#include "experiments/run/experiment.hpp"

namespace kappabench {

// Fits of many curves by one scheme of the kappa family, counted in one cell. The curves themselves are not kept:
// random inputs come back from their seeds, drawings from their files.

/// What |kappa| does where a curve passes a point, judged by the slope of |kappa| on both sides of it and by
/// nothing that the scheme says. `sides` is how far to step, as a part of the way to the segment's ends.
enum class AtPoint { peak, valley, passes };
[[nodiscard]] AtPoint curvature_at(const Curve& curve, const Node& node, double sides = 0.05);

/// Columns of a sweep's cell (CellRecord::measurements). All counts but `a`:
/// "a"; "curves", "converged", "unsupported", "straight" (all points on one line: no curvature to speak of);
/// over the curves that converged and are not straight: "points" other than the ends of open curves, "pinned", "at
/// inflection" and "minima" by the scheme's report, "peaks", "valleys" and "neither" by curvature_at, "pinned peaks":
/// pinned points where |kappa| nevertheless has a peak at the joint. A sweep over drawings has "points of ID", "pinned
/// of ID", "at inflection of ID" and "minima of ID" besides.

/// An open and a closed curve of a random family for each entry of `sizes`; sizes may come several times.
[[nodiscard]] CellJob random_sweep_job(RandomKind kind, const SchemePtr& scheme, std::uint64_t seed,
                                       const std::vector<int>& sizes);

/// All curves of the drawings.
[[nodiscard]] CellJob drawings_sweep_job(std::string dataset, const std::vector<Drawing>& drawings,
                                         const SchemePtr& scheme);

/// For every scheme a sweep over the built-in drawings ("drawings"; curves of at most 100 points) and one over each
/// random family, 3 to 50 points (trigonometric basis: to 15). If the context names datasets, a sweep over each of
/// them instead: "random:uneven:n=12,count=1000" makes a family of its own.
[[nodiscard]] std::vector<CellJob> sweep_jobs(const Context& context, const std::vector<SchemePtr>& schemes);

/// The schemes that the context asks for; by default ekappa with a from 2/3 to 0.95 and ekappa-trig from 0.5 to 0.9.
[[nodiscard]] std::vector<SchemePtr> sharpness_ladder(const Context& context);

}  // namespace kappabench
