#include "experiments/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>
#include <utility>

#include "datasets/datasets.hpp"
#include "datasets/write_points.hpp"

namespace kappabench::study {

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

CellJob drawn_job(const Drawing& drawing, const SchemePtr& scheme, std::string label) {
  CellJob job = fit_job(drawing, scheme, {});
  job.label = std::move(label);
  return job;
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

double total(const store::ExperimentRecord& record, std::string_view column, std::string_view dataset) {
  double sum = 0.0;
  for (const double value : values(record, column, dataset)) sum += value;
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

std::string contents_of(const std::vector<Drawing>& drawings) {
  std::string text;
  for (const Drawing& drawing : drawings) {
    text += drawing.id;
    for (const Input& input : drawing.curves) {
      text += input.closed ? " closed" : " open";
      for (const Vec2& p : input.points) text += fmt::format(" {:a},{:a}", p.x(), p.y());
    }
  }
  return text;
}

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

}  // namespace kappabench::study
