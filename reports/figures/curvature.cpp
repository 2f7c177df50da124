#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/figures/panel.hpp"

namespace kappabench::figures {
namespace {

using store::CurveRecord;

/// Curves of one drawing laid end to end on [0, 1].
struct Line {
  std::vector<const CurveRecord*> curves;
  std::vector<double> starts;
  double length = 0.0;
  [[nodiscard]] double at(std::size_t curve, double s) const { return (starts[curve] + s) / length; }
};

Line laid_out(const std::vector<const CurveRecord*>& curves) {
  Line line;
  for (const auto* curve : curves) {
    if (curve->sample_s.empty()) continue;
    line.curves.push_back(curve);
    line.starts.push_back(line.length);
    line.length += curve->sample_s.back();
  }
  if (!(line.length > 0.0)) line = {};
  return line;
}

/// Broken at every joint: a jump of curvature is a gap between two ends, not a steep line.
Rows graph_rows(const Line& line) {
  Rows rows;
  for (std::size_t c = 0; c < line.curves.size(); ++c) {
    const CurveRecord& curve = *line.curves[c];
    const auto step = static_cast<std::size_t>(std::max(curve.samples_per_segment, 0));
    for (std::size_t i = 0; i < curve.sample_s.size(); ++i) {
      if (i == 0 || (step > 0 && i % step == 0)) rows.gap();
      if (std::isfinite(curve.sample_kappa[i])) rows.add({line.at(c, curve.sample_s[i]), curve.sample_kappa[i]});
    }
  }
  return rows;
}

/// Ticks that stand on the lower edge, those of one scheme beside those of the next.
Rows joint_rows(const Line& line, double foot, double height) {
  Rows rows;
  for (std::size_t c = 0; c < line.curves.size(); ++c) {
    for (const double s : line.curves[c]->joint_s) rows.add({line.at(c, s), foot, 0.0, height});
  }
  return rows;
}

Rows node_rows(const Line& line) {
  Rows rows;
  for (std::size_t c = 0; c < line.curves.size(); ++c) {
    const CurveRecord& curve = *line.curves[c];
    for (std::size_t i = 0; i < curve.node_s.size(); ++i) {
      if (std::isfinite(curve.node_kappa[i])) rows.add({line.at(c, curve.node_s[i]), curve.node_kappa[i]});
    }
  }
  return rows;
}

}  // namespace

Panel draw_curvature(const store::PanelRecord& panel, const Context& context, DataFile& data) {
  Panel drawn;
  drawn.title = panel.title;
  const auto cells = cells_of(panel, context);
  const auto styles = enter_cells(cells, context, drawn);
  std::vector<Line> lines;
  std::vector<double> curvatures;
  std::vector<const CurveRecord*> shown;
  double length = 0.0;
  for (const auto* cell : cells) {
    lines.push_back(laid_out(curves_of(panel, *cell)));
    length = std::max(length, lines.back().length);
    for (const auto* curve : lines.back().curves) {
      shown.push_back(curve);
      curvatures.insert(curvatures.end(), curve->sample_kappa.begin(), curve->sample_kappa.end());
    }
  }
  const CurvatureLimit limit = curvature_limit(shown, length > 0.0 ? 60.0 / length : 0.0);
  const Interval all = extent(curvatures).value_or(Interval{-1.0, 1.0});
  drawn.range.y =
      padded({std::min(0.0, std::max(all.from, -limit.limit)), std::max(0.0, std::min(all.to, limit.limit))}, 0.08);
  if (panel.window.size() == 4) {
    drawn.range = {{panel.window[0], panel.window[1]}, {panel.window[2], panel.window[3]}};
  } else if (limit.clips()) {
    remark(drawn, fmt::format("off the scale: |κ| reaches {:.3g}", limit.largest));
  }
  drawn.setup = {"set xlabel 'arc length / total length'", "set ylabel 'curvature κ'",
                 "set xzeroaxis lw 1 lc rgb '#B0B0B0'"};
  // A band under the graphs for the ticks of all cells, one row each.
  const auto rows = static_cast<double>(std::max<std::size_t>(cells.size(), 1));
  const double band = std::min(0.045 * rows, 0.18) * drawn.range.y.size(), row = band / rows;
  drawn.range.y.from -= band;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string colour = context.key.colour(label_of(*cells[i]));
    const double foot = drawn.range.y.from + row * static_cast<double>(i);
    plot(drawn, data, "curvature: s over the length, kappa", graph_rows(lines[i]), "with lines " + styles[i]);
    plot(drawn, data, "joints: s over the length, foot, 0, height", joint_rows(lines[i], foot, 0.85 * row),
         fmt::format("with vectors nohead lw 1.4 lc rgb '{}'", colour));
    plot(drawn, data, "nodes: s over the length, kappa", node_rows(lines[i]),
         fmt::format("with points pt 5 ps 0.55 lc rgb '{}'", colour));
  }
  context.key.add({"joint (tick), node (square)", "", "pt 5 ps 0.6 lc rgb '#404040'"});
  return drawn;
}

}  // namespace kappabench::figures
