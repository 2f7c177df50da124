#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "experiments/across/compare.hpp"
#include "experiments/study/given_job.hpp"
#include "experiments/study/measured.hpp"

namespace kappabench::comparison {
namespace {

using study::Findings, study::Table, study::TableValue;

/// Columns in the order of the metrics, as far as any curve has them. From the cells, not from today's metrics: results
/// may be older.
std::vector<Column> columns_of(const Findings& found) {
  std::vector<Column> columns;
  for (const store::CellRecord& cell : found.cells())
    for (const store::CurveRecord& curve : cell.curves) {
      if (curve.measurements.size() <= columns.size()) continue;
      columns.clear();
      for (const store::MeasurementRecord& m : curve.measurements) columns.push_back({m.column, m.unit, {}});
    }
  return columns;
}

/// What a scheme did over all curves.
struct Totals {
  int curves = 0, converged = 0, not_converged = 0, unsupported = 0, lost = 0, wild = 0;
  long pinned = 0, at_inflection = 0;
  std::size_t points = 0;
  std::vector<double> iterations{};
  std::map<std::string, std::vector<double>> values{};

  void add(const store::CurveRecord& curve, const std::vector<Column>& columns) {
    ++curves;
    points += curve.point_x.size();
    const bool unsupported_here = curve.outcome == name(Outcome::unsupported_input);
    ++(unsupported_here                                ? unsupported
       : curve.outcome == name(Outcome::converged)     ? converged
       : curve.outcome == name(Outcome::not_converged) ? not_converged
                                                       : lost);
    if (unsupported_here) return;
    wild += curve.warnings.empty() ? 0 : 1;
    pinned += counted(curve, "pinned");
    at_inflection += counted(curve, "at_inflection");
    iterations.push_back(curve.iterations);
    for (const Column& column : columns)
      if (const auto value = measured(curve, column)) values[column.name].push_back(*value);
  }
};

std::vector<std::pair<std::string, Totals>> totals_by_scheme(const Findings& found,
                                                             const std::vector<Column>& columns) {
  std::vector<std::pair<std::string, Totals>> totals;
  for (const store::CellRecord& cell : found.cells()) {
    auto scheme = std::ranges::find(totals, cell.label, &std::pair<std::string, Totals>::first);
    if (scheme == totals.end()) scheme = totals.insert(totals.end(), {cell.label, {}});
    if (cell.curves.empty()) ++scheme->second.lost;
    for (const store::CurveRecord& curve : cell.curves) scheme->second.add(curve, columns);
  }
  return totals;
}

}  // namespace

Table curve_table(const Findings& found) {
  Table table(std::string(compare_table_id), "Every curve, every scheme",
              "One row a curve and scheme. The methods (exact, enclosed, sampled) are in the results file.");
  table.words("dataset")
      .counts("curve")
      .words("scheme")
      .counts("points")
      .words("outcome")
      .words("warnings")
      .counts("iterations");
  table.numbers("residual").counts("pinned").counts("at_inflection");
  const std::vector<Column> columns = columns_of(found);
  for (const Column& column : columns) table.numbers(column.name, column.unit);
  for (const store::CellRecord& cell : found.cells())
    for (std::size_t i = 0; i < cell.curves.size(); ++i) {
      const store::CurveRecord& curve = cell.curves[i];
      std::vector<TableValue> row{cell.dataset,
                                  i,
                                  cell.label,
                                  curve.point_x.size(),
                                  curve.outcome,
                                  store::warning_words(curve),
                                  curve.iterations,
                                  curve.residual,
                                  counted(curve, "pinned"),
                                  counted(curve, "at_inflection")};
      for (const Column& column : columns) row.emplace_back(measured(curve, column).value_or(undefined));
      table.row(row);
    }
  return table;
}

Table scheme_table(const Findings& found) {
  Table table("schemes", "Each scheme over all curves",
              "Counts of curves by outcome and of points that are pinned or at an inflection; medians over the curves "
              "that have the metric.");
  table.words("scheme").counts("curves").counts("converged").counts("not converged").counts("unsupported");
  table.counts("lost")
      .counts("with warnings")
      .counts("points")
      .counts("pinned")
      .counts("at_inflection")
      .numbers("median iterations");
  const std::vector<Column> columns = columns_of(found);
  for (const Column& column : columns) table.numbers("median " + column.name, column.unit);
  for (auto& [label, of] : totals_by_scheme(found, columns)) {
    std::vector<TableValue> row{label,   of.curves, of.converged, of.not_converged, of.unsupported,       of.lost,
                                of.wild, of.points, of.pinned,    of.at_inflection, median(of.iterations)};
    for (const Column& column : columns) row.emplace_back(median(of.values[column.name]));
    table.row(row);
  }
  return table;
}

std::optional<Table> distance_table(const Findings& found) {
  namespace given = study::given;
  Table table("distances", "Curves made elsewhere: distance from each point",
              "How far each curve passes from the points that it is judged against.");
  table.words("dataset").words("scheme").counts("curve").counts("point");
  table.numbers(given::distance.name, given::distance.unit);
  table.numbers(given::distance_over_chord.name, given::distance_over_chord.unit);
  const study::Rows rows =
      found.rows().where_row([](const study::Row& row) { return row.has(given::distance_over_chord); });
  if (rows.empty()) return std::nullopt;
  const auto word = [](const study::KeyValue& value) { return std::get<std::string>(value); };
  const auto number = [](const study::KeyValue& value) { return std::get<double>(value); };
  for (const study::Row* row : rows)
    table.row({word((*row)[study::key::dataset]), word((*row)[study::key::label]), number((*row)[given::curve]),
               number((*row)[given::point]), (*row)[given::distance], (*row)[given::distance_over_chord]});
  return table;
}

}  // namespace kappabench::comparison
