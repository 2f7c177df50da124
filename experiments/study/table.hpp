#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "reports/store/model.hpp"

namespace kappabench::study {

/// A value in a row of a table: words, or any number.
struct TableValue {
  std::variant<double, std::string> value;

  // Implicit, so that rows read like rows.
  TableValue(std::convertible_to<std::string_view> auto const& words)  // NOLINT(google-explicit-constructor)
      : value(std::string(std::string_view(words))) {}
  template <class Number>
  requires std::integral<Number> || std::floating_point<Number> TableValue(Number number)
      : value(static_cast<double>(number)) {}  // NOLINT(google-explicit-constructor)
};

/// A table built row by row; columns are declared first.
class Table {
 public:
  Table(std::string id, std::string title, std::string caption);

  /// A column of words, of numbers, of whole numbers. Returns the table, for chains.
  Table& words(std::string name);
  Table& numbers(std::string name, std::string unit = "1");
  Table& counts(std::string name);

  /// A row: one value for every column, in order. Throws std::logic_error for a wrong number or kind.
  void row(const std::vector<TableValue>& values);
  void row(std::initializer_list<TableValue> values) { row(std::vector(values)); }

  [[nodiscard]] const store::TableRecord& record() const { return record_; }
  [[nodiscard]] const std::string& id() const { return record_.id; }

 private:
  store::TableRecord record_;
};

}  // namespace kappabench::study
