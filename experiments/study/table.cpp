#include "experiments/study/table.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace kappabench::study {

Table::Table(std::string id, std::string title, std::string caption) {
  record_.id = std::move(id);
  record_.title = std::move(title);
  record_.caption = std::move(caption);
}

Table& Table::words(std::string name) {
  record_.columns.push_back({.name = std::move(name), .cells = std::vector<std::string>{}});
  return *this;
}

Table& Table::numbers(std::string name, std::string unit) {
  record_.columns.push_back({.name = std::move(name), .unit = std::move(unit), .cells = std::vector<double>{}});
  return *this;
}

Table& Table::counts(std::string name) {
  numbers(std::move(name));
  record_.columns.back().whole_numbers = true;
  return *this;
}

void Table::row(const std::vector<TableValue>& values) {
  if (values.size() != record_.columns.size())
    throw std::logic_error(
        fmt::format("table {}: {} values for {} columns", record_.id, values.size(), record_.columns.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    std::visit(
        [&](const auto& value) {
          auto* column = std::get_if<std::vector<std::decay_t<decltype(value)>>>(&record_.columns[i].cells);
          if (column == nullptr)
            throw std::logic_error(
                fmt::format("table {}: words and numbers in column {}", record_.id, record_.columns[i].name));
          column->push_back(value);
        },
        values[i].value);
}

}  // namespace kappabench::study
