#include "reports/figures/figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "reports/figures/panel.hpp"

namespace kappabench {
namespace {

using namespace figures;

constexpr double title_height = 28.0, note_height = 24.0, legend_row = 26.0, gap = 14.0;
constexpr double left_axis = 86.0, bottom_axis = 58.0, right_edge = 16.0;
constexpr double glyph_width = 0.6 * font_size;

Panel draw_panel(const store::PanelRecord& panel, const Context& context, DataFile& data) {
  if (panel.kind == "curve") return draw_plane(panel, context, data);
  if (panel.kind == "curvature") return draw_curvature(panel, context, data);
  if (panel.kind == "convergence") return draw_convergence(panel, context, data);
  if (panel.kind == "graph") return draw_graph(panel, context, data);
  throw std::invalid_argument(fmt::format(
      "figure '{}': unknown kind of panel '{}' (curve, curvature, convergence, graph)", context.figure.id, panel.kind));
}

int columns_for(const store::FigureRecord& figure) {
  const int panels = std::max<int>(1, static_cast<int>(figure.panels.size()));
  if (figure.columns > 0) return std::min(figure.columns, panels);
  constexpr int chosen[] = {1, 1, 2, 3, 2, 3, 3, 4, 4, 3};
  return panels < 10 ? chosen[panels] : 4;
}

double width_for(int columns) {
  return columns == 1 ? 680.0 : columns == 2 ? 960.0 : columns == 3 ? 1080.0 : 290.0 * columns;
}

/// A rectangle in pixels from the lower left corner.
struct Place {
  double x, y, width, height;
};

/// Everything in pixels, before the script turns it into fractions.
struct Layout {
  double width = 0.0, height = 0.0;
  std::vector<Place> boxes;  ///< the plotting area of each panel
  std::vector<Place> slots;  ///< what belongs to each panel, with title and axes
  double legend_top = 0.0;
  int legend_columns = 1;
  double legend_step = 0.0;
};

std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

Layout lay_out(const std::vector<Panel>& panels, const std::vector<LegendEntry>& legend, int columns) {
  Layout layout;
  layout.width = width_for(columns);
  const double slot_width = (layout.width - gap * (columns + 1)) / columns;
  const auto per_row = static_cast<std::size_t>(columns);
  const std::size_t rows = (panels.size() + per_row - 1) / per_row;
  std::vector<double> heights(rows, 0.0);
  const auto inner_width = [&](const Panel& p) { return p.plane ? slot_width : slot_width - left_axis - right_edge; };
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Panel& p = panels[i];
    const double most = p.plane ? 1.05 : 0.9;
    const double box = inner_width(p) * std::clamp(p.aspect, 0.3, most);
    double& height = heights[i / per_row];
    height = std::max(height, box + (p.plane ? 0.0 : bottom_axis) + title_height + note_height);
  }
  double longest = 0.0;
  for (const auto& entry : legend)
    longest = std::max(longest, 60.0 + glyph_width * static_cast<double>(characters(entry.text)));
  layout.legend_columns = std::max(1, std::min(static_cast<int>((layout.width - 2 * gap) / std::max(longest, 1.0)),
                                               static_cast<int>(legend.size())));
  layout.legend_step = longest;
  const double legend_height =
      legend_row * std::ceil(static_cast<double>(legend.size()) / layout.legend_columns) + (legend.empty() ? 0.0 : gap);
  layout.height = legend_height + gap;
  for (const double height : heights) layout.height += height + gap;
  layout.legend_top = legend_height;
  double top = layout.height - gap;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = row * per_row; i < std::min(panels.size(), (row + 1) * per_row); ++i) {
      const Panel& p = panels[i];
      const double left = gap + static_cast<double>(i % per_row) * (slot_width + gap);
      layout.slots.push_back({left, top - heights[row], slot_width, heights[row]});
      const double below = note_height + (p.plane ? 0.0 : bottom_axis);
      Place box{left + (p.plane ? 0.0 : left_axis), top - heights[row] + below, inner_width(p),
                heights[row] - below - title_height};
      if (p.windowed) {
        const double width = std::min(box.width, box.height / p.aspect), height = width * p.aspect;
        box = {box.x + (box.width - width) / 2, box.y + (box.height - height) / 2, width, height};
      }
      layout.boxes.push_back(box);
    }
    top -= heights[row] + gap;
  }
  return layout;
}

/// Equal units: the shorter direction gets more room on both sides.
Box fitted(const Panel& panel, const Place& box) {
  if (!panel.plane || panel.windowed) return panel.range;
  const double unit = std::max(panel.range.x.size() / box.width, panel.range.y.size() / box.height);
  const auto widened = [unit](Interval range, double pixels) {
    const double middle = 0.5 * (range.from + range.to);
    return Interval{middle - 0.5 * unit * pixels, middle + 0.5 * unit * pixels};
  };
  return {widened(panel.range.x, box.width), widened(panel.range.y, box.height)};
}

