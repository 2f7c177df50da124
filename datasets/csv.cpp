#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "datasets/fields.hpp"
#include "datasets/readers.hpp"

namespace kappabench {
namespace {

/// The cells of a line; a cell may stand in double quotes, with "" for a quote inside. No line breaks in cells.
std::vector<std::string> cells_of(std::string_view line, const Place& place) {
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
    } else if (!inside && line[i] == ',') {
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

/// A column each, checked: known, not twice, x and y there.
void check_header(const std::vector<std::string>& header, const Place& place) {
  const std::string known = fmt::format("known columns are x, y, curve, closed, {}", point_keys_text());
  std::set<std::string_view> seen;
  for (const std::string& column : header) {
    const bool other = column == "x" || column == "y" || column == "curve" || column == "closed" || column == "type";
    if (!other && find_number_key(column) == nullptr) {
      refuse(place, fmt::format("unknown column {}", in_quotes(column)), known);
    }
    if (!seen.insert(column).second) refuse(place, fmt::format("column {} is there twice", column), "name it once");
  }
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
      if (header_.empty()) read_metadata_comment(drawing_, content, place_);
      return;
    }
    const std::vector<std::string> cells = cells_of(content, place_);
    if (header_.empty() && !starts_a_number(cells[0])) {
      check_header(cells, place_);
      header_ = cells;
      return;
    }
    if (header_.empty()) header_ = {"x", "y"};
    read_row(cells);
  }

  [[nodiscard]] Drawing finish() && {
    end_curve();
    place_.line = 0;
    if (drawing_.curves.empty()) refuse(place_, "no points", "at least one row \"x,y\" is needed");
    return std::move(drawing_);
  }

 private:
  void read_row(const std::vector<std::string>& cells) {
    if (cells.size() != header_.size()) {
      refuse(place_, fmt::format("{} cells", cells.size()),
             fmt::format("this file has {} columns, separated by commas", header_.size()));
    }
    const auto label = std::ranges::find(header_, "curve") - header_.begin();
    begin_curve_if_new(std::cmp_less(label, cells.size()) ? cells[static_cast<std::size_t>(label)] : std::string());
    Vec2 point = Vec2::Zero();
    PointOptions options;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (header_[i] == "x") {
        point.x() = parse_number(cells[i], "x", place_);
      } else if (header_[i] == "y") {
        point.y() = parse_number(cells[i], "y", place_);
      } else if (header_[i] == "closed") {
        read_closed(cells[i]);
      } else if (header_[i] != "curve" && !cells[i].empty()) {
        set_option(options, header_[i], cells[i], place_);
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
  std::vector<std::string> header_;
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
