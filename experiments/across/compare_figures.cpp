#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>

#include "experiments/across/compare.hpp"

namespace kappabench::comparison {
namespace {

using study::Findings, study::Panel;

/// Drawings shown when nobody chose any: of each kind one. The tables have all.
constexpr std::array<std::string_view, 8> shown_by_default{
    "bird", "christmas-tree", "circle-uneven", "letter-r", "near-collinear", "s-inflections", "star", "very-uneven"};

bool by_default(std::string_view dataset) {
  return std::ranges::find(shown_by_default, dataset) != shown_by_default.end();
}

/// The cells drawing by drawing: those of a drawing come one after the other.
std::vector<std::pair<std::string, std::vector<int>>> cells_by_drawing(const Findings& found) {
  std::vector<std::pair<std::string, std::vector<int>>> drawings;
  for (int i = 0; i < static_cast<int>(found.cells().size()); ++i) {
    const std::string& dataset = found.cell(i).dataset;
    if (drawings.empty() || drawings.back().first != dataset) drawings.push_back({dataset, {}});
    drawings.back().second.push_back(i);
  }
  return drawings;
}

using PanelOf = Panel (*)(std::vector<int> cells, std::string title);

/// All schemes over one another for the first few drawings of which more than one cell is `drawable`.
std::vector<store::PanelRecord> overlays(const Findings& found, PanelOf panel_of,
                                         const std::function<bool(const store::CellRecord&)>& drawable) {
  constexpr std::size_t most_panels = 6, few_cells = 100;
  std::vector<store::PanelRecord> panels;
  for (auto& [dataset, cells] : cells_by_drawing(found)) {
    if (!by_default(dataset) && found.cells().size() >= few_cells) continue;
    std::erase_if(cells, [&](int i) { return !drawable(found.cell(i)); });
    if (cells.size() > 1 && panels.size() < most_panels) panels.push_back(panel_of(cells, dataset));
  }
  return panels;
}

bool single_curve(const store::CellRecord& cell) { return cell.curves.size() == 1; }

}  // namespace

std::vector<store::FigureRecord> drawing_figures(const Findings& found) {
  std::vector<store::FigureRecord> figures;
  for (const auto& [dataset, cells] : cells_by_drawing(found)) {
    if (found.context().datasets.empty() && !by_default(dataset)) continue;
    store::FigureRecord& figure = figures.emplace_back(store::FigureRecord{
        .id = "compare-" + dataset,
        .title = dataset,
        .caption = "Each scheme with its curvature comb, all panels to one scale. Squares: input points; small "
                   "circles: joints."});
    for (const int i : cells) figure.panels.push_back(Panel::curves({i}, found.cell(i).label).comb());
  }
  return figures;
}

store::FigureRecord curvature_figure(const Findings& found) {
  return {.id = "compare-all-curvature",
          .title = "Curvature",
          .caption = "Curvature against arc length, nodes marked.",
          .panels = overlays(found, Panel::curvature, single_curve)};
}

store::FigureRecord convergence_figure(const Findings& found) {
  const auto iterates = [](const store::CellRecord& cell) {
    return single_curve(cell) && !cell.curves.front().trace.empty();
  };
  return {.id = "compare-all-convergence",
          .title = "Convergence",
          .caption = "Residual of each scheme's own equations, scale-free, before and after each iteration.",
          .panels = overlays(found, Panel::convergence, iterates)};
}

}  // namespace kappabench::comparison
