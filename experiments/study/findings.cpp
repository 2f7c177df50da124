#include "experiments/study/findings.hpp"

#include <algorithm>
#include <utility>

namespace kappabench::study {

std::optional<int> Findings::find(std::string_view dataset, std::string_view label) const {
  for (std::size_t i = 0; i < cells().size(); ++i)
    if (cells()[i].dataset == dataset && cells()[i].label == label) return static_cast<int>(i);
  return std::nullopt;
}

std::vector<int> Findings::labelled(std::string_view label) const {
  std::vector<int> found;
  for (std::size_t i = 0; i < cells().size(); ++i)
    if (cells()[i].label == label) found.push_back(static_cast<int>(i));
  return found;
}

std::vector<std::string> Findings::drawn() const {
  std::vector<std::string> names;
  for (const store::CellRecord& cell : cells())
    if (!cell.curves.empty() && std::ranges::find(names, cell.dataset) == names.end()) names.push_back(cell.dataset);
  return names;
}

const store::CurveRecord* Findings::curve(int index) const {
  const auto& curves = cell(index).curves;
  return curves.empty() || curves.front().sample_x.empty() ? nullptr : &curves.front();
}

void Findings::add(store::FigureRecord figure) {
  if (!figure.panels.empty()) record_->figures.push_back(std::move(figure));
}

void Findings::claim(std::string_view id, std::string verdict, std::string ours, std::string evidence) {
  record_->claims.push_back({.paper = std::string(paper_),
                             .claim = std::string(id),
                             .verdict = std::move(verdict),
                             .ours = std::move(ours),
                             .evidence = std::move(evidence)});
}

}  // namespace kappabench::study
