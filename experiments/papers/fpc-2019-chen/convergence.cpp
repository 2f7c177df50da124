// Chen 2019, Fig. 4: how fast does the published iteration converge?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/papers/fpc-2019-chen/inputs.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"

namespace kappabench {
namespace {

using namespace chen;
using study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Rows, study::Table, study::Tally;

constexpr std::string_view about =
    "The published iteration alternates between one linear system for the joints and an update of the ratios lambda. "
    "Its error is followed here as the largest relative mismatch of |kappa| at a joint, step by step, on the typed "
    "drawings and on random typed inputs, beside the Newton solver of this program. The paper says that about 1e-6 is "
    "reached by step 15 and machine precision after 50, in the unit of a drawing that it does not name; so what is "
    "compared is by how much the error falls in a step.";

// ---- what is measured

constexpr std::size_t steps = 60;
constexpr int inputs = 300;
constexpr std::array<std::size_t, 2> looked_at{15, 50};
constexpr double converged = 1e-10;  // relative mismatch, for the number of steps
constexpr double stop = 1e-12;       // relative mismatch at which the iteration ends (schemes/fpc/README.md)
constexpr std::string_view shown = "flourish", whole = "published iteration", newton = "Newton";
constexpr std::array<std::pair<std::size_t, std::string_view>, 3> states{
    {{0, "at the start"}, {15, "after 15 steps"}, {30, "after 30 steps"}}};

const Key after{"after step"};
const Quantity mismatch{"relative mismatch", "1", Method::exact}, difference{"difference", "1", Method::exact};
/// NaN where `steps` are not enough.
const Quantity steps_taken{"steps to 1e-10", "1", Method::exact};
const Quantity error_factor{"error factor a step", "1", Method::exact};
const Quantity newton_steps{"Newton steps", "1", Method::exact}, newton_residual{"Newton residual", "1", Method::exact};

SchemePtr published(const Registry& registry, std::size_t most) {
  return registry.parse(fmt::format("fpc:iteration=published,max_iterations={}", most));
}

/// The paper's measure, made scale-free: the largest difference of |kappa| at a joint, times the mean chord.
double difference_of(const Fit& fit) {
  if (!fit.curve) return undefined;
  double largest = 0.0;
  for (const Joint& joint : fit.curve->joints()) {
    const double before = curvature(fit.curve->segment(joint.segment).jet(1.0, 2));
    const double behind = curvature(fit.curve->segment(fit.curve->next(joint.segment)).jet(0.0, 2));
    largest = std::max(largest, std::abs(std::abs(before) - std::abs(behind)));
  }
  return largest * mean_chord(fit.input);
}

/// The residual after `step` steps; an iteration that was done earlier keeps its last.
double residual_at(const std::vector<double>& trace, std::size_t step) {
  return trace.empty() ? undefined : trace[std::min(step, trace.size() - 1)];
}

/// What a step multiplies the error by: the geometric mean from step 15, or from the start where that is not reached.
/// NaN if there is nothing to be done, 1 for an iteration that breaks off.
double factor_of(const std::vector<double>& trace) {
  if (trace.empty()) return 1.0;
  const std::size_t last = trace.size() - 1, from = last > looked_at[0] ? looked_at[0] : 0;
  return last == 0 ? undefined : std::pow(trace[last] / trace[from], 1.0 / static_cast<double>(last - from));
}

/// Uses: Newton's method, all steps, and as many as are looked at.
void measure(const Uses& uses, const Input& input, Notes& notes) {
  if (!input.closed && input.size() < 4) return;  // one segment has no joint
  const Fit exact = uses.schemes[0]->fit(input);
  const std::vector<double> trace = uses.schemes[1]->fit(input).report.trace;
  const auto done = std::ranges::find_if(trace, [](double r) { return r <= converged; });
  notes.row({}, {newton_steps(exact.report.iterations), newton_residual(exact.report.residual),
                 steps_taken(done == trace.end() ? undefined : static_cast<double>(done - trace.begin())),
                 error_factor(factor_of(trace))});
  for (std::size_t k = 0; k < looked_at.size(); ++k)
    notes.row({after(looked_at[k])},
              {mismatch(residual_at(trace, looked_at[k])), difference(difference_of(uses.schemes[2 + k]->fit(input)))});
}

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr solver = context.registry.create("fpc"), iteration = published(context.registry, steps);
  const auto numbers_of = [&](const Drawing& drawing) {
    Uses uses{.work = "convergence", .version = 2, .schemes = {solver, iteration}, .drawings = {drawing}};
    for (const std::size_t step : looked_at) uses.schemes.push_back(published(context.registry, step));
    return study::curves_job<measure>(std::move(uses));
  };
  std::vector<CellJob> jobs;
  for (const Drawing& drawing : gallery_or(context)) {
    for (const auto& [most, words] : states)
      if (drawing.id == shown)
        jobs.push_back(fit_job(drawing, published(context.registry, most), {}, std::string(words)));
    jobs.push_back(fit_job(drawing, iteration, {}, std::string(whole)));
    jobs.push_back(fit_job(drawing, solver, {}, std::string(newton)));
    jobs.push_back(numbers_of(drawing));
  }
  jobs.push_back(numbers_of(typed_random_inputs("convergence", context.seed, inputs)));
  return jobs;
}

// ---- what follows

Table table(const Findings& found) {
  Table table("convergence", "The published iteration, step by step",
              "Largest relative mismatch of |curvature| at a joint after 15 and 50 steps, over the curves of "
              "the drawing; steps of the Newton solver beside it.");
  table.words("drawing").counts("curves").numbers("after 15").numbers("after 50").counts("Newton steps");
  table.numbers("Newton residual");
  for (const auto& [dataset, rows] : found.rows().by(study::key::dataset)) {
    const auto& name = std::get<std::string>(dataset);
    const auto count = rows.values(newton_steps).size();
    const Rows at15 = rows.where({after(15)}), at50 = rows.where({after(50)});
    if (is_random(name))
      table.row({"random typed inputs, median", count, at15.median(mismatch), at50.median(mismatch),
                 rows.median(newton_steps), undefined});
    else
      table.row({name, count, at15.largest(mismatch), at50.largest(mismatch), rows.largest(newton_steps),
                 rows.largest(newton_residual)});
  }
  return table;
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{
      .id = "fpc-convergence",
      .title = "The published iteration on the way",
      .caption =
          "Curvature combs (lengths proportional to curvature, one scale) at the start and after 15 and 30 "
          "steps, and the mismatch of |curvature| at the joints against steps, with the "
          "Newton solver for comparison.",
      .columns = 2};
  for (const auto& [most, words] : states)
    if (const auto cell = found.find(shown, words))
      figure.panels.push_back(Panel::curves({*cell}, std::string(words)).comb(0.15));
  const auto published_cell = found.find(shown, whole), newton_cell = found.find(shown, newton);
  if (published_cell && newton_cell)
    figure.panels.push_back(Panel::convergence({*published_cell, *newton_cell}, std::string(shown)).of_curve(0));
  return figure;
}

Rows of_random_inputs(const Rows& rows, bool random = true) {
  return rows.where_row(
      [random](const study::Row& row) { return is_random(std::get<std::string>(row[study::key::dataset])) == random; });
}

/// "Curves of typed drawings and 300 random typed inputs."
std::string sample_of(const Findings& found) {
  return fmt::format("Curves of typed drawings and {} random typed inputs.",
                     of_random_inputs(found.rows()).values(newton_steps).size());
}

void claim_step_15(Findings& found) {
  const std::vector<double> factors = found.rows().values(error_factor);
  const Rows at15 = found.rows().where({after(15)});
  found.judge(
      "step-15", study::interval_of_median(factors),
      {fmt::format("a step multiplies the error by {:.3g}, median of {} curves", median(factors), factors.size()),
       fmt::format(
           "{} Geometric mean from step 15 to the last, at most {}. After 15 steps the median difference of |κ| "
           "is {:.1g} / mean chord, {:.1g} of |κ| on the drawings and {:.1g} on the random inputs; 1e-6 has the "
           "unit of a drawing that is not printed.",
           sample_of(found), steps, at15.median(difference), of_random_inputs(at15, false).median(mismatch),
           of_random_inputs(at15).median(mismatch))});
}

void claim_step_50(Findings& found) {
  const Rows at50 = found.rows().where({after(50)});
  const Tally stopped = study::tally_of(at50.values(mismatch), [](double v) { return v <= stop; });
  found.judge(
      "step-50", study::interval_of_median(at50.values(mismatch)),
      {fmt::format("median relative mismatch of |κ| {:.1g}; {} had ended", at50.median(mismatch), stopped.words()),
       fmt::format("{} Machine precision is taken as {:.0e} of |κ|, some thousand roundings: there our iteration "
                   "ends itself, so that less cannot be seen. The difference of |κ| is {:.1g} / mean chord.",
                   sample_of(found), stop, at50.median(difference))});
}

void claim_dozens(Findings& found) {
  const Tally done = study::tally_of(found.rows().values(steps_taken), [](double taken) { return !std::isnan(taken); });
  found.judge(
      "dozens-of-iterations", done,
      {fmt::format("{} within {} steps; median {:.0f}", done.words(), steps, found.rows().median(steps_taken)),
       fmt::format("{} Steps until the relative mismatch is at most 1e-10. \"A dozen or dozens\" is taken as at "
                   "most {}.",
                   sample_of(found), steps)});
}

void conclude(Findings& found) {
  found.add(table(found));
  found.add(figure(found));
  claim_step_15(found);
  claim_step_50(found);
  claim_dozens(found);
}

}  // namespace

Experiment fpc_convergence_experiment() {
  return study::experiment({.id = "fpc-convergence",
                            .title = "Convergence of the published iteration (Chen 2019, Fig. 4)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"step-15", "step-50", "dozens-of-iterations"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
