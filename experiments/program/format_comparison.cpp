#include "experiments/program/format_comparison.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/across/compare.hpp"
#include "reports/tables.hpp"

namespace kappabench {

namespace {

std::string table_json(const store::TableRecord& table) {
  auto rows = nlohmann::ordered_json::array();
  const auto length = [](const auto& cells) { return cells.size(); };
  const std::size_t count = table.columns.empty() ? 0 : std::visit(length, table.columns.front().cells);
  for (std::size_t i = 0; i < count; ++i) {
    nlohmann::ordered_json row;
    for (const store::TableColumn& column : table.columns)
      std::visit([&](const auto& cells) { row[column.name] = cells[i]; }, column.cells);
    rows.push_back(std::move(row));
  }
  return rows.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

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

std::string formatted(const store::TableRecord& table, std::string_view format) {
  if (format == "csv") return to_csv(table);
  if (format == "json") return table_json(table);
  return format == "latex" ? to_latex(table) : to_text(table);
}

}  // namespace

std::string formatted_comparison(const store::ExperimentRecord& experiment, std::string_view format, bool all_columns) {
  const auto table = std::ranges::find(experiment.tables, compare_table_id, &store::TableRecord::id);
  const bool page = format == "table" || format == "latex";
  return formatted(page && !all_columns ? narrow(*table) : *table, format);
}

}  // namespace kappabench
