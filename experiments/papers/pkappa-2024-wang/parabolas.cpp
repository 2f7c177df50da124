#include "experiments/papers/pkappa-2024-wang/parabolas.hpp"

#include <algorithm>
#include <utility>

#include "experiments/papers/pkappa-2024-wang/energies.hpp"
#include "experiments/study/jobs.hpp"
#include "metrics/parabola_energy.hpp"

namespace kappabench::wang {

namespace {

const study::Key segment_key{"segment"};
const study::Quantity a0{"a0", "1/length", Method::sampled}, a1{"a1", "1/length", Method::sampled},
    a2{"a2", "1/length", Method::sampled};

/// Fits once more for the parabolas: a stored curve is numbers and cannot be evaluated.
void fit_measure_and_keep_parabolas(const Uses& uses, store::CellRecord& cell) {
  fit_and_measure(uses, cell);
  study::Notes notes(cell);
  for (const Input& input : uses.drawings.front().curves) {
    const Fit fit = uses.schemes.front()->fit(input);
    if (!fit.curve) continue;
    for (const Node& node : inner_nodes(*fit.curve)) {
      const Parabola q = best_parabola(fit.curve->segment(node.segment), node.t).parabola;
      notes.row({segment_key(node.segment)}, {a0(q.a0), a1(q.a1), a2(q.a2)});
    }
  }
}

}  // namespace

CellJob profiled_job(const Drawing& drawing, const SchemePtr& scheme, std::string label,
                     std::vector<const Metric*> metrics) {
  metrics.push_back(&find_metric("parabola_energy"));
  return {
      .dataset = drawing.id,
      .label = std::move(label),
      .uses = {.work = "fit with parabolas", .schemes = {scheme}, .drawings = {drawing}, .metrics = std::move(metrics)},
      .compute = fit_measure_and_keep_parabolas};
}

study::Table parabola_table(const study::Findings& found, std::string id, const std::vector<int>& cells, int steps) {
  study::Table table(std::move(id), "Curvature and its parabola",
                     "Curvature of the segments and the parabola nearest to it (Eq. (3)) with its vertex at the "
                     "segment's point, against the segment's number plus t.");
  table.words("curve").numbers("segment + t").numbers("curvature", "1/length").numbers("parabola", "1/length");
  table.numbers("difference", "1/length");
  for (const int c : cells) {
    const store::CurveRecord* curve = found.curve(c);
    if (curve == nullptr) continue;
    const store::CellRecord& cell = found.cell(c);
    const int samples = curve->samples_per_segment, stride = std::max(1, (samples - 1) / steps);
    std::size_t s = 0;
    for (const study::Row* row :
         found.rows().where({study::key::dataset(cell.dataset), study::key::label(cell.label)})) {
      for (int j = 0; j < samples; j += stride) {
        const double t = static_cast<double>(j) / (samples - 1);
        const double kappa = curve->sample_kappa[s * static_cast<std::size_t>(samples) + static_cast<std::size_t>(j)];
        const double parabola = (*row)[a0] + t * ((*row)[a1] + t * (*row)[a2]);
        table.row({cell.label, static_cast<double>(s) + t, kappa, parabola, kappa - parabola});
      }
      ++s;
    }
  }
  return table;
}

study::Panel parabola_panel(std::string title, std::string table, std::string x_label) {
  return study::Panel::graph(std::move(table), "segment + t", {"curvature", "parabola"}, std::move(title))
      .labels(std::move(x_label), "κ");
}

study::Panel difference_panel(std::string title, std::string table) {
  return study::Panel::graph(std::move(table), "segment + t", {"difference"}, std::move(title))
      .labels("segment + t", "κ - parabola");
}

}  // namespace kappabench::wang
