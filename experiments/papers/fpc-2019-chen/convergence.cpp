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
using study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Table, study::Tally;

constexpr std::string_view about =
    "The published iteration alternates between one linear system for the joints and an update of the ratios lambda. "
    "Its error is followed here as the largest relative mismatch of |kappa| at a joint, step by step, on the typed "
    "drawings and on random typed inputs, beside the Newton solver of this program. The paper says that about 1e-6 is "
    "reached by step 15 and machine precision after 50.";

// ---- what is measured

constexpr int steps = 60, inputs = 300;
constexpr std::array looked_at{15, 50};
constexpr double converged = 1e-10;  // relative mismatch, for the number of steps
constexpr std::string_view shown = "flourish", whole = "published iteration", newton = "Newton";
constexpr std::array<std::pair<int, std::string_view>, 3> states{
    {{0, "at the start"}, {15, "after 15 steps"}, {30, "after 30 steps"}}};

const Key after{"after step"};
const Quantity mismatch{"relative mismatch", "1", Method::exact}, difference{"difference", "1", Method::exact};
/// NaN where `steps` are not enough.
const Quantity steps_taken{"steps to 1e-10", "1", Method::exact};
const Quantity newton_steps{"Newton steps", "1", Method::exact}, newton_residual{"Newton residual", "1", Method::exact};

SchemePtr published(const Registry& registry, int most) {
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
double residual_at(const std::vector<double>& trace, int step) {
  return trace.empty() ? undefined : trace[std::min(static_cast<std::size_t>(step), trace.size() - 1)];
}

/// Uses: Newton's method, all steps, and as many as are looked at.
void measure(const Uses& uses, const Input& input, Notes& notes) {
  if (!input.closed && input.size() < 4) return;  // one segment has no joint
  const Fit exact = uses.schemes[0]->fit(input);
  const std::vector<double> trace = uses.schemes[1]->fit(input).report.trace;
  const auto done = std::ranges::find_if(trace, [](double r) { return r <= converged; });
  notes.row({}, {newton_steps(exact.report.iterations), newton_residual(exact.report.residual),
                 steps_taken(done == trace.end() ? undefined : static_cast<double>(done - trace.begin()))});
  for (std::size_t k = 0; k < looked_at.size(); ++k)
    notes.row({after(looked_at[k])},
              {mismatch(residual_at(trace, looked_at[k])), difference(difference_of(uses.schemes[2 + k]->fit(input)))});
}

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr solver = context.registry.create("fpc"), iteration = published(context.registry, steps);
  const auto numbers_of = [&](const Drawing& drawing) {
    Uses uses{.work = "convergence", .schemes = {solver, iteration}, .drawings = {drawing}};
    for (const int step : looked_at) uses.schemes.push_back(published(context.registry, step));
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
    const study::Rows at15 = rows.where({after(15)}), at50 = rows.where({after(50)});
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

study::Rows of_random_inputs(const study::Rows& rows, bool random = true) {
  return rows.where_row(
      [random](const study::Row& row) { return is_random(std::get<std::string>(row[study::key::dataset])) == random; });
}

std::size_t random_inputs(const Findings& found) { return of_random_inputs(found.rows()).values(newton_steps).size(); }

/// "About 1e-6" is taken as within a factor of 10, machine precision as some thousand roundings. The iteration stops
/// at a relative mismatch of 1e-12.
void claim_step(Findings& found, std::string_view id, int step, double bound) {
  const study::Rows rows = found.rows().where({after(step)});
  const Tally small = study::tally_of(rows.values(difference), [bound](double v) { return v <= bound; });
  found.claim(
      id, small.in_general(),
      fmt::format("median {:.1g} / mean chord; at most {:.0e} / mean chord in {}", rows.median(difference), bound,
                  small.words()),
      fmt::format("Largest difference of |κ| at a joint after {} steps, times the mean chord: curves of typed "
                  "drawings and {} random typed inputs. Relative to |κ| the median is {:.1g} on the drawings "
                  "and {:.1g} on the random inputs. The paper's number has the unit of its drawing; in units of "
                  "a twentieth of the mean chord (a drawing some hundred wide) the median is {:.1g}.",
                  step, random_inputs(found), of_random_inputs(rows, false).median(mismatch),
                  of_random_inputs(rows).median(mismatch), rows.median(difference) / 20.0));
}

void claim_dozens(Findings& found) {
  const Tally done = study::tally_of(found.rows().values(steps_taken), [](double taken) { return !std::isnan(taken); });
  found.claim("dozens-of-iterations", done.in_general(),
              fmt::format("{} within {} steps; median {:.0f}", done.words(), steps, found.rows().median(steps_taken)),
              fmt::format("Steps until the relative mismatch is at most 1e-10, curves of typed drawings and {} random "
                          "typed inputs together. \"A dozen or dozens\" is taken as at most {}.",
                          random_inputs(found), steps));
}

void conclude(Findings& found) {
  found.add(table(found));
  found.add(figure(found));
  claim_step(found, "step-15", 15, 1e-5);
  claim_step(found, "step-50", 50, 1e-12);
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
