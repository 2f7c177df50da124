#include "reports/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace kappabench {
namespace {

using store::TableColumn;
using store::TableRecord;

constexpr std::string_view en_dash = "–";

std::size_t length_of(const TableColumn& column) {
  return std::visit([](const auto& cells) { return cells.size(); }, column.cells);
}

std::size_t rows_of(const TableRecord& table) {
  if (table.columns.empty()) return 0;
  const std::size_t rows = length_of(table.columns.front());
  for (const auto& column : table.columns) {
    if (length_of(column) == rows) continue;
    throw std::invalid_argument(fmt::format("table '{}': column '{}' has {} rows, column '{}' has {}", table.id,
                                            column.name, length_of(column), table.columns.front().name, rows));
  }
  return rows;
}

std::string head_of(const TableColumn& column) {
  const bool bare = column.unit.empty() || column.unit == "1";
  return bare ? column.name : fmt::format("{} ({})", column.name, column.unit);
}

/// Every part of `text` that has an entry is replaced by it.
std::string escaped(std::string_view text, const std::vector<std::pair<std::string_view, std::string_view>>& entries) {
  std::string result;
  while (!text.empty()) {
    const auto entry =
        std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return text.starts_with(e.first); });
    const bool found = entry != entries.end();
    result += found ? entry->second : text.substr(0, 1);
    text.remove_prefix(found ? entry->first.size() : 1);
  }
  return result;
}

std::string markdown(std::string_view text) {
  return escaped(text, {{"|", "\\|"},
                        {"\\", "\\\\"},
                        {"*", "\\*"},
                        {"_", "\\_"},
                        {"`", "\\`"},
                        {"<", "&lt;"},
                        {"&", "&amp;"},
                        {"\n", " "}});
}

std::string latex(std::string_view text) {
  return escaped(text, {{"\\", "\\textbackslash{}"},
                        {"{", "\\{"},
                        {"}", "\\}"},
                        {"$", "\\$"},
                        {"&", "\\&"},
                        {"#", "\\#"},
                        {"%", "\\%"},
                        {"_", "\\_"},
                        {"^", "\\textasciicircum{}"},
                        {"~", "\\textasciitilde{}"},
                        {"<", "\\textless{}"},
                        {">", "\\textgreater{}"},
                        {"\n", " "},
                        // what pdflatex does not take as it is
                        {"ε", "$\\varepsilon$"},
                        {"κ", "$\\kappa$"},
                        {"λ", "$\\lambda$"},
                        {"α", "$\\alpha$"},
                        {"β", "$\\beta$"},
                        {"θ", "$\\theta$"},
                        {"π", "$\\pi$"},
                        {"Δ", "$\\Delta$"},
                        {"²", "$^2$"},
                        {"×", "$\\times$"},
                        {"≤", "$\\le$"},
                        {"≥", "$\\ge$"},
                        {"∞", "$\\infty$"},
                        {"–", "--"}});
}

/// "-1.5e-06" becomes "$-1.5\times10^{-6}$".
std::string latex_number(const std::string& word) {
  if (word == "--") return word;
  if (word == "inf" || word == "-inf") return word == "inf" ? "$\\infty$" : "$-\\infty$";
  const auto exponent = word.find('e');
  if (exponent == std::string::npos) return fmt::format("${}$", word);
  return fmt::format("${}\\times10^{{{}}}$", word.substr(0, exponent), std::stoi(word.substr(exponent + 1)));
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  return fmt::format("\"{}\"", escaped(text, {{"\"", "\"\""}}));
}

std::string csv_cell(const TableColumn& column, std::size_t row) {
  if (const auto* words = std::get_if<std::vector<std::string>>(&column.cells)) return csv_field((*words)[row]);
  const double number = std::get<std::vector<double>>(column.cells)[row];
  return std::isnan(number) ? "" : fmt::format("{:.17g}", number);
}

/// Characters on the screen: the bytes of UTF-8 that do not continue a character.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string blank(width - std::min(width, width_of(text)), ' ');
  return right ? blank + text : text + blank;
}

std::string joined(const std::vector<std::string>& words, std::string_view separator) {
  return fmt::format("{}", fmt::join(words, separator));
}

}  // namespace

std::string to_words(double number, bool whole, std::string_view dash) {
  if (std::isnan(number)) return std::string(dash);
  if (whole && std::isfinite(number) && number == std::round(number)) return fmt::format("{:.0f}", number);
  return fmt::format("{:.4g}", number);
}

