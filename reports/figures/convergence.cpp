#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/figures/panel.hpp"

namespace kappabench::figures {
namespace {

constexpr double floor_residual = 1e-17;  ///< where an exact zero is drawn

double shown(double residual) { return std::max(residual, floor_residual); }

}  // namespace

Panel draw_convergence(const store::PanelRecord& panel, const Context& context, DataFile& data) {
  Panel drawn;
  drawn.title = panel.title;
  const auto cells = cells_of(panel, context);
  const auto styles = enter_cells(cells, context, drawn);
  double iterations = 1.0, lowest = 1.0, highest = floor_residual;
  bool at_floor = false;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    Rows rows, ends;
    for (const auto* curve : curves_of(panel, *cells[c])) {
      rows.gap();
      double number = panel.log_x ? 1.0 : 0.0;  // the residual before the first iteration comes first
      double last = 0.0;
      for (const double residual : curve->trace) {
        if (std::isfinite(residual)) {
          last = shown(residual);
          rows.add({number, last});
          lowest = std::min(lowest, last);
          highest = std::max(highest, last);
          iterations = std::max(iterations, number);
          at_floor = at_floor || residual < floor_residual;
        }
        number += 1.0;
      }
      if (last > 0.0) ends.add({number - 1.0, last});
    }
    plot(drawn, data, "trace: iteration, residual", rows, "with lines " + styles[c]);
    plot(drawn, data, "ends: iteration, residual", ends,
         fmt::format("with points pt {} ps 0.8 lc rgb '{}'", context.key.marker(label_of(*cells[c])),
                     context.key.colour(label_of(*cells[c]))));
  }
  if (at_floor) remark(drawn, "residual 0 is drawn at 1e-17");
  const double decades = std::ceil(std::log10(std::max(highest, lowest))) - std::floor(std::log10(lowest));
  drawn.range.x = panel.log_x ? Interval{1.0, iterations * 1.1} : Interval{0.0, iterations * 1.03};
  drawn.range.y = {std::pow(10.0, std::floor(std::log10(lowest)) - 0.2),
                   std::pow(10.0, std::ceil(std::log10(highest)) + 0.2)};
  drawn.setup = {fmt::format("set xlabel {}", text_in_gnuplot(panel.log_x ? "iteration + 1" : "iteration")),
                 "set ylabel 'residual'", "set logscale y", "set format y '10^{%T}'",
                 fmt::format("set ytics {:g}", std::pow(10.0, std::max(1.0, std::ceil(decades / 7.0))))};
  if (panel.log_x) drawn.setup.emplace_back("set logscale x");
  if (!panel.log_x && iterations <= 10.0) drawn.setup.emplace_back("set xtics 1");
  return drawn;
}

}  // namespace kappabench::figures
