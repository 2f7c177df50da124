#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "experiments/across/compare.hpp"
#include "experiments/program/draw_report.hpp"
#include "experiments/program/errors.hpp"
#include "experiments/program/run_with_bar.hpp"
#include "experiments/program/scratch_folder.hpp"
#include "experiments/program/verbs.hpp"
#include "reports/tables.hpp"

namespace kappabench {

namespace {

namespace fs = std::filesystem;

/// "--schemes kappa,ekappa:a=0.8,iteration=published,catmull-rom" split at its commas: an item "key=value" without a
/// colon goes on with the parameters of the scheme before it.
std::vector<std::string> join_parameters(const std::vector<std::string>& items) {
  std::vector<std::string> schemes;
  for (const std::string& item : items) {
    const bool continues = item.find('=') != std::string::npos && item.find(':') == std::string::npos;
    if (continues && !schemes.empty())
      schemes.back() += "," + item;
    else
      schemes.push_back(item);
  }
  return schemes;
}

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

std::string formatted(const store::TableRecord& table, const std::string& format) {
  if (format == "csv") return to_csv(table);
  if (format == "json") return table_json(table);
  return format == "latex" ? to_latex(table) : to_text(table);
}

}  // namespace

int compare(const Registry& registry, const CompareArguments& arguments) {
  Plan plan;
  plan.experiments.push_back({.id = "compare",
                              .schemes = join_parameters(arguments.schemes),
                              .datasets = arguments.points,
                              .metrics = arguments.metrics});
  const bool keep = !arguments.output.empty();
  const ScratchFolder scratch;
  if (keep) fs::create_directories(arguments.output);
  const fs::path results = (keep ? arguments.output : scratch.path()) / "results.h5";
  const RunSummary summary = run_with_bar(registry, plan, {.results = results, .processes = arguments.processes});

  const store::ExperimentRecord& experiment = summary.results.experiments.front();
  const auto table = std::ranges::find(experiment.tables, compare_table_id, &store::TableRecord::id);
  const bool page = arguments.format == "table" || arguments.format == "latex";
  fmt::print("{}", formatted(page && arguments.metrics.empty() ? narrow(*table) : *table, arguments.format));
  if (keep) draw_report(summary.results, arguments.output);
  return summary.lost == 0 ? success : ran_and_failed;
}

}  // namespace kappabench
