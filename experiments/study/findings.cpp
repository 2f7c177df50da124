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

void Findings::judge(std::string_view id, const Tally& sample, Said said) {
  add_claim(id, ruling(printed_claim(paper_, id).kind, sample), std::move(said));
}

void Findings::judge(std::string_view id, const Interval& measured, Said said) {
  add_claim(id, ruling(printed_claim(paper_, id), measured), std::move(said));
}

void Findings::judge_formula(std::string_view id, const Tally& printed, const Tally& corrected, Said said) {
  add_claim(id, ruling_on_formula(printed, corrected), std::move(said));
}

void Findings::undecidable(std::string_view id, Said said) {
  add_claim(id, {"undecidable", "", "", "decided by what is not printed"}, std::move(said));
}

void Findings::by_construction(std::string_view id, Said said) {
  add_claim(id, {"by construction", "", "", "what was tested could not have failed; counts in no total"},
            std::move(said));
}

void Findings::add_claim(std::string_view id, Ruling ruling, Said said) {
  record_->claims.push_back({.paper = std::string(paper_),
                             .claim = std::string(id),
                             .verdict = std::move(ruling.verdict),
                             .ours = std::move(said.ours),
                             .evidence = std::move(said.evidence),
                             .method = std::move(said.method),
                             .kind = std::string(name(printed_claim(paper_, id).kind)),
                             .sample = std::move(ruling.sample),
                             .interval = std::move(ruling.interval),
                             .rule = std::move(ruling.rule)});
}

}  // namespace kappabench::study
