#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/papers/fpc-2019-chen/inputs.hpp"
#include "experiments/study/summaries.hpp"
#include "metrics/continuity.hpp"

namespace kappabench {

using namespace fpc;

namespace {

constexpr std::string_view about =
    "Drawings with typed points in the manner of Figs. 1 and 8, and what their joints keep: every joint is measured on "
    "the curve itself, on these drawings and on random typed inputs. Where the curvature changes sign at a joint the "
    "paper asks for equal magnitudes only.";

constexpr int version = 1;
constexpr int inputs = 500;

void measure_joints(const Fit& fit, store::CellRecord& cell) {
  study::put(cell, "fits", 1.0);
  if (!study::solved(fit)) {
    study::put(cell, "fits without a solution", 1.0);
    return;
  }
  for (const JointJump& jump : joint_jumps(*fit.curve, mean_chord(fit.input))) {
    const bool signs_differ = jump.joint.claimed == Continuity::g1_equal_magnitude;
    study::put(cell, signs_differ ? "joints with a change of sign" : "joints elsewhere", 1.0);
    const double kappa = signs_differ ? jump.curvature_magnitude : jump.curvature;
    study::put(cell, signs_differ ? "magnitude jump" : "curvature jump",
               std::max(0.0, kappa - jump.curvature_uncertainty));
    study::put(cell, "angle", jump.angle);
    study::put(cell, "misses", jump.meets_claim() && jump.joint.claimed != Continuity::g1 ? 0.0 : 1.0);
  }
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const SchemePtr scheme = context.registry.create("fpc");
  for (const Drawing& drawing : gallery_or(context)) {
    jobs.push_back(study::drawn_job(drawing, scheme, drawing.id));
    jobs.push_back(
        study::study_job(drawing, scheme, "joints", version, [scheme](const Drawing& points, store::CellRecord& cell) {
          for (const Input& input : points.curves) {
            for (const PointType type : {PointType::regular, PointType::cusp, PointType::loop, PointType::inflection})
              study::put(cell, std::string(name(type)), count_of(input, type));
            study::put(cell, "points", input.size());
            measure_joints(scheme->fit(input), cell);
          }
        }));
  }
  const std::uint64_t seed = context.seed;
  jobs.push_back(random_job(scheme, fmt::format("joints, seed {}", seed), version, inputs,
                            [scheme, seed](std::uint64_t index, store::CellRecord& cell) {
                              measure_joints(scheme->fit(typed_random_input(seed, index)), cell);
                            }));
  return jobs;
}

double sum_in(const store::CellRecord& cell, std::string_view column) {
  double sum = 0.0;
  for (const store::MeasurementRecord& m : cell.measurements)
    if (m.column == column) sum += m.value;
  return sum;
}

store::TableRecord table(const store::ExperimentRecord& record) {
  TableBuilder builder("gallery", "Points and joints",
                       "Points by type (the rest are regular or ends); joints with and without a change of sign of the "
                       "curvature; misses are joints that are not what they should be.");
  builder.words("input").counts("points").counts("cusps").counts("loops").counts("inflections");
  builder.counts("G2 joints").counts("G1 joints").counts("misses");
  for (const store::CellRecord& cell : record.cells)
    if (!cell.measurements.empty())
      builder.row({cell.dataset, sum_in(cell, "points"), sum_in(cell, "cusp"), sum_in(cell, "loop"),
                   sum_in(cell, "inflection"), sum_in(cell, "joints elsewhere"),
                   sum_in(cell, "joints with a change of sign"), sum_in(cell, "misses")});
  return builder.table();
}

store::ClaimRecord continuity_claim(const store::ExperimentRecord& record) {
  const double same = study::total(record, "joints elsewhere");
  const double change = study::total(record, "joints with a change of sign");
  const double misses = study::total(record, "misses"), joints = same + change;
  return claim(
      "g2-almost-everywhere", study::verdict_for_all(misses, joints),
      fmt::format("{} joints", study::share(joints - misses, joints)),
      fmt::format("{:.0f} joints without a change of sign, largest relative jump of curvature {:.2g}; {:.0f} with "
                  "one, |κ| agrees to {:.2g}; largest angle {:.2g} rad. What one rounding of the coordinates can "
                  "do to a curvature is taken off. {:.0f} of {:.0f} fits were not solved and are left out.",
                  same, largest(study::values(record, "curvature jump")), change,
                  largest(study::values(record, "magnitude jump")), largest(study::values(record, "angle")),
                  study::total(record, "fits without a solution"), study::total(record, "fits")));
}

/// Up to four drawings, once with their combs.
store::FigureRecord figure(const store::ExperimentRecord& record, const std::vector<std::string>& drawings,
                           int number) {
  store::FigureRecord figure{.id = fmt::format("fpc-gallery-{}", number),
                             .title = fmt::format("Typed drawings, {}", number),
                             .caption = "FPC-curves of typed points. Squares are the points, circles the joints.",
                             .columns = 4,
                             .panels = {}};
  for (const std::string& id : drawings)
    for (std::size_t i = 0; i < record.cells.size(); ++i)
      if (record.cells[i].dataset == id && !record.cells[i].curves.empty())
        figure.panels.push_back(curve_panel(static_cast<int>(i), record.cells[i].label));
  return figure;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {table(record)};
  const std::vector<std::string> drawings = study::drawn_datasets(record);
  constexpr std::size_t in_a_figure = 4;
  for (std::size_t i = 0; i < drawings.size(); i += in_a_figure) {
    const auto first = drawings.begin() + static_cast<std::ptrdiff_t>(i);
    const auto last = drawings.begin() + static_cast<std::ptrdiff_t>(std::min(i + in_a_figure, drawings.size()));
    record.figures.push_back(figure(record, {first, last}, static_cast<int>(i / in_a_figure) + 1));
  }
  record.claims = {continuity_claim(record)};
}

}  // namespace

Experiment fpc_gallery_experiment() {
  return {.id = "fpc-gallery",
          .title = "Typed drawings and their joints (Chen 2019, Figs. 1 and 8)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
