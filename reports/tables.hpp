#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/store/model.hpp"

namespace kappabench {

/// A table as text. All throw std::invalid_argument when its columns differ in length.
///
/// Numbers have 4 significant digits in Markdown, LaTeX and plain text, and 17 (every bit) in CSV; columns of whole
/// numbers are written out. NaN, "not defined here", is a dash, and an empty field in CSV.

/// GitHub Markdown: a heading, the table, the caption. Numbers are aligned right.
[[nodiscard]] std::string to_markdown(const store::TableRecord& table);

/// RFC 4180: one header line "name (unit)", lines end with CR LF, fields are quoted where they must be.
[[nodiscard]] std::string to_csv(const store::TableRecord& table);

/// A table environment for the package booktabs, with caption and label "tab:<id>"; every word is escaped.
[[nodiscard]] std::string to_latex(const store::TableRecord& table);

/// Aligned columns for a terminal.
[[nodiscard]] std::string to_text(const store::TableRecord& table);

/// A table whose cells are words already, as the writers share it.
struct WordTable {
  struct Column {
    std::string head;  ///< "name (unit)"
    bool numbers;
    std::vector<std::string> cells;
  };
  std::vector<Column> columns;
  std::size_t rows = 0;
};

/// The cells with 4 significant digits; `dash` stands for NaN.
[[nodiscard]] WordTable to_words(const store::TableRecord& table, std::string_view dash);

/// One number with 4 significant digits, or all digits of a whole number.
[[nodiscard]] std::string to_words(double number, bool whole, std::string_view dash);

}  // namespace kappabench
