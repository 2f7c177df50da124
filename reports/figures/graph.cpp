#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reports/figures/panel.hpp"

namespace kappabench::figures {
namespace {

using store::PanelRecord;
using store::TableColumn;
using store::TableRecord;
using Words = std::vector<std::string>;
using Numbers = std::vector<double>;

[[noreturn]] void refuse(const PanelRecord& panel, const Context& context, const std::string& what) {
  throw std::invalid_argument(fmt::format("figure '{}', panel '{}': {}", context.figure.id, panel.title, what));
}

const TableRecord& table_of(const PanelRecord& panel, const Context& context) {
  for (const auto& table : context.experiment.tables) {
    if (table.id == panel.table) return table;
  }
  refuse(panel, context, fmt::format("'{}' has no table '{}'", context.experiment.id, panel.table));
}

const TableColumn& column_of(const TableRecord& table, const std::string& name, const PanelRecord& panel,
                             const Context& context) {
  for (const auto& column : table.columns) {
    if (column.name == name) return column;
  }
  refuse(panel, context, fmt::format("table '{}' has no column '{}'", table.id, name));
}

const Numbers& numbers_of(const TableColumn& column, const PanelRecord& panel, const Context& context) {
  if (const auto* numbers = std::get_if<Numbers>(&column.cells)) return *numbers;
  refuse(panel, context, fmt::format("column '{}' holds words, not numbers", column.name));
}

std::string head_of(const TableColumn& column) {
  return column.unit.empty() || column.unit == "1" ? column.name : fmt::format("{} ({})", column.name, column.unit);
}

Words distinct(const Words& words) {
  Words found;
  for (const auto& word : words) {
    if (std::find(found.begin(), found.end(), word) == found.end()) found.push_back(word);
  }
  return found;
}

/// The x values; words stand at 1, 2, ... and are written under the axis.
struct Abscissae {
  Numbers values;
  Words names;
};

Abscissae abscissae_of(const TableColumn& column) {
  if (const auto* numbers = std::get_if<Numbers>(&column.cells)) return {*numbers, {}};
  const auto& words = std::get<Words>(column.cells);
  Abscissae x{{}, distinct(words)};
  for (const auto& word : words) {
    x.values.push_back(1.0 + static_cast<double>(std::find(x.names.begin(), x.names.end(), word) - x.names.begin()));
  }
  return x;
}

/// A straight line through points by least squares, in logarithms where an axis is logarithmic.
struct Fitted {
  double slope = 0.0, offset = 0.0;
  bool valid = false;
};

Fitted least_squares(const std::vector<std::pair<double, double>>& points, bool log_x, bool log_y) {
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (const auto& [px, py] : points) {
    const double x = log_x ? std::log10(px) : px, y = log_y ? std::log10(py) : py;
    n += 1.0, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double determinant = n * sxx - sx * sx;
  if (n < 2.0 || !(determinant > 1e-12 * n * sxx)) return {};
  const double slope = (n * sxy - sx * sy) / determinant;
  return {slope, (sy - slope * sx) / n, true};
}

Interval axis_range(const Numbers& values, bool log) {
  const auto range = extent(values);
  if (!range) return log ? Interval{1.0, 10.0} : Interval{0.0, 1.0};
  if (!log) return padded(*range, 0.06);
  const Interval decades = padded({std::log10(range->from), std::log10(range->to)}, 0.06);
  return {std::pow(10.0, decades.from), std::pow(10.0, decades.to)};
}

/// 1, 2 or 5 times a power of ten, so that at most five fit: more numbers run into each other under a narrow panel.
double tic_step(Interval range) {
  const double least = range.size() / 5.0, power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least) return factor * power;
  return 10.0 * power;
}

void set_axis(Panel& drawn, const std::string& axis, bool log, Interval range) {
  if (!log) {
    if (axis == "x") drawn.setup.push_back(fmt::format("set xtics {:g}", tic_step(range)));
    return;
  }
  drawn.setup.push_back("set logscale " + axis);
  const bool plain = range.from >= 1e-2 && range.to <= 1e5;
  drawn.setup.push_back(fmt::format("set format {} '{}'", axis, plain ? "%g" : "10^{%T}"));
  const double decades = std::log10(range.to / range.from);
  if (decades > 8.0)
    drawn.setup.push_back(fmt::format("set {}tics {:g}", axis, std::pow(10.0, std::ceil(decades / 7.0))));
}

void name_places(Panel& drawn, const Words& names) {
  std::string tics;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    tics += fmt::format("{}{} {}", i == 0 ? "" : ", ", text_in_gnuplot(names[i]), i + 1);
    longest = std::max(longest, names[i].size());
  }
  const bool crowded = longest * names.size() > 36;
  drawn.setup.push_back(fmt::format("set xtics ({}) noenhanced{}", tics, crowded ? " rotate by -35" : ""));
  drawn.range.x = {0.5, static_cast<double>(names.size()) + 0.5};
}

/// One line of a graph: the rows of one series in one column.
struct Line {
  std::string label, column;
  std::vector<std::pair<double, double>> points;
};

struct Lines {
  std::vector<Line> lines;
  Numbers all_x, all_y;
  std::size_t left_out = 0;  ///< undefined values, and those a logarithmic axis cannot show
};

Words series_of(const PanelRecord& panel, const TableRecord& table, std::size_t rows, const Context& context) {
  if (panel.series.empty()) return Words(rows);
  const auto* words = std::get_if<Words>(&column_of(table, panel.series, panel, context).cells);
  if (words == nullptr) refuse(panel, context, fmt::format("series '{}' must be a column of words", panel.series));
  return *words;
}

Lines lines_of(const PanelRecord& panel, const TableRecord& table, const Numbers& x, bool log_x,
               const Context& context) {
  Lines found;
  const Words series = series_of(panel, table, x.size(), context);
  for (const auto& name : panel.y) {
    const Numbers& y = numbers_of(column_of(table, name, panel, context), panel, context);
    if (y.size() != x.size() || series.size() != y.size()) refuse(panel, context, "columns differ in length");
    for (const auto& word : distinct(series)) {
      Line line{word.empty() ? name : panel.y.size() == 1 ? word : fmt::format("{}, {}", word, name), name, {}};
      for (std::size_t i = 0; i < y.size(); ++i) {
        if (series[i] != word) continue;
        const bool drawable =
            std::isfinite(x[i]) && std::isfinite(y[i]) && (!log_x || x[i] > 0.0) && (!panel.log_y || y[i] > 0.0);
        if (!drawable) {
          ++found.left_out;
          continue;
        }
        line.points.emplace_back(x[i], y[i]);
        found.all_x.push_back(x[i]);
        found.all_y.push_back(y[i]);
      }
      found.lines.push_back(std::move(line));
    }
  }
  return found;
}

/// Draws the least-squares line and returns what the legend says of it.
std::string draw_slope(const PanelRecord& panel, const Line& line, bool log_x, const std::string& colour, Panel& drawn,
                       DataFile& data) {
  const Fitted fitted = least_squares(line.points, log_x, panel.log_y);
  if (!fitted.valid) return "";
  Rows ends;
  for (const double x : {line.points.front().first, line.points.back().first}) {
    const double y = fitted.offset + fitted.slope * (log_x ? std::log10(x) : x);
    ends.add({x, panel.log_y ? std::pow(10.0, y) : y});
  }
  plot(drawn, data, "least squares: " + line.label, ends, fmt::format("with lines lw 1 dt 3 lc rgb '{}'", colour));
  return fmt::format(" (slope {:.2f})", fitted.slope);
}

void draw_line(const PanelRecord& panel, const Line& line, bool log_x, const Context& context, Panel& drawn,
               DataFile& data) {
  const std::string colour = context.key.colour(line.label);
  const std::string point = fmt::format("pt {} ps 0.9 lc rgb '{}'", context.key.marker(line.label), colour);
  Rows rows;
  for (const auto& [x, y] : line.points) rows.add({x, y});
  plot(drawn, data, fmt::format("{}: {} {}", line.label, panel.x, line.column), rows,
       panel.lines ? "with linespoints lw 1.8 " + point : "with points " + point);
  const std::string slope = panel.slope ? draw_slope(panel, line, log_x, colour, drawn, data) : "";
  context.key.add({line.label + slope, panel.lines ? fmt::format("lw 1.8 lc rgb '{}'", colour) : "", point});
}

}  // namespace

