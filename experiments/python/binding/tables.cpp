#include "experiments/python/binding/tables.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace kappabench::python {

namespace py = pybind11;

namespace {

py::object python_column(const store::TableColumn& column) {
  if (const auto* words = std::get_if<std::vector<std::string>>(&column.cells)) return py::cast(*words);
  const auto& numbers = std::get<std::vector<double>>(column.cells);
  const bool whole =
      column.whole_numbers && std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
  if (!whole) return py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
  const std::vector<std::int64_t> counts(numbers.begin(), numbers.end());
  return py::array_t<std::int64_t>(static_cast<py::ssize_t>(counts.size()), counts.data());
}

}  // namespace

py::tuple python_table(const store::TableRecord& table) {
  py::dict columns, units;
  for (const store::TableColumn& column : table.columns) {
    const py::str name(column.name);
    columns[name] = python_column(column);
    if (!column.unit.empty()) units[name] = column.unit;
  }
  return py::make_tuple(table.title, table.caption, columns, units);
}

}  // namespace kappabench::python
