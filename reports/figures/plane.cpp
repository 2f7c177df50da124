#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "reports/figures/panel.hpp"

namespace kappabench::figures {
namespace {

using store::CellRecord;
using store::CurveRecord;
using store::PanelRecord;

using Cells = std::vector<const CellRecord*>;

constexpr double default_tooth = 0.22;    ///< longest tooth over the mean size of the drawing's curves
constexpr double tooth_distance = 0.012;  ///< between teeth, over the size of the drawing

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// The frame of the drawing. A curve that runs away from its points is not followed further than their own size.
Box frame_of(const PanelRecord& panel, const Cells& cells) {
  std::vector<double> px, py, sx, sy;
  for (const auto* cell : cells) {
    for (const auto* curve : curves_of(panel, *cell)) {
      append(px, curve->point_x), append(py, curve->point_y);
      append(sx, curve->sample_x), append(sy, curve->sample_y);
    }
  }
  const auto points_x = extent(px), points_y = extent(py);
  if (!points_x || !points_y) {
    return {extent(sx).value_or(Interval{}), extent(sy).value_or(Interval{})};
  }
  const double room = std::max({points_x->size(), points_y->size(), 1e-300});
  const auto join = [room](Interval points, std::optional<Interval> curve) {
    if (!curve) return points;
    return Interval{std::max(std::min(points.from, curve->from), points.from - room),
                    std::min(std::max(points.to, curve->to), points.to + room)};
  };
  return {join(*points_x, extent(sx)), join(*points_y, extent(sy))};
}

double size_of(const Box& frame) { return std::max(frame.x.size(), frame.y.size()); }

/// The size of the input, which all schemes share, so that combs of the same drawing have one scale.
double size_of_input(const PanelRecord& panel, const Cells& cells) {
  std::vector<double> xs, ys;
  for (const auto* cell : cells) {
    for (const auto* curve : curves_of(panel, *cell)) append(xs, curve->point_x), append(ys, curve->point_y);
  }
  const double size = size_of({extent(xs).value_or(Interval{0.0, 0.0}), extent(ys).value_or(Interval{0.0, 0.0})});
  return size > 0.0 ? size : std::max(size_of(frame_of(panel, cells)), 1e-300);
}

/// Mean size of the curves of the input: in a drawing of many small curves teeth must be short to be told apart.
double mean_curve_size(const PanelRecord& panel, const Cells& cells) {
  double sum = 0.0, count = 0.0;
  for (const auto* cell : cells) {
    for (const auto* curve : curves_of(panel, *cell)) {
      const auto x = extent(curve->point_x), y = extent(curve->point_y);
      if (!x || !y) continue;
      sum += size_of({*x, *y});
      count += 1.0;
    }
  }
  return count > 0.0 ? sum / count : size_of_input(panel, cells);
}

/// One scale for all panels of a figure that show the same drawings, so that their combs can be compared.
CurvatureLimit shared_limit(const Cells& cells, const Context& context, double size) {
  std::set<std::string> drawings;
  for (const auto* cell : cells) drawings.insert(cell->dataset);
  std::vector<const CurveRecord*> curves;
  for (const auto& other : context.figure.panels) {
    if (other.kind != "curve" || !other.comb) continue;
    for (const auto* cell : cells_of(other, context)) {
      if (!drawings.contains(cell->dataset)) continue;
      for (const auto* curve : curves_of(other, *cell)) curves.push_back(curve);
    }
  }
  return curvature_limit(curves, 20.0 / size);
}

struct Comb {
  double scale;  ///< length of a tooth for curvature 1
  CurvatureLimit limit;
  double distance;  ///< least arc length between two teeth
};

/// End of the tooth at sample i: on the outer side of the bend, so that a circle's comb is a larger circle.
std::pair<double, double> tooth(const CurveRecord& curve, std::size_t i, const Comb& comb) {
  const double kappa = std::clamp(curve.sample_kappa[i], -comb.limit.limit, comb.limit.limit);
  return {curve.sample_x[i] - comb.scale * kappa * curve.sample_normal_x[i],
          curve.sample_y[i] - comb.scale * kappa * curve.sample_normal_y[i]};
}

bool drawable(const CurveRecord& curve, std::size_t i) {
  return std::isfinite(curve.sample_x[i]) && std::isfinite(curve.sample_y[i]);
}

void draw_comb(const std::vector<const CurveRecord*>& curves, const Comb& comb, const std::string& colour, Panel& drawn,
               DataFile& data) {
  Rows teeth, envelope;
  for (const auto* curve : curves) {
    envelope.gap();
    double last = -comb.distance, last_x = 0.0, last_y = 0.0;
    for (std::size_t i = 0; i < curve->sample_x.size(); ++i) {
      if (!drawable(*curve, i) || !std::isfinite(curve->sample_kappa[i])) continue;
      const auto [x, y] = tooth(*curve, i, comb);
      if (!std::isfinite(x) || !std::isfinite(y)) continue;  // no normal where the speed is 0
      envelope.add({x, y});
      // Also where the tips run away from each other, as they do over a peak of curvature.
      if (curve->sample_s[i] - last < comb.distance && std::hypot(x - last_x, y - last_y) < 2.0 * comb.distance)
        continue;
      last = curve->sample_s[i], last_x = x, last_y = y;
      teeth.add({curve->sample_x[i], curve->sample_y[i], x - curve->sample_x[i], y - curve->sample_y[i]});
    }
  }
  plot(drawn, data, "comb: x y dx dy", teeth,
       fmt::format("with vectors nohead lw 0.6 lc rgb '{}'", lighter(colour, 0.6)));
  plot(drawn, data, "envelope of the comb: x y", envelope,
       fmt::format("with lines lw 1 lc rgb '{}'", lighter(colour, 0.3)));
}

void draw_curves(const std::vector<const CurveRecord*>& curves, const std::string& line, Panel& drawn, DataFile& data) {
  Rows rows;
  for (const auto* curve : curves) {
    rows.gap();
    for (std::size_t i = 0; i < curve->sample_x.size(); ++i) {
      if (drawable(*curve, i)) rows.add({curve->sample_x[i], curve->sample_y[i]});
    }
  }
  plot(drawn, data, "curve: x y", rows, "with lines " + line);
}

using Places = std::set<std::pair<double, double>>;

/// Places that are drawn with one symbol.
struct Symbol {
  std::string text;
  std::string point;
  Places places;
};

/// A node's mark that is drawn; others are not.
struct DrawnMark {
  std::string_view name;
  Symbol symbol;
};

const std::array<DrawnMark, 2> drawn_marks{
    {{"pinned", {"pinned node", "pt 7 ps 0.75 lc rgb '#E00000'", {}}},
     {"at_inflection", {"node at an inflection", "pt 12 ps 1.2 lw 1.5 lc rgb '#7030A0'", {}}}}};

bool has_mark(std::string_view marks, std::string_view name) {
  return std::ranges::any_of(std::views::split(marks, ' '),
                             [&](const auto& word) { return std::ranges::equal(word, name); });
}

/// Symbols in the order in which they are laid over one another.
std::vector<Symbol> symbols_of(const PanelRecord& panel, const Cells& cells) {
  Symbol joints{"joint", "pt 6 ps 0.7 lw 1.2 lc rgb '#404040'", {}};
  Symbol points{"input point", "pt 5 ps 0.6 lc rgb '#000000'", {}};
  auto marks = drawn_marks;
  for (const auto* cell : cells) {
    for (const auto* curve : curves_of(panel, *cell)) {
      if (panel.joints) {
        for (std::size_t i = 0; i < curve->joint_x.size(); ++i) {
          joints.places.emplace(curve->joint_x[i], curve->joint_y[i]);
        }
      }
      if (!panel.points) continue;
      for (std::size_t i = 0; i < curve->point_x.size(); ++i) {
        points.places.emplace(curve->point_x[i], curve->point_y[i]);
      }
      for (std::size_t i = 0; i < curve->node_x.size(); ++i) {
        for (auto& [name, symbol] : marks)
          if (has_mark(curve->node_marks[i], name)) symbol.places.emplace(curve->node_x[i], curve->node_y[i]);
      }
    }
  }
  std::vector<Symbol> symbols{std::move(joints), std::move(points)};
  for (auto& mark : marks) symbols.push_back(std::move(mark.symbol));
  return symbols;
}

void draw_symbol(const Symbol& symbol, const Context& context, Panel& drawn, DataFile& data) {
  if (symbol.places.empty()) return;
  Rows rows;
  for (const auto& [x, y] : symbol.places) rows.add({x, y});
  plot(drawn, data, symbol.text + ": x y", rows, "with points " + symbol.point);
  context.key.add({symbol.text, "", symbol.point});
}

Interval united(Interval a, std::optional<Interval> b) {
  return b ? Interval{std::min(a.from, b->from), std::max(a.to, b->to)} : a;
}

/// The frame with room for the teeth.
Box with_comb(Box frame, const std::vector<const CurveRecord*>& curves, const Comb& comb) {
  std::vector<double> xs, ys;
  for (const auto* curve : curves) {
    for (std::size_t i = 0; i < curve->sample_x.size(); ++i) {
      const auto [x, y] = tooth(*curve, i, comb);
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      xs.push_back(std::clamp(x, frame.x.from - 0.5 * size_of(frame), frame.x.to + 0.5 * size_of(frame)));
      ys.push_back(std::clamp(y, frame.y.from - 0.5 * size_of(frame), frame.y.to + 0.5 * size_of(frame)));
    }
  }
  return {united(frame.x, extent(xs)), united(frame.y, extent(ys))};
}

/// Frames around what other panels of the figure show of the same cells in close-up.
void draw_frames(const PanelRecord& panel, const Context& context, Panel& drawn, DataFile& data) {
  Rows rows;
  for (const auto& other : context.figure.panels) {
    if (other.kind != "curve" || other.window.size() != 4 || other.cells != panel.cells) continue;
    const auto& w = other.window;
    rows.gap();
    rows.add({w[0], w[2]}), rows.add({w[1], w[2]}), rows.add({w[1], w[3]}), rows.add({w[0], w[3]});
    rows.add({w[0], w[2]});
  }
  plot(drawn, data, "frames of close-ups: x y", rows, fmt::format("with lines lw 0.8 lc rgb '{}'", grey));
}

void check_window(const PanelRecord& panel, const Context& context) {
  const auto& w = panel.window;
  if (w.empty() || (w.size() == 4 && w[0] < w[1] && w[2] < w[3])) return;
  throw std::invalid_argument(
      fmt::format("figure '{}', panel '{}': a window is xmin < xmax, ymin < ymax", context.figure.id, panel.title));
}

/// Combs of all cells of the panel; widens its range to hold them.
void draw_combs(const PanelRecord& panel, const Cells& cells, const Context& context, Panel& drawn, DataFile& data) {
  const double size = size_of_input(panel, cells);
  const CurvatureLimit limit = shared_limit(cells, context, size);
  const double longest =
      panel.comb_scale > 0.0 ? panel.comb_scale * size : default_tooth * mean_curve_size(panel, cells);
  const Comb comb{limit.limit > 0.0 ? longest / limit.limit : 0.0, limit, tooth_distance * size};
  double largest = 0.0;
  for (const auto* cell : cells) {
    const auto curves = curves_of(panel, *cell);
    draw_comb(curves, comb, context.key.colour(label_of(*cell)), drawn, data);
    drawn.range = with_comb(drawn.range, curves, comb);
    largest = std::max(largest, curvature_limit(curves, 0.0).largest);
  }
  if (largest > limit.limit) {
    remark(drawn, fmt::format("comb cut at |κ| = {:.3g}; largest {:.3g}", limit.limit, largest));
  }
}

}  // namespace

Panel draw_plane(const PanelRecord& panel, const Context& context, DataFile& data) {
  check_window(panel, context);
  const Cells cells = cells_of(panel, context);
  Panel drawn;
  drawn.title = panel.title;
  drawn.plane = true;
  drawn.range = frame_of(panel, cells);
  const auto lines = enter_cells(cells, context, drawn);
  if (panel.comb) draw_combs(panel, cells, context, drawn, data);
  for (std::size_t i = 0; i < cells.size(); ++i) draw_curves(curves_of(panel, *cells[i]), lines[i], drawn, data);
  for (const Symbol& symbol : symbols_of(panel, cells)) draw_symbol(symbol, context, drawn, data);
  if (panel.window.empty()) {
    draw_frames(panel, context, drawn, data);
    const double margin = 0.04 * std::max(size_of(drawn.range), 1e-300);
    drawn.range.x = {drawn.range.x.from - margin, drawn.range.x.to + margin};
    drawn.range.y = {drawn.range.y.from - margin, drawn.range.y.to + margin};
  } else {
    drawn.windowed = true;
    drawn.range = {{panel.window[0], panel.window[1]}, {panel.window[2], panel.window[3]}};
  }
  drawn.aspect = drawn.range.y.size() / drawn.range.x.size();
  return drawn;
}

}  // namespace kappabench::figures
