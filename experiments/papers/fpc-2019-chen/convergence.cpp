#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/papers/fpc-2019-chen/inputs.hpp"
#include "experiments/study/summaries.hpp"

namespace kappabench {

using namespace fpc;

namespace {

constexpr std::string_view about =
    "The published iteration alternates between one linear system for the joints and an update of the ratios lambda. "
    "Its error is followed here as the largest relative mismatch of |kappa| at a joint, step by step, on the typed "
    "drawings and on random typed inputs, beside the Newton solver of this program. The paper says that about 1e-6 is "
    "reached by step 15 and machine precision after 50.";

constexpr int version = 1;
constexpr int steps = 60;
constexpr std::array looked_at{15, 50};
constexpr int inputs = 300;
constexpr std::string_view shown = "flourish";
constexpr std::array<std::pair<int, std::string_view>, 3> states{
    {{0, "at the start"}, {15, "after 15 steps"}, {30, "after 30 steps"}}};
/// "About 1e-6" is taken as within a factor of 10, machine precision as some thousand roundings. The iteration stops
/// at a relative mismatch of 1e-12.
constexpr double about_a_millionth = 1e-5, machine_precision = 1e-12;

SchemePtr published(const Registry& registry, int most) {
  return registry.parse(fmt::format("fpc:iteration=published,max_iterations={}", most));
}

/// The residual after `step` steps; an iteration that was done earlier keeps its last.
double residual_at(const std::vector<double>& trace, int step) {
  return trace[std::min(static_cast<std::size_t>(step), trace.size() - 1)];
}

/// The paper's measure, made scale-free: the largest difference of |kappa| at a joint, times the mean chord; the
/// largest |kappa| there beside it.
double difference_of(const Fit& fit) {
  double largest = 0.0;
  for (const Joint& joint : fit.curve->joints()) {
    const double before = curvature(fit.curve->segment(joint.segment).jet(1.0, 2));
    const double behind = curvature(fit.curve->segment(fit.curve->next(joint.segment)).jet(0.0, 2));
    largest = std::max(largest, std::abs(std::abs(before) - std::abs(behind)));
  }
  return largest * mean_chord(fit.input);
}

void put_differences(const Registry& registry, const Input& input, store::CellRecord& cell) {
  for (const int step : looked_at) {
    const Fit fit = published(registry, step)->fit(input);
    if (fit.curve && !fit.curve->joints().empty())
      study::put(cell, fmt::format("difference at {}", step), difference_of(fit));
  }
}

void put_trace(const std::vector<double>& trace, store::CellRecord& cell) {
  study::put(cell, "inputs", 1.0);
  if (trace.empty()) return;
  study::put(cell, "residual at 15", residual_at(trace, 15));
  study::put(cell, "residual at 50", residual_at(trace, 50));
  const auto done = std::ranges::find_if(trace, [](double r) { return r <= 1e-10; });
  if (done != trace.end()) study::put(cell, "steps to 1e-10", static_cast<double>(done - trace.begin()));
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const Registry& registry = context.registry;
  const SchemePtr scheme = published(registry, steps), newton = registry.create("fpc");
  for (const Drawing& drawing : gallery_or(context)) {
    for (const auto& [most, words] : states)
      if (drawing.id == shown) jobs.push_back(study::drawn_job(drawing, published(registry, most), std::string(words)));
    jobs.push_back(study::drawn_job(drawing, scheme, "published iteration"));
    jobs.push_back(study::drawn_job(drawing, newton, "Newton"));
    jobs.push_back(study::study_job(drawing, scheme, "differences", version,
                                    [&registry](const Drawing& points, store::CellRecord& cell) {
                                      for (const Input& input : points.curves) put_differences(registry, input, cell);
                                    }));
  }
  const std::uint64_t seed = context.seed;
  jobs.push_back(random_job(scheme, fmt::format("convergence, seed {}", seed), version, inputs,
                            [&registry, scheme, newton, seed](std::uint64_t index, store::CellRecord& cell) {
                              const Input input = typed_random_input(seed, index);
                              put_trace(scheme->fit(input).report.trace, cell);
                              put_differences(registry, input, cell);
                              const Fit fit = newton->fit(input);
                              study::put(cell, "Newton solved", study::solved(fit) ? 1.0 : 0.0);
                              study::put(cell, "Newton steps", fit.report.iterations);
                            }));
  return jobs;
}

/// Traces of the published iteration on the drawings, one for each curve.
std::vector<std::vector<double>> traces_of(const store::ExperimentRecord& record) {
  std::vector<std::vector<double>> traces;
  for (const store::CellRecord& cell : record.cells)
    if (cell.label == "published iteration")
      for (const store::CurveRecord& curve : cell.curves)
        if (!curve.trace.empty() && !curve.joint_segment.empty()) traces.push_back(curve.trace);
  return traces;
}

double count_below(const std::vector<double>& values, double bound) {
  return static_cast<double>(std::ranges::count_if(values, [bound](double v) { return v <= bound; }));
}

/// Relative mismatches.
struct Residuals {
  std::vector<double> of_drawings, of_random;
};

Residuals residuals_at(const store::ExperimentRecord& record, int step) {
  Residuals residuals;
  for (const auto& trace : traces_of(record)) residuals.of_drawings.push_back(residual_at(trace, step));
  residuals.of_random = study::values(record, fmt::format("residual at {}", step));
  return residuals;
}

store::ClaimRecord step_claim(const store::ExperimentRecord& record, std::string_view id, int step, double bound) {
  const std::vector<double> all = study::values(record, fmt::format("difference at {}", step));
  const Residuals relative = residuals_at(record, step);
  const auto cases = static_cast<double>(all.size());
  return claim(
      id, study::verdict_in_general(count_below(all, bound), cases),
      fmt::format("median {:.1g} / mean chord; at most {:.0e} / mean chord in {}", median(all), bound,
                  study::share(count_below(all, bound), cases)),
      fmt::format("Largest difference of |κ| at a joint after {} steps, times the mean chord: curves of typed "
                  "drawings and {:.0f} random typed inputs. Relative to |κ| the median is {:.1g} on the drawings "
                  "and {:.1g} on the random inputs. The paper's number has the unit of its drawing; in units of "
                  "a twentieth of the mean chord (a drawing some hundred wide) the median is {:.1g}.",
                  step, study::total(record, "inputs"), median(relative.of_drawings), median(relative.of_random),
                  median(all) / 20.0));
}

store::ClaimRecord dozens_claim(const store::ExperimentRecord& record) {
  std::vector<double> taken = study::values(record, "steps to 1e-10");
  double all = study::total(record, "inputs");
  for (const auto& trace : traces_of(record)) {
    const auto done = std::ranges::find_if(trace, [](double r) { return r <= 1e-10; });
    all += 1.0;
    if (done != trace.end()) taken.push_back(static_cast<double>(done - trace.begin()));
  }
  return claim(
      "dozens-of-iterations", study::verdict_in_general(static_cast<double>(taken.size()), all),
      fmt::format("{} within {} steps; median {:.0f}", study::share(static_cast<double>(taken.size()), all), steps,
                  median(taken)),
      fmt::format("Steps until the relative mismatch is at most 1e-10, curves of typed drawings and {:.0f} random "
                  "typed inputs together. \"A dozen or dozens\" is taken as at most {}.",
                  study::total(record, "inputs"), steps));
}

store::TableRecord table(const store::ExperimentRecord& record) {
  TableBuilder builder("convergence", "The published iteration, step by step",
                       "Largest relative mismatch of |curvature| at a joint after 15 and 50 steps, over the curves of "
                       "the drawing; steps of the Newton solver beside it.");
  builder.words("drawing").counts("curves").numbers("after 15").numbers("after 50").counts("Newton steps");
  builder.numbers("Newton residual");
  for (const store::CellRecord& cell : record.cells) {
    if (cell.label != "published iteration") continue;
    double after15 = 0.0, after50 = 0.0, newton_steps = 0.0, newton_residual = 0.0;
    for (const store::CurveRecord& curve : cell.curves) {
      if (curve.trace.empty()) continue;
      after15 = std::max(after15, residual_at(curve.trace, 15));
      after50 = std::max(after50, residual_at(curve.trace, 50));
    }
    if (const auto newton = study::drawn_cell(record, cell.dataset, "Newton"))
      for (const store::CurveRecord& curve : record.cells[static_cast<std::size_t>(*newton)].curves) {
        newton_steps = std::max(newton_steps, static_cast<double>(curve.iterations));
        newton_residual = std::max(newton_residual, curve.residual);
      }
    builder.row(
        {cell.dataset, static_cast<double>(cell.curves.size()), after15, after50, newton_steps, newton_residual});
  }
  const Residuals r15 = residuals_at(record, 15), r50 = residuals_at(record, 50);
  builder.row({std::string("random typed inputs, median"), static_cast<double>(r15.of_random.size()),
               median(r15.of_random), median(r50.of_random), median(study::values(record, "Newton steps")),
               std::numeric_limits<double>::quiet_NaN()});
  return builder.table();
}

store::FigureRecord figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{
      .id = "fpc-convergence",
      .title = "The published iteration on the way",
      .caption =
          "Curvature combs (lengths proportional to curvature, one scale) at the start and after 15 and 30 "
          "steps, and the mismatch of |curvature| at the joints against steps, with the "
          "Newton solver for comparison.",
      .columns = 2,
      .panels = {}};
  for (const auto& [most, words] : states)
    if (const auto cell = study::drawn_cell(record, shown, words)) {
      figure.panels.push_back(curve_panel(*cell, std::string(words), true));
      figure.panels.back().comb_scale = 0.15;
    }
  store::PanelRecord panel{.kind = "convergence", .title = std::string(shown), .cells = {}, .curve = 0};
  for (const std::string_view label : {"published iteration", "Newton"})
    if (const auto cell = study::drawn_cell(record, shown, label)) panel.cells.push_back(*cell);
  if (!panel.cells.empty()) figure.panels.push_back(std::move(panel));
  return figure;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {table(record)};
  if (auto drawn = figure(record); !drawn.panels.empty()) record.figures = {std::move(drawn)};
  record.claims = {step_claim(record, "step-15", looked_at[0], about_a_millionth),
                   step_claim(record, "step-50", looked_at[1], machine_precision), dozens_claim(record)};
}

}  // namespace

Experiment fpc_convergence_experiment() {
  return {.id = "fpc-convergence",
          .title = "Convergence of the published iteration (Chen 2019, Fig. 4)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
