#include <fmt/format.h>

#include "datasets/datasets.hpp"
#include "experiments/program/errors.hpp"
#include "experiments/program/in_child.hpp"
#include "experiments/program/verbs.hpp"
#include "experiments/program/write_fits.hpp"

namespace kappabench {

namespace {

Drawing one_drawing(const std::string& points) {
  std::vector<Drawing> drawings = open_drawings(points);
  if (drawings.size() != 1)
    throw UsageError(fmt::format("{}: {} drawings; 'fit' takes one, 'compare' takes many", points, drawings.size()));
  if (drawings.front().curves.empty()) throw UsageError(fmt::format("{}: no curves; nothing to fit", points));
  return std::move(drawings.front());
}

}  // namespace

int fit(const Registry& registry, const FitArguments& arguments) {
  const SchemePtr scheme = registry.parse(arguments.scheme);
  const Drawing drawing = one_drawing(arguments.points);
  std::vector<Fit> fits;
  const auto fit_all = [&] {
    for (const Input& input : drawing.curves) fits.push_back(scheme->fit(input));
    return static_cast<int>(write_fits(arguments.output, arguments.format, *scheme, fits, arguments.points));
  };
  const std::string what = fmt::format("{}: scheme {}", arguments.points, scheme->info().id);
  return scheme->info().plugin.empty() ? fit_all() : in_child(what, fit_all);
}

}  // namespace kappabench
