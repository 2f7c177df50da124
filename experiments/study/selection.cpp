#include "experiments/study/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <ranges>
#include <utility>

#include "datasets/datasets.hpp"

namespace kappabench::study {

namespace {

std::vector<Drawing> open_all(auto&& names) {
  std::vector<Drawing> drawings;
  for (const auto& name : names) std::ranges::move(open_drawings(name), std::back_inserter(drawings));
  return drawings;
}

}  // namespace

std::vector<Drawing> drawings_of(const Context& context) {
  if (context.datasets.empty()) return builtin_drawings();
  std::vector<Drawing> drawings = open_all(context.datasets);
  // Two folders may each hold a bird.
  std::map<std::string, int> seen;
  for (Drawing& drawing : drawings)
    if (const int count = ++seen[drawing.id]; count > 1) drawing.id += fmt::format("-{}", count);
  return drawings;
}

std::vector<Drawing> drawings_or(const Context& context, std::span<const std::string_view> names) {
  return context.datasets.empty() ? open_all(names) : open_all(context.datasets);
}

std::vector<Drawing> drawings_or(const Context& context, std::initializer_list<std::string_view> names) {
  return drawings_or(context, std::span(names.begin(), names.size()));
}

std::vector<SchemePtr> schemes_of(const Context& context) {
  std::vector<SchemePtr> schemes;
  if (context.schemes.empty())
    for (const SchemeInfo& info : context.registry.list()) schemes.push_back(context.registry.create(info.id));
  for (const std::string& text : context.schemes) schemes.push_back(context.registry.parse(text));
  return schemes;
}

std::vector<const Metric*> metrics_of(const Context& context) {
  std::vector<const Metric*> metrics;
  for (const std::string& id : context.metrics) metrics.push_back(&find_metric(id));
  if (metrics.empty())
    for (const Metric& metric : all_metrics())
      if (!metric.refits) metrics.push_back(&metric);
  return metrics;
}

std::vector<Drawing> without_options(std::vector<Drawing> drawings) {
  for (Drawing& drawing : drawings)
    for (Input& input : drawing.curves) input.options.clear();
  return drawings;
}

std::vector<Drawing> without_long_curves(std::vector<Drawing> drawings, int most) {
  for (Drawing& drawing : drawings)
    std::erase_if(drawing.curves, [most](const Input& input) { return input.size() > most; });
  return drawings;
}

}  // namespace kappabench::study
