#pragma once

#include <string>
#include <string_view>

#include "reports/store/model.hpp"

namespace kappabench {

/// What the verbs `compare` and `measure` print: the table of curves and schemes of a concluded experiment `compare`,
/// as table, csv, json or latex. A table for people has one column of each kind, unless `all_columns`.
[[nodiscard]] std::string formatted_comparison(const store::ExperimentRecord& experiment, std::string_view format,
                                               bool all_columns);

}  // namespace kappabench