Panel draw_graph(const PanelRecord& panel, const Context& context, DataFile& data) {
  Panel drawn;
  drawn.title = panel.title;
  const TableRecord& table = table_of(panel, context);
  const TableColumn& x_column = column_of(table, panel.x, panel, context);
  if (panel.y.empty()) refuse(panel, context, "a graph needs at least one column y");
  const Abscissae x = abscissae_of(x_column);
  const bool log_x = panel.log_x && x.names.empty();
  const Lines lines = lines_of(panel, table, x.values, log_x, context);
  for (const auto& line : lines.lines) draw_line(panel, line, log_x, context, drawn, data);

  const std::string y_head = panel.y.size() == 1 ? head_of(column_of(table, panel.y.front(), panel, context)) : "";
  drawn.setup = {
      fmt::format("set xlabel {} noenhanced",
                  text_in_gnuplot(panel.x_label.empty() ? head_of(x_column) : panel.x_label)),
      fmt::format("set ylabel {} noenhanced", text_in_gnuplot(panel.y_label.empty() ? y_head : panel.y_label))};
  drawn.range = {axis_range(lines.all_x, log_x), axis_range(lines.all_y, panel.log_y)};
  if (!x.names.empty()) name_places(drawn, x.names);
  if (x.names.empty()) set_axis(drawn, "x", log_x, drawn.range.x);
  set_axis(drawn, "y", panel.log_y, drawn.range.y);
  if (lines.left_out > 0) {
    remark(drawn, fmt::format("{} of {} points are undefined and not shown", lines.left_out,
                              lines.left_out + lines.all_x.size()));
  }
  return drawn;
}

}  // namespace kappabench::figures
