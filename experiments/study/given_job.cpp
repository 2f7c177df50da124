#include "experiments/study/given_job.hpp"

#include <cmath>
#include <utility>

#include "experiments/study/notes.hpp"
#include "metrics/statistics.hpp"

namespace kappabench::study {

namespace {

void note_distances(const store::CurveRecord& curve, std::size_t index, double chord, Notes& notes) {
  for (std::size_t i = 0; i < curve.node_point.size(); ++i) {
    const auto point = static_cast<std::size_t>(curve.node_point[i]);
    const double distance = std::hypot(curve.node_x[i] - curve.point_x[point], curve.node_y[i] - curve.point_y[point]);
    notes.row({given::curve(index), given::point(point)},
              {given::distance(distance), given::distance_over_chord(distance / chord)});
  }
}

void measure_given(const Uses& uses, store::CellRecord& cell) {
  fit_and_measure(uses, cell);
  Notes notes(cell);
  for (std::size_t i = 0; i < cell.curves.size(); ++i) {
    cell.curves[i].seconds = undefined;
    note_distances(cell.curves[i], i, mean_chord(uses.drawings.front().curves[i]), notes);
  }
}

}  // namespace

CellJob measure_job(const Drawing& drawing, const SchemePtr& scheme, std::vector<const Metric*> metrics) {
  if (dynamic_cast<const GivenCurves*>(scheme.get()) == nullptr) return fit_job(drawing, scheme, std::move(metrics));
  std::erase_if(metrics, [](const Metric* metric) { return metric->refits; });
  CellJob job = fit_job(drawing, scheme, std::move(metrics));
  job.uses.work = "measure given curves";
  job.compute = measure_given;
  return job;
}

}  // namespace kappabench::study