WordTable to_words(const TableRecord& table, std::string_view dash) {
  WordTable words;
  words.rows = rows_of(table);
  for (const auto& column : table.columns) {
    if (const auto* cells = std::get_if<std::vector<std::string>>(&column.cells)) {
      words.columns.push_back({head_of(column), false, *cells});
      continue;
    }
    auto& made = words.columns.emplace_back(WordTable::Column{head_of(column), true, {}});
    for (const double number : std::get<std::vector<double>>(column.cells)) {
      made.cells.push_back(to_words(number, column.whole_numbers, dash));
    }
  }
  return words;
}

std::string to_markdown(const TableRecord& table) {
  const WordTable words = to_words(table, en_dash);
  std::string text = fmt::format("### {}\n\n", markdown(table.title));
  std::vector<std::string> heads, rules;
  for (const auto& column : words.columns) {
    heads.push_back(markdown(column.head));
    rules.emplace_back(column.numbers ? "---:" : ":---");
  }
  text += fmt::format("| {} |\n| {} |\n", joined(heads, " | "), joined(rules, " | "));
  for (std::size_t row = 0; row < words.rows; ++row) {
    std::vector<std::string> cells;
    for (const auto& column : words.columns) cells.push_back(markdown(column.cells[row]));
    text += fmt::format("| {} |\n", joined(cells, " | "));
  }
  if (!table.caption.empty()) text += fmt::format("\n{}\n", markdown(table.caption));
  return text;
}

std::string to_csv(const TableRecord& table) {
  const std::size_t rows = rows_of(table);
  std::vector<std::string> fields;
  for (const auto& column : table.columns) fields.push_back(csv_field(head_of(column)));
  std::string text = joined(fields, ",") + "\r\n";
  for (std::size_t row = 0; row < rows; ++row) {
    fields.clear();
    for (const auto& column : table.columns) fields.push_back(csv_cell(column, row));
    text += joined(fields, ",") + "\r\n";
  }
  return text;
}

std::string to_latex(const TableRecord& table) {
  const WordTable words = to_words(table, "--");
  std::string kinds;
  std::vector<std::string> heads;
  for (const auto& column : words.columns) {
    kinds += column.numbers ? 'r' : 'l';
    heads.push_back(latex(column.head));
  }
  std::string caption = latex(table.title);
  if (!table.caption.empty()) caption += ". " + latex(table.caption);
  std::string text = fmt::format(
      "% needs \\usepackage{{booktabs}}\n\\begin{{table}}\n  \\centering\n  \\caption{{{}}}\n  \\label{{tab:{}}}\n"
      "  \\begin{{tabular}}{{{}}}\n    \\toprule\n    {} \\\\\n    \\midrule\n",
      caption, table.id, kinds, joined(heads, " & "));
  for (std::size_t row = 0; row < words.rows; ++row) {
    std::vector<std::string> cells;
    for (const auto& column : words.columns) {
      cells.push_back(column.numbers ? latex_number(column.cells[row]) : latex(column.cells[row]));
    }
    text += fmt::format("    {} \\\\\n", joined(cells, " & "));
  }
  return text + "    \\bottomrule\n  \\end{tabular}\n\\end{table}\n";
}

std::string to_text(const TableRecord& table) {
  const WordTable words = to_words(table, "-");
  std::vector<std::size_t> widths;
  for (const auto& column : words.columns) {
    std::size_t width = width_of(column.head);
    for (const auto& cell : column.cells) width = std::max(width, width_of(cell));
    widths.push_back(width);
  }
  const auto line = [&](auto cell_of) {
    std::vector<std::string> cells;
    for (std::size_t c = 0; c < words.columns.size(); ++c) {
      cells.push_back(padded(cell_of(c), widths[c], words.columns[c].numbers));
    }
    std::string made = joined(cells, "  ");
    made.erase(made.find_last_not_of(' ') + 1);
    return made + "\n";
  };
  std::string text = line([&](std::size_t c) { return words.columns[c].head; });
  text += line([&](std::size_t c) { return std::string(widths[c], '-'); });
  for (std::size_t row = 0; row < words.rows; ++row) {
    text += line([&](std::size_t c) { return words.columns[c].cells[row]; });
  }
  return text;
}

}  // namespace kappabench
