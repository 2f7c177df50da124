#pragma once

#include <vector>

#include "datasets/curves/given_curves.hpp"
#include "experiments/run/cell.hpp"
#include "experiments/study/quantity.hpp"

namespace kappabench::study {

/// What a cell of given curves says of each point: how far the curve passes from it.
namespace given {
inline const Key curve{"curve"}, point{"point"};
inline const Quantity distance{"distance", "length", Method::sampled};
inline const Quantity distance_over_chord{"distance_over_mean_chord", "1", Method::sampled};
}  // namespace given

/// As fit_job, of a curve that was made elsewhere, or of any other scheme by its fits. A given curve is not fitted: its
/// cell has no time, none of the metrics that fit again, and a row for each point with its distance from the curve.
[[nodiscard]] CellJob measure_job(const Drawing& drawing, const SchemePtr& scheme, std::vector<const Metric*> metrics);

}  // namespace kappabench::study
