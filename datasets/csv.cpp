#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "datasets/csv_dialect.hpp"
#include "datasets/fields.hpp"
#include "datasets/readers.hpp"

namespace kappabench {
namespace {

/// The cells of a line; a cell may stand in double quotes, with "" for a quote inside. No line breaks in cells.
std::vector<std::string> cells_of(std::string_view line, char separator, const Place& place) {
  std::vector<std::string> cells;
  std::string cell;
  bool inside = false;
  bool was_quoted = false;
  const auto end_cell = [&] {
    cells.emplace_back(was_quoted ? cell : std::string(trimmed(cell)));
    cell.clear();
    was_quoted = false;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool quote = line[i] == '"';
    if (inside && quote && i + 1 < line.size() && line[i + 1] == '"') {
      cell += line[++i];
    } else if (inside && quote) {
      inside = false;
    } else if (quote && trimmed(cell).empty() && !was_quoted) {
      inside = was_quoted = true;
      cell.clear();
    } else if (!inside && line[i] == separator) {
      end_cell();
    } else if (inside || !was_quoted) {
      cell += line[i];
    } else if (!trimmed(line.substr(i, 1)).empty()) {
      refuse(place, "text after a closing quote", "write \"\" for a quote inside a quoted cell");
    }
  }
  if (inside) refuse(place, "a quote without its end", "close it on the same line");
  end_cell();
  return cells;
}

bool starts_a_number(std::string_view cell) {
  return !cell.empty() && std::string_view("+-.0123456789").find(cell[0]) != std::string_view::npos;
}

constexpr std::array<std::string_view, 5> other_columns{"x", "y", "curve", "closed", "type"};

bool is_known(std::string_view column) {
  return std::ranges::find(other_columns, column) != other_columns.end() || find_number_key(column) != nullptr;
}

/// Names of columns, checked: none that is known twice, x and y there. Others are for other programs.
void check_header(const std::vector<std::string>& header, const Place& place) {
  const std::string known = fmt::format("known columns are x, y, curve, closed, {}", point_keys_text());
  std::set<std::string_view> seen;
  for (const std::string& column : header)
    if (is_known(column) && !seen.insert(column).second)
      refuse(place, fmt::format("column {} is there twice", column), "name it once");
  if (!seen.contains("x") || !seen.contains("y")) refuse(place, "no column x or no column y", known);
}

class CsvReader {
 public:
  explicit CsvReader(std::string_view file) : place_{std::string(file), 0} {}

  void read(const Line& line) {
    place_.line = line.number;
    const std::string_view content = trimmed(line.text);
    if (content.empty()) return;
    if (content.starts_with('#')) {
      if (header_.empty()) read_comment(content);
      return;
    }
    if (header_.empty()) dialect_ = dialect_of(line.text);
    const std::vector<std::string> cells = cells_of(line.text, dialect_.separator, place_);
    if (!header_.empty()) return read_row(cells);
    if (begin_table(cells)) read_row(cells);
  }

  [[nodiscard]] Drawing finish() && {
    end_curve();
    place_.line = 0;
    if (drawing_.curves.empty()) refuse(place_, "no points", "at least one row \"x,y\" is needed");
    return std::move(drawing_);
  }

 private:
  /// Some programs write the names of the columns as a comment: kept until the first row shows whether they fit.
  void read_comment(std::string_view content) {
    read_metadata_comment(drawing_, content, place_);
    const std::string_view words = content.substr(1);
    comment_.clear();
    for (const std::string_view cell : split(words, dialect_of(words).separator)) comment_.push_back(column_name(cell));
  }

  static std::vector<std::string> named_columns(const std::vector<std::string>& cells) {
    std::vector<std::string> names(cells.size());
    std::ranges::transform(cells, names.begin(), column_name);
    return names;
  }

