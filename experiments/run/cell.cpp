#include "experiments/run/cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "experiments/run/record.hpp"

namespace kappabench {

namespace {

/// From best to worst.
int severity(std::string_view outcome) {
  constexpr std::array<Outcome, 6> order{Outcome::converged, Outcome::unsupported_input, Outcome::not_converged,
                                         Outcome::failed,    Outcome::timed_out,         Outcome::crashed};
  return static_cast<int>(std::ranges::find(order, outcome, [](Outcome o) { return name(o); }) - order.begin());
}

}  // namespace

std::string label_of(const Scheme& scheme) {
  const std::string brief = scheme.parameters().brief();
  return brief.empty() ? scheme.info().id : fmt::format("{} {}", scheme.info().id, brief);
}

store::CellRecord compute(const CellJob& job) {
  store::CellRecord cell;
  cell.outcome = name(Outcome::converged);
  job.compute(job.uses, cell);
  return cell;
}

void fit_and_measure(const Uses& uses, store::CellRecord& cell) {
  const Scheme& scheme = *uses.schemes.front();
  for (const Drawing& drawing : uses.drawings)
    for (std::size_t i = 0; i < drawing.curves.size(); ++i) {
      cell.curves.push_back(record_of(scheme, scheme.fit(drawing.curves[i]), uses.metrics));
      const store::CurveRecord& curve = cell.curves.back();
      if (severity(curve.outcome) <= severity(cell.outcome)) continue;
      cell.outcome = curve.outcome;
      cell.message = drawing.curves.size() == 1 ? curve.message : fmt::format("curve {}: {}", i, curve.message);
    }
}

CellJob fit_job(const Drawing& drawing, const SchemePtr& scheme, std::vector<const Metric*> metrics) {
  return fit_job(drawing, scheme, std::move(metrics), label_of(*scheme));
}

CellJob fit_job(const Drawing& drawing, const SchemePtr& scheme, std::vector<const Metric*> metrics,
                std::string label) {
  return {.dataset = drawing.id,
          .label = std::move(label),
          .uses = {.work = "fit", .schemes = {scheme}, .drawings = {drawing}, .metrics = std::move(metrics)},
          .compute = fit_and_measure};
}

void name_cell(store::CellRecord& cell, const CellJob& job) {
  cell.dataset = job.dataset;
  cell.label = job.label;
  cell.key = job.key();
  if (job.uses.schemes.empty()) return;
  cell.scheme = job.uses.schemes.front()->info().id;
  cell.parameters = job.uses.schemes.front()->parameters().canonical();
}

}  // namespace kappabench
