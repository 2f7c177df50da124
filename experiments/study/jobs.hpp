#pragma once

#include <string>
#include <utility>

#include "experiments/run/cell.hpp"
#include "experiments/study/notes.hpp"

namespace kappabench::study {

/// A cell of numbers: `Measure` puts rows. The data set is the first drawing's id, or what `dataset` says; the label is
/// "<work> (numbers)", or what `label` says. `Measure` is a function, not a closure: what it fits and measures it takes
/// from `uses`, which makes the cell's key.
template <void (*Measure)(const Uses&, Notes&)>
[[nodiscard]] CellJob numbers_job(Uses uses, std::string dataset = {}, std::string label = {}) {
  if (dataset.empty() && !uses.drawings.empty()) dataset = uses.drawings.front().id;
  if (label.empty()) label = uses.work + " (numbers)";
  return {.dataset = std::move(dataset),
          .label = std::move(label),
          .uses = std::move(uses),
          .compute = [](const Uses& used, store::CellRecord& cell) {
            Notes notes(cell);
            Measure(used, notes);
          }};
}

template <void (*Measure)(const Uses&, const Input&, Notes&)>
void measure_every_curve(const Uses& uses, Notes& notes) {
  for (const Drawing& drawing : uses.drawings)
    for (const Input& input : drawing.curves) Measure(uses, input, notes);
}

/// The same for a `Measure` of one curve, called for every curve of the drawings.
template <void (*Measure)(const Uses&, const Input&, Notes&)>
[[nodiscard]] CellJob curves_job(Uses uses, std::string dataset = {}, std::string label = {}) {
  return numbers_job<measure_every_curve<Measure>>(std::move(uses), std::move(dataset), std::move(label));
}

/// Is the fit one to count? Converged, with a curve.
[[nodiscard]] inline bool solved(const Fit& fit) {
  return fit.report.outcome == Outcome::converged && fit.curve.has_value();
}

}  // namespace kappabench::study