  /// Takes the names of the columns from the first line that is no comment, or says that it is the first row.
  bool begin_table(const std::vector<std::string>& cells) {
    const bool names = std::ranges::any_of(cells, [](const std::string& cell) { return is_known(column_name(cell)); });
    const bool row = std::ranges::any_of(cells, starts_a_number);
    if (names || !row) {
      header_ = named_columns(cells);
      check_header(header_, place_);
      return false;
    }
    const bool fits = comment_.size() == cells.size() && std::ranges::find(comment_, "x") != comment_.end();
    const auto more = std::ranges::any_of(cells.begin() + std::min<std::ptrdiff_t>(2, std::ssize(cells)), cells.end(),
                                          [](const std::string& cell) { return !cell.empty(); });
    if (!fits && more)
      refuse(place_, fmt::format("{} columns without names", cells.size()),
             "name them in the first line, such as x,y,z");
    header_ = fits ? comment_ : std::vector<std::string>{"x", "y"};
    check_header(header_, place_);
    return true;
  }

  /// Spreadsheets leave out empty cells at the end of a row, or write some more.
  [[nodiscard]] std::vector<std::string> fitted(std::vector<std::string> cells) const {
    while (cells.size() > header_.size() && cells.back().empty()) cells.pop_back();
    const auto last = std::ranges::find_if(header_.rbegin(), header_.rend(), is_known);
    const auto needed = static_cast<std::size_t>(header_.rend() - last);
    if (cells.size() > header_.size() || cells.size() < std::min<std::size_t>(needed, 2))
      refuse(place_, fmt::format("{} cells", cells.size()),
             fmt::format("this file has {} columns, separated by {}", header_.size(), separator_word()));
    cells.resize(header_.size());
    return cells;
  }

  [[nodiscard]] std::string_view separator_word() const {
    return dialect_.separator == ';' ? "semicolons" : dialect_.separator == '\t' ? "tabs" : "commas";
  }

  void read_row(const std::vector<std::string>& as_written) {
    const std::vector<std::string> cells = fitted(as_written);
    const auto label = std::ranges::find(header_, "curve") - header_.begin();
    begin_curve_if_new(std::cmp_less(label, cells.size()) ? cells[static_cast<std::size_t>(label)] : std::string());
    Vec2 point = Vec2::Zero();
    PointOptions options;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (header_[i] == "x") {
        point.x() = parse_number(dialect_.with_decimal_point(cells[i]), "x", place_);
      } else if (header_[i] == "y") {
        point.y() = parse_number(dialect_.with_decimal_point(cells[i]), "y", place_);
      } else if (header_[i] == "closed") {
        read_closed(cells[i]);
      } else if (header_[i] != "curve" && is_known(header_[i]) && !cells[i].empty()) {
        set_option(options, header_[i], dialect_.with_decimal_point(cells[i]), place_);
      }
    }
    curve_.points.push_back(point);
    curve_.options.push_back(options);
  }

  void begin_curve_if_new(const std::string& label) {
    if (!curve_.points.empty() && label == label_) return;
    end_curve();
    if (!labels_.insert(label).second) {
      refuse(place_, fmt::format("curve {} goes on after another one", in_quotes(label)),
             "the rows of a curve stand together");
    }
    label_ = label;
  }

  void read_closed(std::string_view cell) {
    const bool first = curve_.points.empty();
    if (cell.empty()) return;
    const bool closed = parse_flag(cell, "closed", place_);
    if (!first && closed != curve_.closed) {
      refuse(place_, fmt::format("closed = {} differs from the rows above", cell), "all rows of a curve agree");
    }
    curve_.closed = closed;
  }

  void end_curve() {
    if (curve_.points.empty()) return;
    drop_unsaid_options(curve_);
    drawing_.curves.push_back(std::exchange(curve_, Input{}));
  }

  Place place_;
  CsvDialect dialect_;
  std::vector<std::string> header_;
  std::vector<std::string> comment_;  ///< the last comment before the table, as names of columns
  Drawing drawing_;
  Input curve_;
  std::string label_;
  std::set<std::string> labels_;
};

}  // namespace

Drawing parse_csv(std::string_view text, std::string_view file) {
  CsvReader reader(file);
  for (const Line& line : lines_of(text)) reader.read(line);
  return std::move(reader).finish();
}

}  // namespace kappabench
