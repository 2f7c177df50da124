#include "experiments/program/format_table.hpp"

#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

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

}  // namespace

std::string format_table(const store::TableRecord& table, std::string_view format) {
  if (format == "csv") return to_csv(table);
  if (format == "json") return table_json(table);
  return format == "latex" ? to_latex(table) : to_text(table);
}

}  // namespace kappabench
