#include "datasets/csv_dialect.hpp"

#include <algorithm>
#include <cctype>

#include "datasets/text.hpp"

namespace kappabench {

namespace {

bool outside_quotes(std::string_view line, char wanted) {
  bool inside = false;
  for (const char c : line) {
    if (c == '"') inside = !inside;
    if (c == wanted && !inside) return true;
  }
  return false;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::string CsvDialect::with_decimal_point(std::string_view cell) const {
  std::string number(cell);
  const bool decimal_comma =
      separator != ',' && std::ranges::count(number, ',') == 1 && number.find('.') == number.npos;
  if (decimal_comma) std::ranges::replace(number, ',', '.');
  return number;
}

CsvDialect dialect_of(std::string_view line) {
  for (const char separator : {';', '\t'})
    if (outside_quotes(line, separator)) return {separator};
  return {};
}

std::string column_name(std::string_view cell) {
  std::string name(trimmed(cell));
  std::ranges::transform(name, name.begin(),
                         [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  const bool coordinate = name.starts_with('x') || name.starts_with('y');
  if (!coordinate || name.size() == 1) return name;
  // What follows is a unit if it is set off: x_m, x [mm], y(px).
  std::string_view unit = trimmed(std::string_view(name).substr(1));
  if (unit.starts_with('_'))
    unit.remove_prefix(1);
  else if ((unit.starts_with('(') && unit.ends_with(')')) || (unit.starts_with('[') && unit.ends_with(']')))
    unit = unit.substr(1, unit.size() - 2);
  else
    return name;
  constexpr std::size_t longest_unit = 4;
  const bool is_unit = !unit.empty() && unit.size() <= longest_unit && std::ranges::all_of(unit, is_letter);
  return is_unit ? name.substr(0, 1) : name;
}

bool looks_like_csv(std::string_view text) {
  for (const Line& line : lines_of(text)) {
    const std::string_view content = trimmed(line.text);
    if (content.empty() || content.starts_with('#')) continue;
    if (content == "open" || content == "closed") return false;
    if (outside_quotes(content, ',') || outside_quotes(content, ';')) return true;
    const std::vector<std::string_view> cells = split(content, '\t');
    return cells.size() > 1 && std::ranges::any_of(cells, [](std::string_view c) { return column_name(c) == "x"; });
  }
  return false;
}

}  // namespace kappabench
