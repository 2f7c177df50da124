#pragma once

#include <string>
#include <string_view>

namespace kappabench {

/// How a program wrote its comma-separated values: spreadsheets of half the world have the comma for decimals.
struct CsvDialect {
  char separator = ',';

  /// The cell with a decimal point, if commas do not separate and it has one comma and no point.
  [[nodiscard]] std::string with_decimal_point(std::string_view cell) const;
};

/// By its first line that is no comment: semicolons, tabs or else commas separate.
[[nodiscard]] CsvDialect dialect_of(std::string_view line);

/// The name of a column as this house writes it: lower case, without blanks around, and x or y without the unit that
/// instruments append ("X", "x_m", "y (mm)").
[[nodiscard]] std::string column_name(std::string_view cell);

/// Is a text without a telling ending columns with a header, or separated by commas or semicolons, rather than plain
/// points?
[[nodiscard]] bool looks_like_csv(std::string_view text);

}  // namespace kappabench
