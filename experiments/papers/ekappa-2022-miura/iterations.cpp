#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "experiments/papers/ekappa-2022-miura/family_sweep.hpp"
#include "experiments/study/selection.hpp"
#include "experiments/study/study.hpp"
#include "experiments/study/summaries.hpp"
#include "metrics/continuity.hpp"

namespace kappabench {

namespace {

constexpr std::string_view about =
    "Algorithm 1 of the paper alternates between joints, parameters and control points until something is small. The "
    "paper gives no bound; 50 steps are usual practice. Each drawing (without its options for single points) is solved "
    "by 50 and by 2000 of these steps and by the damped Newton cascade of this program. A curve counts as solved when "
    "the residual of all equations is 1e-12 or less. Unless a curve is solved, curvature still jumps at its joints: "
    "the largest relative jump of |curvature| is measured on the curve itself.";

/// Raise when the cells count differently.
constexpr int version = 1;

constexpr std::array<std::string_view, 3> solvers{"iteration=published,max_iterations=50",
                                                  "iteration=published,max_iterations=2000", "iteration=newton"};
constexpr std::array<std::string_view, 4> curves{"kappa", "ekappa:a=0.8", "ekappa:a=0.95", "ekappa-trig:a=0.75"};
constexpr std::array<std::string_view, 4> shown{"bird", "bear", "five-blob", "very-uneven"};

std::string spelled(std::string_view curve, std::string_view solver) {
  return fmt::format("{}{}{}", curve, curve.find(':') == std::string_view::npos ? ':' : ',', solver);
}

/// All fits of one drawing.
struct Effort {
  double curves = 0, solved = 0, steps = 0, residual = 0, jump = 0;
};

Effort effort_on(const Scheme& scheme, const Drawing& drawing) {
  Effort effort;
  for (const Input& input : drawing.curves) {
    const Fit fit = scheme.fit(input);
    if (fit.report.outcome == Outcome::unsupported_input) continue;
    ++effort.curves;
    effort.solved += fit.report.outcome == Outcome::converged;
    effort.steps = std::max(effort.steps, static_cast<double>(fit.report.iterations));
    effort.residual = std::max(effort.residual, fit.report.residual);
    if (!fit.curve) continue;
    for (const JointJump& joint : joint_jumps(*fit.curve, mean_chord(input)))
      effort.jump = std::max(effort.jump, std::max(0.0, joint.curvature_magnitude - joint.curvature_uncertainty));
  }
  return effort;
}

constexpr std::array<std::pair<std::string_view, double Effort::*>, 5> columns{{{"curves", &Effort::curves},
                                                                                {"solved", &Effort::solved},
                                                                                {"steps", &Effort::steps},
                                                                                {"residual", &Effort::residual},
                                                                                {"jump", &Effort::jump}}};

std::string column_name(std::string_view column, std::string_view drawing) {
  return fmt::format("{} of {}", column, drawing);
}

Effort stored_effort(const store::CellRecord& cell, std::string_view drawing) {
  Effort effort;
  for (const auto& [column, member] : columns)
    effort.*member = measured(cell, column_name(column, drawing)).value_or(0.0);
  return effort;
}

CellJob drawings_job(const std::vector<Drawing>& drawings, const SchemePtr& scheme) {
  return other_job("drawings", scheme, fmt::format("iterations {}, {}", version, study::contents_of(drawings)),
                   [drawings, scheme](store::CellRecord& cell) {
                     for (const Drawing& drawing : drawings) {
                       const Effort effort = effort_on(*scheme, drawing);
                       for (const auto& [column, member] : columns)
                         cell.measurements.push_back({column_name(column, drawing.id), effort.*member, "sampled", "1"});
                     }
                   });
}

std::vector<CellJob> jobs(const Context& context) {
  const std::vector<Drawing> drawings = study::without_options(study::drawings_of(context));
  std::vector<CellJob> jobs;
  for (const std::string_view curve : curves)
    for (const std::string_view solver : solvers)
      jobs.push_back(drawings_job(drawings, context.registry.parse(spelled(curve, solver))));
  for (const std::string_view id : shown) {
    const auto drawing = std::ranges::find(drawings, id, &Drawing::id);
    if (drawing == drawings.end()) continue;
    const auto add = [&](std::string_view solver, std::string_view label) {
      jobs.push_back(fit_job(*drawing, context.registry.parse(spelled("kappa", solver)), {}));
      jobs.back().label = label;
    };
    add("iteration=published,max_iterations=100", "published iteration");
    add("iteration=newton", "Newton cascade");
  }
  return jobs;
}

/// The three cells over all drawings of one kind of curve, in the order of `solvers`.
struct Row {
  std::string_view curve;
  std::array<const store::CellRecord*, 3> cells;
};

std::vector<Row> rows_of(const Context& context, const store::ExperimentRecord& record) {
  std::vector<Row> rows;
  for (const std::string_view curve : curves) {
    Row row{curve, {}};
    for (std::size_t k = 0; k < solvers.size(); ++k) {
      const SchemePtr scheme = context.registry.parse(spelled(curve, solvers[k]));
      for (const store::CellRecord& cell : record.cells)
        if (cell.dataset == "drawings" && cell.scheme == scheme->info().id &&
            cell.parameters == scheme->parameters().canonical())
          row.cells[k] = &cell;
    }
    if (std::ranges::all_of(row.cells, [](const auto* cell) { return cell != nullptr && !cell->measurements.empty(); }))
      rows.push_back(row);
  }
  return rows;
}

std::vector<std::string> drawings_in(const store::CellRecord& cell) {
  constexpr std::string_view prefix = "curves of ";
  std::vector<std::string> ids;
  for (const store::MeasurementRecord& m : cell.measurements)
    if (m.column.starts_with(prefix)) ids.push_back(m.column.substr(prefix.size()));
  return ids;
}

/// A sum over all drawings of a cell, and all values, drawings without a supported curve left out.
double total(const store::CellRecord& cell, double Effort::*member) {
  double sum = 0.0;
  for (const std::string& id : drawings_in(cell)) sum += stored_effort(cell, id).*member;
  return sum;
}
std::vector<double> values(const store::CellRecord& cell, double Effort::*member) {
  std::vector<double> all;
  for (const std::string& id : drawings_in(cell))
    if (const Effort effort = stored_effort(cell, id); effort.curves > 0) all.push_back(effort.*member);
  return all;
}

store::TableRecord summary_table(const std::vector<Row>& rows) {
  TableBuilder builder("iterations", "The published iteration against the Newton cascade, all drawings",
                       "Curves solved (residual at most 1e-12); steps and jumps are the largest of each drawing's "
                       "curves, then the median and the largest over drawings. Steps of the cascade are the sweeps of "
                       "the published iteration and Newton steps together.");
  builder.words("curve").words("solver").counts("curves").counts("solved").numbers("share solved");
  builder.numbers("median steps").counts("most steps").numbers("median residual").numbers("largest residual");
  builder.numbers("median jump of |curvature|").numbers("largest jump of |curvature|");
  for (const Row& row : rows)
    for (std::size_t k = 0; k < solvers.size(); ++k) {
      const store::CellRecord& cell = *row.cells[k];
      constexpr std::array<std::string_view, 3> words{"published, 50", "published, 2000", "Newton cascade"};
      const double count = total(cell, &Effort::curves), solved = total(cell, &Effort::solved);
      builder.row({std::string(row.curve), std::string(words[k]), count, solved, solved / count,
                   median(values(cell, &Effort::steps)), largest(values(cell, &Effort::steps)),
                   median(values(cell, &Effort::residual)), largest(values(cell, &Effort::residual)),
                   median(values(cell, &Effort::jump)), largest(values(cell, &Effort::jump))});
    }
  return builder.table();
}

store::TableRecord drawing_table(const Row& row) {
  TableBuilder builder(fmt::format("iterations-{}", row.curve.substr(0, row.curve.find(':'))),
                       fmt::format("Every drawing, {}", row.curve),
                       "Steps, residual and the largest relative jump of |curvature| at a joint, the worst over the "
                       "drawing's curves.");
  builder.words("drawing").counts("curves").counts("solved by 50").counts("solved by 2000").counts("solved by Newton");
  builder.counts("published steps").counts("Newton steps").numbers("residual after 50").numbers("residual after 2000");
  builder.numbers("residual of Newton").numbers("jump after 50").numbers("jump after 2000").numbers("jump of Newton");
  for (const std::string& id : drawings_in(*row.cells[0])) {
    const Effort early = stored_effort(*row.cells[0], id), late = stored_effort(*row.cells[1], id),
                 newton = stored_effort(*row.cells[2], id);
    if (newton.curves == 0) continue;
    builder.row({id, newton.curves, early.solved, late.solved, newton.solved, late.steps, newton.steps, early.residual,
                 late.residual, newton.residual, early.jump, late.jump, newton.jump});
  }
  return builder.table();
}

store::FigureRecord trace_figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{
      .id = "ekappa-iterations",
      .title = "Residual against steps: published iteration and Newton cascade",
      .caption =
          "kappa-curves (a = 2/3). The published iteration is cut off after 100 steps. The cascade comes "
          "through softened problems, so its residual need not fall from the start.",
      .columns = 2,
      .panels = {}};
  for (const std::string_view id : shown) {
    store::PanelRecord panel{.kind = "convergence", .title = std::string(id), .cells = {}, .curve = 0};
    for (std::size_t i = 0; i < record.cells.size(); ++i)
      if (record.cells[i].dataset == id && !record.cells[i].curves.empty()) panel.cells.push_back(static_cast<int>(i));
    if (!panel.cells.empty()) figure.panels.push_back(std::move(panel));
  }
  return figure;
}

void conclude(const Context& context, store::ExperimentRecord& record) {
  const std::vector<Row> rows = rows_of(context, record);
  if (rows.empty()) return;
  record.tables = {summary_table(rows), drawing_table(rows.front())};
  if (store::FigureRecord figure = trace_figure(record); !figure.panels.empty()) record.figures = {std::move(figure)};
}

}  // namespace

Experiment ekappa_iterations_experiment() {
  return {.id = "ekappa-iterations",
          .title = "The published iteration and the Newton cascade",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
