#include <fmt/format.h>

#include <algorithm>

#include "datasets/datasets.hpp"
#include "experiments/curve_formats.hpp"
#include "experiments/errors.hpp"
#include "experiments/verbs.hpp"
#include "experiments/write_file.hpp"

namespace kappabench {

namespace {

Drawing one_drawing(const std::string& points) {
  std::vector<Drawing> drawings = open_drawings(points);
  if (drawings.size() != 1)
    throw UsageError(fmt::format("{}: {} drawings; 'fit' takes one, 'compare' takes many", points, drawings.size()));
  if (drawings.front().curves.empty()) throw UsageError(fmt::format("{}: no curves; nothing to fit", points));
  return std::move(drawings.front());
}

/// One line on the worst that happened, and the exit status it means.
int judge(const std::string& points, const std::vector<Fit>& fits) {
  const auto with = [&fits](auto... outcomes) {
    return std::ranges::find_if(fits, [&](const Fit& fit) { return ((fit.report.outcome == outcomes) || ...); });
  };
  const auto complain = [&](const auto& found) {
    const std::string where = fits.size() == 1 ? points : fmt::format("{}: curve {}", points, found - fits.begin());
    const std::string why =
        found->report.message.empty() ? fmt::format("residual {:.2g}", found->report.residual) : found->report.message;
    fmt::print(stderr, "kappabench: {}: {}: {}\n", where, name(found->report.outcome), why);
  };
  if (const auto refused = with(Outcome::unsupported_input); refused != fits.end()) {
    complain(refused);
    return bad_usage;
  }
  if (const auto trouble = with(Outcome::failed, Outcome::not_converged); trouble != fits.end()) {
    complain(trouble);
    return ran_and_failed;
  }
  return success;
}

}  // namespace

int fit(const Registry& registry, const FitArguments& arguments) {
  const SchemePtr scheme = registry.parse(arguments.scheme);
  const Drawing drawing = one_drawing(arguments.points);
  std::vector<Fit> fits;
  for (const Input& input : drawing.curves) fits.push_back(scheme->fit(input));
  // Curves that could be fitted are not withheld because of others; where none could, nothing is overwritten.
  if (std::ranges::any_of(fits, [](const Fit& f) { return f.curve.has_value(); }))
    write_file(arguments.output, format_fits(arguments.format, *scheme, fits));
  return judge(arguments.points, fits);
}

}  // namespace kappabench
