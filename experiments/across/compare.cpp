// Every scheme on every drawing, by every metric.
#include "experiments/across/compare.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "experiments/study/experiment.hpp"
#include "experiments/study/given_job.hpp"
#include "experiments/study/selection.hpp"

namespace kappabench {
namespace {

constexpr std::string_view about =
    "Every scheme on the same points, drawn with its curvature comb, and every metric beside it. A fit that did not "
    "converge, or input that a scheme does not take, is a row like any other. Unless drawings are named, those with "
    "more than 200 points in a curve are left out.";

/// Larger drawings are left to the study of growth, unless they are asked for: one of them takes as long as fifty of
/// the others.
constexpr int most_points_by_default = 200;

bool too_large(const Context& context, const Drawing& drawing) {
  return context.datasets.empty() &&
         std::ranges::any_of(drawing.curves, [](const Input& input) { return input.size() > most_points_by_default; });
}

std::vector<CellJob> jobs(const Context& context) {
  const std::vector<SchemePtr> schemes = study::schemes_of(context);
  const std::vector<const Metric*> metrics = study::metrics_of(context);
  std::vector<CellJob> jobs;
  for (const Drawing& drawing : study::drawings_of(context)) {
    if (too_large(context, drawing)) continue;
    for (const SchemePtr& scheme : schemes) jobs.push_back(study::measure_job(drawing, scheme, metrics));
  }
  return jobs;
}

void conclude(study::Findings& found) {
  found.add(comparison::scheme_table(found));
  found.add(comparison::curve_table(found));
  if (const auto distances = comparison::distance_table(found)) found.add(*distances);
  found.add(comparison::profile_table(found));
  for (const study::Table& table : comparison::distribution_tables(found)) found.add(table);
  for (store::FigureRecord& figure : comparison::drawing_figures(found)) found.add(std::move(figure));
  found.add(comparison::distribution_figure());
  found.add(comparison::curvature_figure(found));
  found.add(comparison::convergence_figure(found));
}

}  // namespace

Experiment compare_experiment() {
  return study::experiment({.id = "compare",
                            .title = "All schemes on all drawings",
                            .about = std::string(about),
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
