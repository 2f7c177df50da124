#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "datasets/datasets.hpp"
#include "experiments/program/draw_report.hpp"
#include "experiments/program/errors.hpp"
#include "experiments/program/format_comparison.hpp"
#include "experiments/program/open_curves.hpp"
#include "experiments/program/verbs.hpp"
#include "experiments/run/experiment.hpp"
#include "experiments/run/house.hpp"
#include "experiments/run/provenance.hpp"
#include "experiments/study/given_job.hpp"
#include "experiments/study/selection.hpp"
#include "reports/store/hdf5_store.hpp"

namespace kappabench {

namespace {

namespace fs = std::filesystem;

using Given = std::shared_ptr<const GivenCurves>;

void refuse_refits(const std::vector<const Metric*>& metrics) {
  const auto refits = std::ranges::find_if(metrics, &Metric::refits);
  if (refits != metrics.end())
    throw UsageError(fmt::format("metric {} fits again, and a curve is measured as it is; name others, or none for all",
                                 (*refits)->id));
}

/// The points of the curves of a file, as a drawing called as the file.
Drawing own_points(const GivenCurves& given) {
  if (given.curves().empty())
    throw UsageError(fmt::format("{}: no curve with segments; nothing to measure", given.info().plugin));
  Drawing drawing{.id = fs::path(given.info().id).stem().string()};
  for (const GivenCurve& curve : given.curves()) drawing.curves.push_back(curve.own);
  return drawing;
}

store::ExperimentRecord measured(const Context& context, const std::vector<Given>& files) {
  const std::vector<const Metric*> metrics = study::metrics_of(context);
  refuse_refits(metrics);
  const std::vector<Drawing> drawings = context.datasets.empty() ? std::vector<Drawing>{} : study::drawings_of(context);
  store::ExperimentRecord record{
      .id = "measure",
      .title = "Curves made elsewhere",
      .about = "Curves of files by every metric that does not fit, judged against the points given or their own.",
  };
  Context shown = context;  // what somebody chose is drawn
  const auto measure = [&](const Drawing& drawing, const Given& given) {
    shown.datasets.push_back(drawing.id);
    const CellJob job = study::measure_job(drawing, given, metrics);
    name_cell(record.cells.emplace_back(compute(job)), job);
  };
  if (context.datasets.empty())
    for (const Given& given : files) measure(own_points(*given), given);
  for (const Drawing& drawing : drawings)
    for (const Given& given : files) measure(drawing, given);
  conclude(find_experiment("compare"), shown, record);
  return record;
}

/// One line for each curve that is not what its file or the points say.
void complain(const store::ExperimentRecord& record) {
  for (const store::CellRecord& cell : record.cells)
    for (std::size_t i = 0; i < cell.curves.size(); ++i)
      if (const store::CurveRecord& curve = cell.curves[i]; curve.outcome != name(Outcome::converged))
        fmt::print(stderr, "kappabench: {}{}: {}: {}\n", cell.label,
                   cell.curves.size() == 1 ? "" : fmt::format(": curve {}", i), curve.outcome, curve.message);
}

}  // namespace

int measure(const Registry& registry, const MeasureArguments& arguments) {
  const std::vector<Given> files = open_curves(arguments.curves, registry);
  const Context context{.registry = registry, .datasets = arguments.points, .metrics = arguments.metrics};
  store::Results results;
  results.experiments.push_back(measured(context, files));
  const store::ExperimentRecord& record = results.experiments.front();
  fmt::print("{}", formatted_comparison(record, arguments.format, !arguments.metrics.empty()));
  complain(record);
  if (!arguments.output.empty()) {
    fs::create_directories(arguments.output);
    results.provenance = provenance(registry);
    store::write_results(arguments.output / "results.h5", results);
    draw_report(results, arguments.output);
  }
  return success;
}

}  // namespace kappabench
