// Miura 2022, Algorithm 1: how far does the published iteration come, and how far does Newton's method?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/selection.hpp"
#include "metrics/continuity.hpp"

namespace kappabench {
namespace {

using study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Rows, study::Table;

constexpr std::string_view about =
    "Algorithm 1 of the paper alternates between joints, parameters and control points until something is small. The "
    "paper gives no bound; 50 steps are usual practice. Each drawing (without its options for single points) is solved "
    "by 50 and by 2000 of these steps and by the damped Newton cascade of this program. A curve counts as solved when "
    "the residual of all equations is 1e-12 or less. Unless a curve is solved, curvature still jumps at its joints: "
    "the largest relative jump of |curvature| is measured on the curve itself.";

// ---- what is measured

struct Solver {
  std::string_view words, parameters;
};
constexpr std::array<Solver, 3> solvers{{{"published, 50", "iteration=published,max_iterations=50"},
                                         {"published, 2000", "iteration=published,max_iterations=2000"},
                                         {"Newton cascade", "iteration=newton"}}};
constexpr std::array<std::string_view, 4> kinds{"kappa", "ekappa:a=0.8", "ekappa:a=0.95", "ekappa-trig:a=0.75"};
constexpr std::array<std::string_view, 4> shown{"bird", "bear", "five-blob", "very-uneven"};

/// A row a drawing: its supported curves, how many are solved, and the worst of them.
const Key kind{"kind of curve"}, solver_key{"solver"}, drawing_key{"drawing"};
const Quantity curves = study::count_of("curves"), solved = study::count_of("solved"), steps = study::count_of("steps");
const Quantity residual{"residual", "1", Method::sampled}, jump{"jump", "1", Method::sampled};

std::string spelled(std::string_view curve, std::string_view parameters) {
  return fmt::format("{}{}{}", curve, curve.find(':') == std::string_view::npos ? ':' : ',', parameters);
}

void measure_drawing(const Uses& uses, const Drawing& drawing, Notes& notes) {
  double fits = 0.0, converged = 0.0, most_steps = 0.0, largest_residual = 0.0, largest_jump = 0.0;
  for (const Input& input : drawing.curves) {
    const Fit fit = uses.schemes.front()->fit(input);
    if (fit.report.outcome == Outcome::unsupported_input) continue;
    fits += 1.0;
    converged += fit.report.outcome == Outcome::converged ? 1.0 : 0.0;
    most_steps = std::max(most_steps, static_cast<double>(fit.report.iterations));
    largest_residual = std::max(largest_residual, fit.report.residual);
    if (!fit.curve) continue;
    for (const JointJump& joint : joint_jumps(*fit.curve, input))
      largest_jump = std::max(largest_jump, joint.curvature_magnitude - joint.curvature_uncertainty);
  }
  if (fits > 0.0)
    notes.row({kind(uses.words.at("kind")), solver_key(uses.words.at("solver")), drawing_key(drawing.id)},
              {curves(fits), solved(converged), steps(most_steps), residual(largest_residual), jump(largest_jump)});
}

void measure(const Uses& uses, Notes& notes) {
  for (const Drawing& drawing : uses.drawings) measure_drawing(uses, drawing, notes);
}

std::vector<CellJob> jobs(const Context& context) {
  const std::vector<Drawing> drawings = study::without_options(study::drawings_of(context));
  std::vector<CellJob> jobs;
  for (const std::string_view curve : kinds)
    for (const Solver& solver : solvers)
      jobs.push_back(
          study::numbers_job<measure>({.work = "iterations",
                                       .schemes = {context.registry.parse(spelled(curve, solver.parameters))},
                                       .drawings = drawings,
                                       .metrics = {&find_metric("continuity")},
                                       .words = {{"kind", std::string(curve)}, {"solver", std::string(solver.words)}}},
                                      "drawings", fmt::format("{}, {}", curve, solver.words)));
  for (const std::string_view id : shown) {
    const auto drawing = std::ranges::find(drawings, id, &Drawing::id);
    if (drawing == drawings.end()) continue;
    const auto add = [&](std::string_view parameters, std::string label) {
      jobs.push_back(fit_job(*drawing, context.registry.parse(spelled("kappa", parameters)), {}, std::move(label)));
    };
    add("iteration=published,max_iterations=100", "published iteration");
    add("iteration=newton", "Newton cascade");
  }
  return jobs;
}

// ---- what follows

Table summary_table(const Rows& all) {
  Table table(
      "iterations", "The published iteration against the Newton cascade, all drawings",
      "Curves solved (residual at most 1e-12); steps and jumps are the largest of each drawing's curves, then "
      "the median and the largest over drawings. Steps of the cascade are the sweeps of the published iteration "
      "and Newton steps together.");
  table.words("curve").words("solver").counts("curves").counts("solved").numbers("share solved");
  table.numbers("median steps").counts("most steps").numbers("median residual").numbers("largest residual");
  table.numbers("median jump of |curvature|").numbers("largest jump of |curvature|");
  for (const std::string_view curve : kinds)
    for (const Solver& solver : solvers) {
      const Rows rows = all.where({kind(curve), solver_key(solver.words)});
      const double count = rows.total(curves);
      table.row({curve, solver.words, count, rows.total(solved), rows.total(solved) / count, rows.median(steps),
                 rows.largest(steps), rows.median(residual), rows.largest(residual), rows.median(jump),
                 rows.largest(jump)});
    }
  return table;
}

Table drawing_table(const Rows& all) {
  const std::string_view curve = kinds.front();
  Table table(fmt::format("iterations-{}", curve), fmt::format("Every drawing, {}", curve),
              "Steps, residual and the largest relative jump of |curvature| at a joint, the worst over the drawing's "
              "curves.");
  table.words("drawing").counts("curves").counts("solved by 50").counts("solved by 2000").counts("solved by Newton");
  table.counts("published steps").counts("Newton steps").numbers("residual after 50").numbers("residual after 2000");
  table.numbers("residual of Newton").numbers("jump after 50").numbers("jump after 2000").numbers("jump of Newton");
  for (const auto& [drawing, rows] : all.where({kind(curve)}).by(drawing_key)) {
    const auto by = [&rows = rows](std::size_t k, const Quantity& what) {
      return rows.where({solver_key(solvers[k].words)}).total(what);
    };
    table.row({std::get<std::string>(drawing), by(2, curves), by(0, solved), by(1, solved), by(2, solved), by(1, steps),
               by(2, steps), by(0, residual), by(1, residual), by(2, residual), by(0, jump), by(1, jump), by(2, jump)});
  }
  return table;
}

store::FigureRecord trace_figure(const Findings& found) {
  store::FigureRecord figure{
      .id = "ekappa-iterations",
      .title = "Residual against steps: published iteration and Newton cascade",
      .caption =
          "kappa-curves (a = 2/3). The published iteration is cut off after 100 steps. The cascade comes through "
          "softened problems, so its residual need not fall from the start.",
      .columns = 2};
  for (const std::string_view id : shown) {
    std::vector<int> cells;
    for (const std::string_view label : {"published iteration", "Newton cascade"})
      if (const auto cell = found.find(id, label); cell && !found.cell(*cell).curves.empty()) cells.push_back(*cell);
    if (!cells.empty()) figure.panels.push_back(Panel::convergence(cells, std::string(id)).of_curve(0));
  }
  return figure;
}

void conclude(Findings& found) {
  if (found.rows().empty()) return;
  found.add(summary_table(found.rows()));
  found.add(drawing_table(found.rows()));
  found.add(trace_figure(found));
}

}  // namespace

Experiment ekappa_iterations_experiment() {
  return study::experiment({.id = "ekappa-iterations",
                            .title = "The published iteration and the Newton cascade",
                            .about = std::string(about),
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
