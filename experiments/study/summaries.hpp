#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "metrics/metric.hpp"
#include "metrics/statistics.hpp"
#include "reports/store/model.hpp"

namespace kappabench {

/// Reading finished cells, and writing tables of them.

/// The measurement, or nothing when the curve has none (no curve, or the metric was not asked for).
[[nodiscard]] std::optional<double> measured(const store::CurveRecord& curve, const Column& column);
[[nodiscard]] std::optional<double> measured(const store::CurveRecord& curve,
                                             std::string_view column);                                 // on its way out
[[nodiscard]] std::optional<double> measured(const store::CellRecord& cell, std::string_view column);  // on its way out

/// A counter of the report; 0 when the scheme does not have it.
[[nodiscard]] long counted(const store::CurveRecord& curve, const std::string& counter);

/// A table built row by row; columns are declared first.
class TableBuilder {
 public:
  TableBuilder(std::string id, std::string title, std::string caption);

  /// Column of words, of numbers, of whole numbers. Returns the builder, for chains.
  TableBuilder& words(std::string name);
  TableBuilder& numbers(std::string name, std::string unit = "1");
  TableBuilder& counts(std::string name);

  /// A row: one value for every column, in order. Throws std::logic_error for a wrong number or kind.
  using Cell = std::variant<double, std::string>;
  void row(const std::vector<Cell>& cells);

  [[nodiscard]] store::TableRecord table() const { return table_; }

 private:
  store::TableRecord table_;
};

}  // namespace kappabench