std::string panel_commands(const Panel& panel, const Layout& layout, std::size_t index) {
  const Place& box = layout.boxes[index];
  const Place& slot = layout.slots[index];
  const auto x = [&](double pixels) { return pixels / layout.width; };
  const auto y = [&](double pixels) { return pixels / layout.height; };
  const Box range = fitted(panel, box);
  std::string text = fmt::format(
      "  reset\n  unset key\n  set lmargin at screen {:.5f}\n  set rmargin at screen {:.5f}\n"
      "  set bmargin at screen {:.5f}\n  set tmargin at screen {:.5f}\n",
      x(box.x), x(box.x + box.width), y(box.y), y(box.y + box.height));
  if (!panel.title.empty()) {
    text +=
        fmt::format("  set label {} at screen {:.5f}, screen {:.5f} center noenhanced\n", text_in_gnuplot(panel.title),
                    x(box.x + box.width / 2), y(slot.y + slot.height - title_height / 2));
  }
  if (!panel.note.empty()) {
    text +=
        fmt::format("  set label {} at screen {:.5f}, screen {:.5f} center noenhanced font ',{}' tc rgb '#606060'\n",
                    text_in_gnuplot(panel.note), x(box.x + box.width / 2), y(slot.y + note_height / 2), font_size - 3);
  }
  if (panel.plane) {
    text += "  unset tics\n";
    text += panel.windowed ? "  set border 15 lw 0.8 lc rgb '#A0A0A0'\n" : "  unset border\n";
  } else {
    text += "  set border 3 lw 1\n  set tics nomirror out scale 0.6\n";
  }
  for (const auto& command : panel.setup) text += fmt::format("  {}\n", command);
  text += fmt::format("  set xrange [{:.9g}:{:.9g}]\n  set yrange [{:.9g}:{:.9g}]\n", range.x.from, range.x.to,
                      range.y.from, range.y.to);
  if (panel.plots.empty()) {
    text += fmt::format("  set label 'nothing to draw' at screen {:.5f}, screen {:.5f} center tc rgb '{}'\n",
                        x(box.x + box.width / 2), y(box.y + box.height / 2), grey);
    return text + fmt::format("  plot {:.9g} notitle lc rgb '#FFFFFF'\n", range.y.from);
  }
  return text + fmt::format("  plot {} notitle\n", fmt::join(panel.plots, " notitle, \\\n       "));
}

std::string legend_commands(const std::vector<LegendEntry>& legend, const Layout& layout) {
  if (legend.empty()) return "";
  std::string text =
      "  reset\n  unset key\n  unset border\n  unset tics\n  set lmargin at screen 0\n  set rmargin at screen 1\n"
      "  set bmargin at screen 0\n  set tmargin at screen 1\n  set xrange [0:1]\n  set yrange [0:1]\n";
  const double left = (layout.width - layout.legend_columns * layout.legend_step) / 2;
  for (std::size_t i = 0; i < legend.size(); ++i) {
    const auto columns = static_cast<std::size_t>(layout.legend_columns);
    const double x = left + layout.legend_step * static_cast<double>(i % columns);
    const double y = layout.legend_top - legend_row * (0.5 + static_cast<double>(i / columns));
    const double height = y / layout.height;
    if (!legend[i].line.empty()) {
      text += fmt::format("  set arrow from screen {:.5f}, screen {:.5f} to screen {:.5f}, screen {:.5f} nohead {}\n",
                          x / layout.width, height, (x + 38) / layout.width, height, legend[i].line);
    }
    if (!legend[i].point.empty()) {
      text += fmt::format("  set label '' at screen {:.5f}, screen {:.5f} point {}\n", (x + 19) / layout.width, height,
                          legend[i].point);
    }
    text += fmt::format("  set label {} at screen {:.5f}, screen {:.5f} left noenhanced\n",
                        text_in_gnuplot(legend[i].text), (x + 46) / layout.width, height);
  }
  return text + "  plot -1 notitle\n";
}

/// a, b, ..., z, aa, ab, ...
std::string letters(std::size_t index) {
  const std::string last(1, static_cast<char>('a' + index % 26));
  return index < 26 ? last : letters(index / 26 - 1) + last;
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

}  // namespace

FigureFiles draw_figure(const store::FigureRecord& figure, const store::ExperimentRecord& experiment,
                        const std::string& stem) {
  FigureFiles files;
  Key key;
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    DataFile data(figure.panels.size() == 1 ? stem + ".dat" : fmt::format("{}-{}.dat", stem, i + 1));
    panels.push_back(draw_panel(figure.panels[i], {experiment, figure, key}, data));
    std::string& title = panels.back().title;
    if (figure.panels.size() > 1) title = fmt::format("({}){}{}", letters(i), title.empty() ? "" : " ", title);
    files.data[data.name()] = data.text();
  }
  if (panels.empty()) throw std::invalid_argument(fmt::format("figure '{}' has no panels", figure.id));
  std::vector<LegendEntry> legend = key.entries();
  std::stable_partition(legend.begin(), legend.end(), [](const auto& entry) { return !entry.line.empty(); });
  const Layout layout = lay_out(panels, legend, columns_for(figure));
  const auto width = std::lround(layout.width), height = std::lround(layout.height);
  files.script = fmt::format(
      "# {}: {}\n# Redraw with `gnuplot {}.gp` in this folder (gnuplot 5.2 or newer with the terminals svg and "
      "pngcairo).\n"
      "set encoding utf8\n"
      "do for [format in 'svg png'] {{\n"
      "  if (format eq 'svg') {{\n"
      "    set terminal svg size {},{} enhanced font 'DejaVu Sans,{}' background '#FFFFFF'\n"
      "  }} else {{\n"
      "    set terminal pngcairo size {},{} enhanced font 'DejaVu Sans,{}' fontscale 1.5 linewidth 2 pointscale 2 "
      "background '#FFFFFF'\n"
      "  }}\n"
      "  set output {}.'.'.format\n"
      "  set multiplot\n",
      one_line(experiment.id + "/" + figure.id), one_line(figure.title), stem, width, height, font_size, 2 * width,
      2 * height, font_size, text_in_gnuplot(stem));
  for (std::size_t i = 0; i < panels.size(); ++i) files.script += panel_commands(panels[i], layout, i);
  files.script += legend_commands(legend, layout);
  files.script += "  unset multiplot\n  unset output\n}\n";
  return files;
}

}  // namespace kappabench
