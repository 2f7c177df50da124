#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "experiments/program/errors.hpp"
#include "experiments/program/format_table.hpp"
#include "experiments/program/verbs.hpp"
#include "metrics/statistics.hpp"
#include "reports/store/difference.hpp"
#include "reports/store/hdf5_store.hpp"

namespace kappabench {

namespace {

std::string words(const std::variant<double, std::string>& value) {
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  return std::get<std::string>(value);
}

/// Every change in a row.
store::TableRecord all_changes(const store::Difference& difference) {
  std::vector<std::string> experiment, dataset, scheme, column, before, after;
  std::vector<double> curve, relative;
  for (const store::Change& change : difference.changes) {
    experiment.push_back(change.cell.experiment);
    dataset.push_back(change.cell.dataset);
    scheme.push_back(change.cell.label);
    curve.push_back(change.curve);
    column.push_back(change.column);
    before.push_back(words(change.before));
    after.push_back(words(change.after));
    relative.push_back(relative_change(change));
  }
  return {.id = "changes",
          .title = "Changes",
          .columns = {{.name = "experiment", .cells = experiment},
                      {.name = "dataset", .cells = dataset},
                      {.name = "scheme", .cells = scheme},
                      {.name = "curve", .cells = curve, .whole_numbers = true},
                      {.name = "column", .cells = column},
                      {.name = "before", .cells = before},
                      {.name = "after", .cells = after},
                      {.name = "relative change", .cells = relative}}};
}

/// "overlap[17]" and "overlap[18]" are the same column of a study's rows.
std::string without_row(const std::string& column) { return column.substr(0, column.find('[')); }

/// Changes of one column of one scheme in an experiment, together; the largest with its place.
store::TableRecord summary_of(const store::Difference& difference) {
  std::map<std::tuple<std::string, std::string, std::string>, std::vector<const store::Change*>> groups;
  for (const store::Change& change : difference.changes)
    groups[{change.cell.experiment, change.cell.label, without_row(change.column)}].push_back(&change);
  std::vector<std::string> experiment, scheme, column, where, before, after;
  std::vector<double> count, typical;
  for (const auto& [name, changes] : groups) {
    const store::Change& worst =
        **std::ranges::max_element(changes, {}, [](const auto* c) { return relative_change(*c); });
    std::vector<double> sizes;
    sizes.reserve(changes.size());
    for (const store::Change* change : changes) sizes.push_back(relative_change(*change));
    experiment.push_back(std::get<0>(name));
    scheme.push_back(std::get<1>(name));
    column.push_back(std::get<2>(name));
    count.push_back(static_cast<double>(changes.size()));
    typical.push_back(median(sizes));
    where.push_back(worst.cell.dataset);
    before.push_back(words(worst.before));
    after.push_back(words(worst.after));
  }
  return {.id = "changes",
          .title = "Changes by column",
          .columns = {{.name = "experiment", .cells = experiment},
                      {.name = "scheme", .cells = scheme},
                      {.name = "column", .cells = column},
                      {.name = "changes", .cells = count, .whole_numbers = true},
                      {.name = "median relative change", .cells = typical},
                      {.name = "largest on", .cells = where},
                      {.name = "before", .cells = before},
                      {.name = "after", .cells = after}}};
}

std::string names(const std::vector<store::CellName>& cells, const std::string& file) {
  constexpr std::size_t most = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, cells.size()); ++i)
    text += fmt::format("  only in {}: {}, {}, {}\n", file, cells[i].experiment, cells[i].dataset, cells[i].label);
  if (cells.size() > most) text += fmt::format("  only in {}: {} more cells\n", file, cells.size() - most);
  return text;
}

std::string page(const store::Difference& difference, const DiffArguments& arguments) {
  const std::string before = arguments.before.string(), after = arguments.after.string();
  std::string text = fmt::format("{} cells are in both files and equal, {} changed; {} are only in {}, {} only in {}\n",
                                 difference.equal, difference.changed, difference.only_before.size(), before,
                                 difference.only_after.size(), after);
  text += names(difference.only_before, before) + names(difference.only_after, after);
  for (const store::VerdictChange& verdict : difference.verdicts)
    text +=
        fmt::format("  verdict on {} of {}: {} -> {}\n", verdict.claim, verdict.paper,
                    verdict.before.empty() ? "none" : verdict.before, verdict.after.empty() ? "none" : verdict.after);
  if (!difference.changes.empty()) text += "\n" + format_table(summary_of(difference), "table");
  return text;
}

}  // namespace

int diff_verb(const DiffArguments& arguments) {
  const store::Difference difference =
      store::difference(store::read_results(arguments.before), store::read_results(arguments.after));
  fmt::print("{}", arguments.format == "table" ? page(difference, arguments)
                                               : format_table(all_changes(difference), arguments.format));
  return success;
}

}  // namespace kappabench
