#pragma once

#include <string_view>

#include "experiments/experiment.hpp"

namespace kappabench {

/// The table with one row for every curve and scheme, which the verb `compare` prints.
inline constexpr std::string_view compare_table_id = "compare";

/// All schemes on all drawings, all metrics.
[[nodiscard]] Experiment compare_experiment();

/// Drawings and metrics that a context asks for; the defaults if it asks for none. Shared by experiments.
[[nodiscard]] std::vector<Drawing> drawings_of(const Context& context);
[[nodiscard]] std::vector<const Metric*> metrics_of(const Context& context);

}  // namespace kappabench
