#include "experiments/program/format_comparison.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "experiments/across/compare.hpp"
#include "experiments/program/format_table.hpp"

namespace kappabench {

namespace {

/// A terminal and a page are narrow: unless the user chose metrics, one column of each kind.
store::TableRecord narrow(store::TableRecord table) {
  constexpr std::array<std::string_view, 11> headline{"dataset",
                                                      "curve",
                                                      "scheme",
                                                      "outcome",
                                                      "warnings",
                                                      "iterations",
                                                      "residual",
                                                      "pinned",
                                                      "parabola_energy_centred_scaled_mean",
                                                      "curvature_extrema",
                                                      "continuity_curvature_jump_all"};
  std::erase_if(table.columns, [&](const store::TableColumn& column) {
    return std::ranges::find(headline, column.name) == headline.end();
  });
  return table;
}

}  // namespace

std::string formatted_comparison(const store::ExperimentRecord& experiment, std::string_view format, bool all_columns) {
  const auto table = std::ranges::find(experiment.tables, compare_table_id, &store::TableRecord::id);
  const bool page = format == "table" || format == "latex";
  return format_table(page && !all_columns ? narrow(*table) : *table, format);
}

}  // namespace kappabench
