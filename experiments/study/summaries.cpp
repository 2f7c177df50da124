#include "experiments/study/summaries.hpp"

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

}  // namespace

std::optional<double> measured(const store::CurveRecord& curve, const Column& column) {
  return find_in(curve.measurements, column.name);
}

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
