#include "experiments/ekappa_common.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>
#include <utility>

#include "datasets/datasets.hpp"
#include "datasets/write_points.hpp"
#include "schemes/curve/jet.hpp"

namespace kappabench::ekappa {

namespace {

/// How many spans away from `point` the span number `k` lies: 1 for the two beside it.
int distance_in_spans(std::span<const Span> spans, int k, int point, bool closed) {
  const int n = static_cast<int>(spans.size());
  int best = std::numeric_limits<int>::max();
  for (int j = 0; j < n; ++j) {
    if (spans[static_cast<std::size_t>(j)].to != point) continue;
    // Span j ends at the point, span j + 1 starts there.
    const int before = j - k, after = k - j - 1;
    if (before >= 0) best = std::min(best, before + 1);
    if (after >= 0) best = std::min(best, after + 1);
    if (closed) best = std::min({best, (before + n) % n + 1, (after + n) % n + 1});
  }
  return best;
}

}  // namespace

SchemePtr cubic(const Registry& registry, double a) { return registry.create("ekappa", {{"a", a}}); }
SchemePtr trigonometric(const Registry& registry, double a) { return registry.create("ekappa-trig", {{"a", a}}); }

std::vector<Drawing> drawings_or(const Context& context, std::initializer_list<std::string_view> names) {
  std::vector<Drawing> drawings;
  const auto open = [&drawings](std::string_view name) {
    std::ranges::move(open_drawings(name), std::back_inserter(drawings));
  };
  if (context.datasets.empty()) {
    std::ranges::for_each(names, open);
  } else {
    std::ranges::for_each(context.datasets, open);
  }
  return drawings;
}

Drawing with_shape_at(Drawing drawing, double a, const std::function<bool(int, int)>& chosen) {
  for (int c = 0; Input & input : drawing.curves) {
    input.options.resize(input.points.size());
    for (int i = 0; PointOptions & options : input.options)
      options.a = chosen(c, i++) ? std::optional<double>(a) : std::nullopt;
    ++c;
  }
  return drawing;
}

CellJob drawn_job(const Drawing& drawing, const SchemePtr& scheme, std::string label) {
  CellJob job = fit_job(drawing, scheme, {});
  job.label = std::move(label);
  return job;
}

std::string label_of_shape(const Shape& shape) {
  return shape.a == figure_shapes[0].a ? "κ-curve" : fmt::format("εκ, a = {}", shape.words);
}

void add_shape_jobs(std::vector<CellJob>& jobs, const Context& context, const Drawing& drawing) {
  for (const Shape& shape : figure_shapes) {
    const bool first = shape.a == figure_shapes[0].a;
    const SchemePtr scheme = first ? context.registry.create("kappa") : cubic(context.registry, shape.a);
    jobs.push_back(drawn_job(drawing, scheme, label_of_shape(shape)));
  }
}

CellJob study_job(const Drawing& drawing, const SchemePtr& scheme, std::string_view name, int version,
                  std::function<void(const Drawing&, store::CellRecord&)> measure) {
  std::ostringstream points;
  write_points(points, drawing);
  CellJob job = other_job(drawing.id, scheme, fmt::format("{} {}\n{}", name, version, points.str()),
                          [drawing, measure = std::move(measure)](store::CellRecord& cell) { measure(drawing, cell); });
  job.label = fmt::format("{} (numbers)", name);
  return job;
}

void put(store::CellRecord& cell, std::string column, double value, Method method) {
  cell.measurements.push_back({std::move(column), value, std::string(name(method)), "1"});
}

std::vector<double> values(const store::ExperimentRecord& record, std::string_view column, std::string_view dataset) {
  std::vector<double> all;
  for (const store::CellRecord& cell : record.cells) {
    if (!dataset.empty() && cell.dataset != dataset) continue;
    for (const store::MeasurementRecord& m : cell.measurements)
      if (m.column == column) all.push_back(m.value);
  }
  return all;
}

std::vector<double> values(const store::ExperimentRecord& record, std::string_view column) {
  return values(record, column, {});
}

double total(const store::ExperimentRecord& record, std::string_view column) {
  double sum = 0.0;
  for (const double value : values(record, column)) sum += value;
  return sum;
}

std::optional<int> drawn_cell(const store::ExperimentRecord& record, std::string_view dataset, std::string_view label) {
  for (std::size_t i = 0; i < record.cells.size(); ++i)
    if (record.cells[i].dataset == dataset && record.cells[i].label == label) return static_cast<int>(i);
  return std::nullopt;
}

std::vector<std::string> drawn_datasets(const store::ExperimentRecord& record) {
  std::vector<std::string> names;
  for (const store::CellRecord& cell : record.cells)
    if (!cell.curves.empty() && std::ranges::find(names, cell.dataset) == names.end()) names.push_back(cell.dataset);
  return names;
}

std::vector<double> window_at(const store::CurveRecord& curve, double x, double y, double part) {
  const auto [x0, x1] = std::ranges::minmax(curve.sample_x);
  const auto [y0, y1] = std::ranges::minmax(curve.sample_y);
  const double half = 0.5 * part * std::max(x1 - x0, y1 - y0);
  return {x - half, x + half, y - half, y + half};
}

double curvature_at(const Curve& curve, const Node& node) {
  const double kappa = std::abs(curvature(curve.segment(node.segment).jet(node.t, 2)));
  return std::isfinite(kappa) ? kappa : std::numeric_limits<double>::quiet_NaN();
}

std::vector<int> evenly(int n, int most) {
  std::vector<int> chosen;
  const int count = std::min(n, most);
  for (int k = 0; k < count; ++k) chosen.push_back(k * n / count);
  return chosen;
}

std::vector<Node> inner_nodes(const Fit& fit) {
  std::vector<Node> nodes;
  const int last = fit.input.size() - 1;
  std::ranges::copy_if(fit.curve->nodes(), std::back_inserter(nodes),
                       [&](const Node& node) { return fit.input.closed || (node.point != 0 && node.point != last); });
  return nodes;
}

bool solved(const Fit& fit) { return fit.report.outcome == Outcome::converged && fit.curve.has_value(); }

std::vector<double> largest_by_distance(std::span<const Span> spans, std::span<const double> deviations, int point,
                                        bool closed, int farthest) {
  std::vector<double> found(static_cast<std::size_t>(farthest), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < deviations.size(); ++k) {
    const int distance = distance_in_spans(spans, static_cast<int>(k), point, closed);
    if (distance > farthest) continue;
    double& largest = found[static_cast<std::size_t>(distance) - 1];
    largest = std::isnan(largest) ? deviations[k] : std::max(largest, deviations[k]);
  }
  return found;
}

std::string share(double agree, double cases) {
  return fmt::format("{:.0f} of {:.0f} ({:.4g} %)", agree, cases, cases > 0.0 ? 100.0 * agree / cases : 0.0);
}

std::string verdict_for_all(double counterexamples, double cases) {
  if (!(cases > 0.0)) return "not reproduced";
  return counterexamples > 0.0 ? "contradicted" : "reproduced";
}

std::string verdict_in_general(double agree, double cases) {
  if (!(cases > 0.0)) return "not reproduced";
  return agree >= 0.95 * cases ? "reproduced" : agree < 0.5 * cases ? "contradicted" : "not reproduced";
}

store::ClaimRecord claim(std::string_view id, std::string verdict, std::string ours, std::string evidence) {
  return {.paper = std::string(paper),
          .claim = std::string(id),
          .verdict = std::move(verdict),
          .ours = std::move(ours),
          .evidence = std::move(evidence)};
}

}  // namespace kappabench::ekappa
