// Chen 2019, Figs. 1 and 8: typed drawings, and what their joints keep.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/papers/fpc-2019-chen/inputs.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "metrics/continuity.hpp"

namespace kappabench {
namespace {

using namespace chen;
using study::count_of, study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Table;

constexpr std::string_view about =
    "Drawings with typed points in the manner of Figs. 1 and 8, and what their joints keep: every joint is measured on "
    "the curve itself, on these drawings and on random typed inputs. Where the curvature changes sign at a joint the "
    "paper asks for equal magnitudes only.";

// ---- what is measured

constexpr int inputs = 500;
constexpr std::array types{PointType::regular, PointType::cusp, PointType::loop, PointType::inflection};

const Key of_type{"type"}, sign{"sign of the curvature"};
const Quantity points = count_of("points"), solved = count_of("solved"), kept = count_of("kept");
/// Relative, without what rounding of the coordinates can do; of |kappa| where its sign changes.
const Quantity jump{"jump", "1", Method::exact}, angle{"angle", "rad", Method::exact};
const auto changes = sign("changes"), stays = sign("stays");

void measure(const Uses& uses, const Input& input, Notes& notes) {
  for (const PointType type : types) {
    int count = 0;
    for (int i = 0; i < input.size(); ++i)
      count += input.options_of(i).type.value_or(PointType::regular) == type ? 1 : 0;
    notes.row({of_type(name(type))}, {points(count)});
  }
  const Fit fit = uses.schemes.front()->fit(input);
  notes.put(solved(study::solved(fit)));
  if (!study::solved(fit)) return;
  for (const JointJump& at : joint_jumps(*fit.curve, input)) {
    const bool change = at.joint.claimed == Continuity::g1_equal_magnitude;
    const double kappa = change ? at.curvature_magnitude : at.curvature;
    notes.row({change ? changes : stays}, {jump(std::max(0.0, kappa - at.curvature_uncertainty)), angle(at.angle),
                                           kept(at.meets_claim && at.joint.claimed != Continuity::g1)});
  }
}

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr scheme = context.registry.create("fpc");
  const auto joints_of = [&scheme](const Drawing& drawing) {
    return study::curves_job<measure>(
        {.work = "joints", .schemes = {scheme}, .drawings = {drawing}, .metrics = {&find_metric("continuity")}});
  };
  std::vector<CellJob> jobs;
  for (const Drawing& drawing : gallery_or(context)) {
    jobs.push_back(fit_job(drawing, scheme, {}, drawing.id));
    jobs.push_back(joints_of(drawing));
  }
  jobs.push_back(joints_of(typed_random_inputs("joints", context.seed, inputs)));
  return jobs;
}

// ---- what follows

Table table(const Findings& found) {
  Table table("gallery", "Points and joints",
              "Points by type (the rest are regular or ends); joints with and without a change of sign of the "
              "curvature; misses are joints that are not what they should be.");
  table.words("input").counts("points").counts("cusps").counts("loops").counts("inflections");
  table.counts("G2 joints").counts("G1 joints").counts("misses");
  for (const auto& [dataset, rows] : found.rows().by(study::key::dataset)) {
    const auto typed = [&points_of = rows](PointType type) {
      return points_of.where({of_type(name(type))}).total(points);
    };
    table.row({std::get<std::string>(dataset), rows.total(points), typed(PointType::cusp), typed(PointType::loop),
               typed(PointType::inflection), rows.where({stays}).size(), rows.where({changes}).size(),
               study::tally_of(rows.values(kept)).misses()});
  }
  return table;
}

/// The drawings by fours.
void show(Findings& found) {
  const std::vector<std::string> drawings = found.drawn();
  constexpr std::size_t in_a_figure = 4;
  for (std::size_t first = 0; first < drawings.size(); first += in_a_figure) {
    const std::size_t number = first / in_a_figure + 1;
    store::FigureRecord figure{.id = fmt::format("fpc-gallery-{}", number),
                               .title = fmt::format("Typed drawings, {}", number),
                               .caption = "FPC-curves of typed points. Squares are the points, circles the joints.",
                               .columns = in_a_figure};
    for (std::size_t i = first; i < std::min(first + in_a_figure, drawings.size()); ++i)
      if (const auto cell = found.find(drawings[i], drawings[i]))
        figure.panels.push_back(Panel::curves({*cell}, drawings[i]));
    found.add(std::move(figure));
  }
}

void claim_continuity(Findings& found) {
  const study::Rows& rows = found.rows();
  const study::Rows same = rows.where({stays}), change = rows.where({changes});
  const study::Tally fits = study::tally_of(rows.values(solved));
  study::Tally joints = study::tally_of(rows.values(kept));
  joints += {0.0, fits.misses()};
  found.judge(
      "g2-almost-everywhere", joints,
      {joints.words() + " joints",
       fmt::format("{} joints without a change of sign, largest relative jump of curvature {:.2g}; {} with one, |κ| "
                   "agrees to {:.2g}; largest angle {:.2g} rad. What one rounding of the coordinates can do to a "
                   "curvature is taken off. {:.0f} of {:.0f} fits were not solved: one miss each.",
                   same.size(), same.largest(jump), change.size(), change.largest(jump), rows.largest(angle),
                   fits.misses(), fits.cases)});
}

void conclude(Findings& found) {
  found.add(table(found));
  show(found);
  claim_continuity(found);
}

}  // namespace

Experiment fpc_gallery_experiment() {
  return study::experiment({.id = "fpc-gallery",
                            .title = "Typed drawings and their joints (Chen 2019, Figs. 1 and 8)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"g2-almost-everywhere"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
