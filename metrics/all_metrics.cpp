#include <algorithm>
#include <optional>
#include <stdexcept>

#include "metrics/continuity.hpp"
#include "metrics/extremum_offset.hpp"
#include "metrics/fairness.hpp"
#include "metrics/features.hpp"
#include "metrics/invariance.hpp"
#include "metrics/locality.hpp"
#include "metrics/metric.hpp"
#include "metrics/monotone_intervals.hpp"
#include "metrics/parabola_energy.hpp"
#include "metrics/statistics.hpp"
#include "schemes/api/frame.hpp"
#include "schemes/api/known_words.hpp"

namespace kappabench {
namespace {

/// Finite positions and derivatives wherever it is looked at, and points that are not all in one place.
bool measurable(const Fit& fit) {
  if (!fit.curve || !(mean_chord(fit.input) > 0.0)) return false;
  const CurveSamples samples = sample(*fit.curve, 5, 3);
  const bool finite = std::all_of(samples.jets.begin(), samples.jets.end(), [](const Jet& jet) {
    return std::all_of(jet.d.begin(), jet.d.begin() + 4, [](const Vec2& d) { return d.allFinite(); });
  });
  const bool has_length =
      std::any_of(samples.jets.begin(), samples.jets.end(), [](const Jet& jet) { return jet.d[1].norm() > 0.0; });
  return finite && has_length;
}

}  // namespace

Metric guarded(Metric metric) {
  metric.measure = [inner = metric](const Scheme& scheme, const Fit& fit) {
    // A scheme that is not similarity invariant is asked to fit again where the drawing lies.
    const bool in_frame = !inner.refits || scheme.info().traits.similarity_invariant;
    const Placement frame = fit.curve ? frame_of(fit.input) : Placement{};
    std::optional<Fit> moved;
    if (!frame.is_identity()) moved = place(fit, frame.inverse());
    const Fit& local = moved ? *moved : fit;
    std::vector<Measurement> row;
    if (!measurable(local)) {
      for (const Column& column : inner.columns) row.push_back(column(undefined, Method::sampled));
      return row;
    }
    row = inner.measure(scheme, in_frame ? local : fit);
    if (!std::ranges::equal(row, inner.columns, {}, &Measurement::column, &Column::name))
      throw std::logic_error("metric " + inner.id + " does not give the columns that it declares, in their order");
    for (Measurement& number : row)
      if (in_frame && number.unit == "1/length") number.value /= frame.scale;
    return row;
  };
  return metric;
}

namespace {

std::vector<Metric> make_metrics() {
  std::vector<Metric> metrics{parabola_energy_metric(), monotone_intervals_metric(), locality_metric(),
                              continuity_metric(),      extremum_offset_metric(),    fairness_metric(),
                              features_metric(),        invariance_metric(),         roundness_metric()};
  std::transform(metrics.begin(), metrics.end(), metrics.begin(), guarded);
  return metrics;
}

}  // namespace

std::string_view name(Method method) {
  switch (method) {
    case Method::exact:
      return "exact";
    case Method::enclosed:
      return "enclosed";
    case Method::sampled:
      return "sampled";
  }
  throw std::logic_error("name(Method): not a value of the enumeration");
}

std::span<const Metric> all_metrics() {
  static const std::vector<Metric> metrics = make_metrics();
  return metrics;
}

const Metric& find_metric(std::string_view id) {
  std::vector<std::string> known;
  for (const Metric& metric : all_metrics()) {
    if (metric.id == id) return metric;
    known.push_back(metric.id);
  }
  throw std::invalid_argument("unknown metric '" + std::string(id) + "'; " + known_words(id, known));
}

}  // namespace kappabench
