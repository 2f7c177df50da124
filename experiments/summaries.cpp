#include "experiments/summaries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace kappabench {

namespace {

std::optional<double> find_in(const std::vector<store::MeasurementRecord>& measurements, std::string_view column) {
  const auto found = std::ranges::find(measurements, column, &store::MeasurementRecord::column);
  if (found == measurements.end()) return std::nullopt;
  return found->value;
}

std::vector<double> without_nan(std::span<const double> values) {
  std::vector<double> kept;
  std::ranges::copy_if(values, std::back_inserter(kept), [](double v) { return !std::isnan(v); });
  return kept;
}

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::optional<double> measured(const store::CurveRecord& curve, std::string_view column) {
  return find_in(curve.measurements, column);
}

std::optional<double> measured(const store::CellRecord& cell, std::string_view column) {
  return find_in(cell.measurements, column);
}

long counted(const store::CurveRecord& curve, const std::string& counter) {
  const auto found = curve.counters.find(counter);
  return found == curve.counters.end() ? 0 : found->second;
}

double median(std::vector<double> values) {
  values = without_nan(values);
  if (values.empty()) return undefined;
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double mean(std::span<const double> values) {
  const std::vector<double> kept = without_nan(values);
  double sum = 0.0;
  for (const double v : kept) sum += v;
  return kept.empty() ? undefined : sum / static_cast<double>(kept.size());
}

double largest(std::span<const double> values) {
  const std::vector<double> kept = without_nan(values);
  return kept.empty() ? undefined : *std::ranges::max_element(kept);
}

TableBuilder::TableBuilder(std::string id, std::string title, std::string caption) {
  table_.id = std::move(id);
  table_.title = std::move(title);
  table_.caption = std::move(caption);
}

TableBuilder& TableBuilder::words(std::string name) {
  table_.columns.push_back({.name = std::move(name), .unit = "", .cells = std::vector<std::string>{}});
  return *this;
}

TableBuilder& TableBuilder::numbers(std::string name, std::string unit) {
  table_.columns.push_back({.name = std::move(name), .unit = std::move(unit), .cells = std::vector<double>{}});
  return *this;
}

TableBuilder& TableBuilder::counts(std::string name) {
  numbers(std::move(name));
  table_.columns.back().whole_numbers = true;
  return *this;
}

void TableBuilder::row(const std::vector<Cell>& cells) {
  if (cells.size() != table_.columns.size())
    throw std::logic_error("TableBuilder: a row needs a value for every column");
  for (std::size_t i = 0; i < cells.size(); ++i)
    std::visit(
        [&](const auto& value) {
          using Value = std::decay_t<decltype(value)>;
          auto* column = std::get_if<std::vector<Value>>(&table_.columns[i].cells);
          if (column == nullptr) throw std::logic_error("TableBuilder: words and numbers are not the same column");
          column->push_back(value);
        },
        cells[i]);
}

}  // namespace kappabench
