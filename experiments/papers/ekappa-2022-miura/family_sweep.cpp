#include "experiments/papers/ekappa-2022-miura/family_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <string_view>
#include <utility>

#include "datasets/datasets.hpp"
#include "datasets/random_points.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/selection.hpp"
#include "schemes/kappa/marks.hpp"

namespace kappabench::miura {

namespace {

using study::Notes;

const study::Key sharpness{"a"};

/// Raise when a sweep counts differently.
constexpr int sweep_version = 1;

/// d|kappa|/ds up to a positive factor.
double slope_of_magnitude(const Segment& segment, double t) {
  const Jet jet = segment.jet(t, 3);
  return curvature(jet) < 0.0 ? -curvature_derivative(jet) : curvature_derivative(jet);
}

AtPoint shape(double before, double after) {
  if (before > 0.0 && after < 0.0) return AtPoint::peak;
  if (before < 0.0 && after > 0.0) return AtPoint::valley;
  return AtPoint::passes;
}

/// What |kappa| does across the joint at which a pinned point sits.
AtPoint curvature_across(const Curve& curve, const Node& node, double step) {
  const int last = curve.size() - 1;
  const int before = node.t > 0.5 ? node.segment : node.segment > 0 ? node.segment - 1 : last;
  return shape(slope_of_magnitude(curve.segment(before), 1.0 - step),
               slope_of_magnitude(curve.segment(curve.next(before)), step));
}

/// Counts of one curve or of many.
using Counts = std::map<std::string, study::Reading>;

void count(Counts& counts, const study::Quantity& what, bool holds = true) {
  counts.try_emplace(what.name, what(0)).first->second.value += holds ? 1.0 : 0.0;
}

void count_nodes(Counts& counts, const Input& input, const Curve& curve) {
  for (const Node& node : curve.nodes()) {
    // The ends of an open curve have no segment of their own.
    if (!input.closed && (node.point == 0 || node.point == input.size() - 1)) continue;
    count(counts, points);
    count(counts, pinned, node.has(kappa::marks::pinned));
    count(counts, at_inflection, node.has(kappa::marks::at_inflection));
    count(counts, minima, node.has(kappa::marks::curvature_minimum));
    if (node.has(kappa::marks::at_inflection)) continue;
    if (node.has(kappa::marks::pinned)) {
      count(counts, pinned_peaks, curvature_across(curve, node, 1e-3) == AtPoint::peak);
      continue;
    }
    const AtPoint at = curvature_at(curve, node);
    count(counts, at == AtPoint::peak ? peaks : at == AtPoint::valley ? valleys : neither);
  }
}

void count_curve(Counts& counts, const Scheme& scheme, const Input& input) {
  const Fit fit = scheme.fit(input);
  const bool solved = fit.report.outcome == Outcome::converged;
  const bool is_straight = solved && !fit.report.counters.contains("pinned");
  count(counts, curves);
  count(counts, unsupported, fit.report.outcome == Outcome::unsupported_input);
  count(counts, converged, solved);
  count(counts, straight, is_straight);
  if (solved && !is_straight) count_nodes(counts, input, *fit.curve);
}

/// A row of all counts, zeros too.
void put(Notes& notes, std::vector<study::KeyIs> keys, Counts counts) {
  for (const auto* what : {&curves, &converged, &unsupported, &straight, &points, &pinned, &at_inflection, &minima,
                           &peaks, &valleys, &neither, &pinned_peaks})
    counts.try_emplace(what->name, (*what)(0));
  std::vector<study::Reading> readings;
  for (const auto& [name, reading] : counts) readings.push_back(reading);
  notes.row(keys, readings);
}

double a_of(const Scheme& scheme) {
  return scheme.parameters().values().contains("a") ? scheme.parameters().real("a") : 2.0 / 3.0;
}

void sweep(const Uses& uses, Notes& notes) {
  const Scheme& scheme = *uses.schemes.front();
  for (const Drawing& drawing : uses.drawings) {
    Counts counts;
    for (const Input& input : drawing.curves) count_curve(counts, scheme, input);
    put(notes, {counted(drawing.id), sharpness(a_of(scheme))}, counts);
  }
}

/// An open and a closed curve of a random family for each of the sizes, which may come several times.
Drawing random_inputs(RandomKind kind, std::uint64_t seed, const std::vector<int>& sizes) {
  Drawing inputs{.id = fmt::format("random {}", name(kind))};
  std::uint64_t number = 0;
  for (const int n : sizes)
    for (const bool closed : {false, true})
      inputs.curves.push_back(random_input(kind, n, 100003 * seed + number++, closed));
  return inputs;
}

}  // namespace

AtPoint curvature_at(const Curve& curve, const Node& node, double sides) {
  const Segment& segment = curve.segment(node.segment);
  const double step = sides * std::min(node.t, 1.0 - node.t);
  return shape(slope_of_magnitude(segment, node.t - step), slope_of_magnitude(segment, node.t + step));
}

std::vector<CellJob> sweep_jobs(const Context& context, const std::vector<SchemePtr>& schemes) {
  std::vector<std::pair<std::string, std::vector<Drawing>>> groups;
  if (context.datasets.empty())
    groups.emplace_back("drawings", study::without_long_curves(study::without_options(builtin_drawings()), 100));
  for (const std::string& dataset : context.datasets)
    groups.emplace_back(dataset, study::without_options(open_drawings(dataset)));
  std::vector<CellJob> jobs;
  const auto add = [&jobs](const SchemePtr& scheme, std::vector<Drawing> drawings, const std::string& dataset) {
    jobs.push_back(study::numbers_job<sweep>(
        {.work = "sweep", .version = sweep_version, .schemes = {scheme}, .drawings = std::move(drawings)}, dataset,
        label_of(*scheme)));
  };
  for (const SchemePtr& scheme : schemes) {
    for (const auto& [dataset, drawings] : groups) add(scheme, drawings, dataset);
    if (!context.datasets.empty()) continue;
    // The trigonometric basis is slow where a small a leaves it without a solution.
    const std::vector<int> sizes = scheme->info().id == "ekappa-trig"
                                       ? std::vector{3, 3, 5, 5, 7, 7, 10, 10, 15, 15}
                                       : std::vector{3, 3, 5, 5, 7, 7, 10, 10, 15, 15, 22, 22, 33, 50};
    for (const RandomKind kind : random_kinds()) {
      const Drawing inputs = random_inputs(kind, context.seed, sizes);
      add(scheme, {inputs}, inputs.id);
    }
  }
  return jobs;
}

std::vector<SchemePtr> sharpness_ladder(const Context& context) {
  std::vector<SchemePtr> schemes;
  for (const std::string& text : context.schemes) schemes.push_back(context.registry.parse(text));
  if (!schemes.empty()) return schemes;
  for (const double a : {2.0 / 3.0, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95})
    schemes.push_back(context.registry.create("ekappa", {{"a", a}}));
  for (const double a : {0.5, 0.55, 0.6, 0.75, 0.9})
    schemes.push_back(context.registry.create("ekappa-trig", {{"a", a}}));
  return schemes;
}

std::vector<Swept> sweeps(const study::Findings& found) {
  std::vector<Swept> swept;
  for (const store::CellRecord& cell : found.cells()) {
    const study::Rows rows = found.rows().where({study::key::dataset(cell.dataset), study::key::label(cell.label)});
    if (!rows.empty())
      swept.push_back({cell.dataset, cell.scheme, std::get<double>((**rows.begin())[sharpness]), rows});
  }
  return swept;
}

std::string shares_by_a(const std::vector<Swept>& sweeps, double (*part)(const Swept&)) {
  std::map<double, std::pair<double, double>> by_a;
  for (const Swept& swept : sweeps) {
    auto& [some, all] = by_a[swept.a];
    some += part(swept);
    all += swept[points];
  }
  std::string words;
  for (const auto& [a, counts] : by_a)
    words +=
        fmt::format("{}{:.3g} % at a = {:.3g}", words.empty() ? "" : ", ", 100.0 * counts.first / counts.second, a);
  return words;
}

}  // namespace kappabench::miura
