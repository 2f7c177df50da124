#include "experiments/papers/ekappa-2022-miura/family_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "datasets/datasets.hpp"
#include "experiments/study/study.hpp"
#include "schemes/kappa/marks.hpp"

namespace kappabench {

namespace {

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

struct Tally {
  double curves = 0, converged = 0, unsupported = 0, straight = 0;
  double points = 0, pinned = 0, at_inflection = 0, minima = 0;
  double peaks = 0, valleys = 0, neither = 0, pinned_peaks = 0;

  Tally& operator+=(const Tally& other);
};

Tally& Tally::operator+=(const Tally& other) {
  constexpr std::array members{&Tally::curves, &Tally::converged, &Tally::unsupported,   &Tally::straight,
                               &Tally::points, &Tally::pinned,    &Tally::at_inflection, &Tally::minima,
                               &Tally::peaks,  &Tally::valleys,   &Tally::neither,       &Tally::pinned_peaks};
  for (const auto member : members) this->*member += other.*member;
  return *this;
}

void count_nodes(Tally& tally, const Input& input, const Curve& curve) {
  for (const Node& node : curve.nodes()) {
    // The ends of an open curve have no segment of their own.
    if (!input.closed && (node.point == 0 || node.point == input.size() - 1)) continue;
    ++tally.points;
    tally.pinned += node.has(kappa::marks::pinned);
    tally.at_inflection += node.has(kappa::marks::at_inflection);
    tally.minima += node.has(kappa::marks::curvature_minimum);
    if (node.has(kappa::marks::at_inflection)) continue;
    if (node.has(kappa::marks::pinned)) {
      tally.pinned_peaks += curvature_across(curve, node, 1e-3) == AtPoint::peak;
      continue;
    }
    const AtPoint at = curvature_at(curve, node);
    ++(at == AtPoint::peak ? tally.peaks : at == AtPoint::valley ? tally.valleys : tally.neither);
  }
}

Tally count(const Scheme& scheme, const Input& input) {
  const Fit fit = scheme.fit(input);
  Tally tally{.curves = 1};
  tally.unsupported = fit.report.outcome == Outcome::unsupported_input;
  tally.converged = fit.report.outcome == Outcome::converged;
  if (tally.converged == 0) return tally;
  tally.straight = !fit.report.counters.contains("pinned");
  if (tally.straight == 0) count_nodes(tally, input, *fit.curve);
  return tally;
}

double a_of(const Scheme& scheme) {
  return scheme.parameters().values().contains("a") ? scheme.parameters().real("a") : 2.0 / 3.0;
}

void record(store::CellRecord& cell, const Scheme& scheme, const Tally& tally) {
  const auto add = [&](const char* column, double value) {
    cell.measurements.push_back({column, value, "exact", "1"});
  };
  add("a", a_of(scheme));
  add("curves", tally.curves);
  add("converged", tally.converged);
  add("unsupported", tally.unsupported);
  add("straight", tally.straight);
  add("points", tally.points);
  add("pinned", tally.pinned);
  add("at inflection", tally.at_inflection);
  add("minima", tally.minima);
  for (const auto& [column, value] : {std::pair{"peaks", tally.peaks},
                                      {"valleys", tally.valleys},
                                      {"neither", tally.neither},
                                      {"pinned peaks", tally.pinned_peaks}})
    cell.measurements.push_back({column, value, "sampled", "1"});
}

}  // namespace

AtPoint curvature_at(const Curve& curve, const Node& node, double sides) {
  const Segment& segment = curve.segment(node.segment);
  const double step = sides * std::min(node.t, 1.0 - node.t);
  return shape(slope_of_magnitude(segment, node.t - step), slope_of_magnitude(segment, node.t + step));
}

CellJob random_sweep_job(RandomKind kind, const SchemePtr& scheme, std::uint64_t seed, const std::vector<int>& sizes) {
  const std::string what = fmt::format("sweep {}, seed {}, sizes {}", sweep_version, seed, fmt::join(sizes, " "));
  return other_job(fmt::format("random {}", name(kind)), scheme, what, [=](store::CellRecord& cell) {
    Tally sum;
    std::uint64_t number = 0;
    for (const int n : sizes)
      for (const bool closed : {false, true})
        sum += count(*scheme, random_input(kind, n, 100003 * seed + number++, closed));
    record(cell, *scheme, sum);
  });
}

CellJob drawings_sweep_job(std::string dataset, const std::vector<Drawing>& drawings, const SchemePtr& scheme) {
  const std::string what = fmt::format("sweep {}, {}", sweep_version, study::contents_of(drawings));
  return other_job(std::move(dataset), scheme, what, [drawings, scheme](store::CellRecord& cell) {
    Tally sum;
    std::vector<Tally> each;
    for (const Drawing& drawing : drawings) {
      Tally& tally = each.emplace_back();
      for (const Input& input : drawing.curves) tally += count(*scheme, input);
      sum += tally;
    }
    record(cell, *scheme, sum);
    for (std::size_t i = 0; i < drawings.size(); ++i)
      for (const auto& [column, value] : {std::pair{"points", each[i].points},
                                          {"pinned", each[i].pinned},
                                          {"at inflection", each[i].at_inflection},
                                          {"minima", each[i].minima}})
        cell.measurements.push_back({fmt::format("{} of {}", column, drawings[i].id), value, "exact", "1"});
  });
}

std::vector<CellJob> sweep_jobs(const Context& context, const std::vector<SchemePtr>& schemes) {
  std::vector<std::pair<std::string, std::vector<Drawing>>> groups;
  if (context.datasets.empty())
    groups.emplace_back("drawings", study::without_long_curves(study::without_options(builtin_drawings()), 100));
  for (const std::string& dataset : context.datasets)
    groups.emplace_back(dataset, study::without_options(open_drawings(dataset)));
  std::vector<CellJob> jobs;
  for (const SchemePtr& scheme : schemes) {
    for (const auto& [dataset, drawings] : groups) jobs.push_back(drawings_sweep_job(dataset, drawings, scheme));
    if (!context.datasets.empty()) continue;
    // The trigonometric basis is slow where a small a leaves it without a solution.
    const std::vector<int> sizes = scheme->info().id == "ekappa-trig"
                                       ? std::vector{3, 3, 5, 5, 7, 7, 10, 10, 15, 15}
                                       : std::vector{3, 3, 5, 5, 7, 7, 10, 10, 15, 15, 22, 22, 33, 50};
    for (const RandomKind kind : random_kinds()) jobs.push_back(random_sweep_job(kind, scheme, context.seed, sizes));
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

}  // namespace kappabench
