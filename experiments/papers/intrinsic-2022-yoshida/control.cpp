// Yoshida 2022, Fig. 9: what happens to a curve whose control curvatures are moved by hand.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/inputs.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/measured.hpp"
#include "schemes/curve/exact_curvature.hpp"
#include "schemes/intrinsic/edit.hpp"
#include "schemes/segments/intrinsic.hpp"

namespace kappabench {
namespace {

using namespace yoshida;
using namespace intrinsic;
using study::count_of, study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Rows,
    study::Table, study::Tally;

constexpr std::string_view about =
    "A G1 curve with six control curvatures. The fourth is moved, then the fifth; the first and the last are solved "
    "for again, so that the curve still meets both points and tangents. The paper does not say whether the other inner "
    "controls stay or follow the ends again (Eqs. (10) and (11)): both are drawn. Then every inner control of random "
    "curves (the paper's angles) is moved by more and more, up and down, until curvature has an extremum, another "
    "inflection, or there is no solution. Moves are given over the largest control curvature before.";

// ---- what is measured

constexpr long random_curves = 12;  ///< unless the plan says otherwise
/// A factor of 1.6 between sizes of moves: 0.001 to about 300.
constexpr int sizes = 28;
constexpr double smallest = 0.001, growth = 1.6;
constexpr std::array both{std::pair{Others::kept, std::string_view("others kept")},
                          std::pair{Others::interpolated, std::string_view("others interpolated")}};

const Key other_controls{"other inner controls"};
const Quantity moderate_moves = count_of("moderate moves"), moderate_solved = count_of("moderate moves solved");
const Quantity missed{"gap", "1", kappabench::Method::sampled};
/// Of a sweep: the size of the first move with that effect, NaN if there is none.
const Quantity sweeps = count_of("sweeps");
const Quantity extremum_from{"extremum from", "1", kappabench::Method::sampled};
const Quantity inflection_from{"inflection from", "1", kappabench::Method::sampled};
const Quantity unsolved_from{"no solution from", "1", kappabench::Method::sampled};

/// The moves of Fig. 9(b) and (c) on the stand-in, controls counted from 0.
std::vector<MovedControl> drawn_moves(const StandardCurve& curve, int stage) {
  std::vector<MovedControl> moves;
  if (stage >= 1) moves.push_back({3, curve.controls[3] + 0.3});
  if (stage >= 2) moves.push_back({4, curve.controls[4] - 0.3});
  return moves;
}

Fit drawn_fit(const Uses& uses) {
  const auto& [others, words] = both[static_cast<std::size_t>(uses.numbers.at("others"))];
  const int stage = static_cast<int>(uses.numbers.at("stage"));
  const StandardData data = condition_of_figure_3();
  HermiteFit fit = solve(data);
  if (stage > 0 && fit.curve) fit = with_moved_controls(data, *fit.curve, drawn_moves(*fit.curve, stage), others);
  return as_fit(data, fit);
}

int inflections_of(const StandardCurve& curve) {
  const auto [low, high] = std::ranges::minmax(curve.controls);
  if (low >= 0.0 || high <= 0.0) return 0;
  return static_cast<int>(inflections(IntrinsicSegment(form_of(curve, 0.0))).at.size());
}

/// A control moved by `size` times the largest one, in steps that grow.
void sweep_moves(const StandardData& data, const StandardCurve& curve, int control, double direction, Others others,
                 std::string_view words, Notes& notes) {
  const double unit = direction * largest_control(curve), before = curve.controls[static_cast<std::size_t>(control)];
  const int neighbour = unit > 0.0 ? control + 1 : control - 1;
  const double next = curve.controls[static_cast<std::size_t>(neighbour)];
  const int inflections_before = inflections_of(curve);
  double extremum = std::nan(""), inflection = std::nan(""), unsolved = std::nan("");
  double size = smallest;
  for (int i = 0; i < sizes && std::isnan(unsolved); ++i, size *= growth) {
    const MovedControl move{control, before + size * unit};
    const HermiteFit fit = with_moved_controls(data, curve, {&move, 1}, others);
    const bool met = fit.outcome == Outcome::converged;
    // Between its neighbours as they were.
    const bool moderate = size * std::abs(unit) <= std::abs(next - before);
    if (moderate) notes.row({other_controls(words)}, {moderate_moves(1), moderate_solved(met ? 1 : 0)});
    if (!met) {
      unsolved = size;
      continue;
    }
    notes.row({other_controls(words)}, {missed(fit.residual)});
    if (std::isnan(extremum) && verdict_of(*fit.curve).extrema > 0) extremum = size;
    if (std::isnan(inflection) && inflections_of(*fit.curve) > inflections_before) inflection = size;
  }
  notes.row({other_controls(words)},
            {sweeps(1), extremum_from(extremum), inflection_from(inflection), unsolved_from(unsolved)});
}

void measure(const Uses& uses, Notes& notes) {
  const auto curves = static_cast<std::uint64_t>(uses.numbers.at("curves"));
  for (std::uint64_t i = 0; i < curves; ++i) {
    const StandardData data = random_angles(Angles::ordinary, uses.seed, i);
    const HermiteFit fit = solve(data);
    if (fit.outcome != Outcome::converged) continue;
    for (const auto& [others, words] : both)
      for (int control = 1; control + 1 < std::ssize(fit.curve->controls); ++control)
        for (const double direction : {-1.0, 1.0})
          sweep_moves(data, *fit.curve, control, direction, others, words, notes);
  }
}

constexpr std::array<std::string_view, 3> stages{"before", "fourth control up", "fifth control down, too"};

std::string dataset_of(int stage, std::string_view words) {
  return stage == 0 ? "before" : fmt::format("{}, {}", stages[static_cast<std::size_t>(stage)], words);
}

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr scheme = context.registry.create("intrinsic");
  std::vector<CellJob> jobs;
  const auto add = [&](int stage, int others, std::string_view label) {
    draw<drawn_fit>(jobs,
                    {.work = "moved controls", .schemes = {scheme}, .numbers = {{"stage", stage}, {"others", others}}},
                    dataset_of(stage, both[static_cast<std::size_t>(others)].second), std::string(label));
  };
  add(0, 0, "before");
  for (const int others : {0, 1})
    for (const int stage : {1, 2}) add(stage, others, both[static_cast<std::size_t>(others)].second);
  const long n = amounts(context, "intrinsic-control", {{"random-g1", random_curves}}).front();
  jobs.push_back(study::numbers_job<measure>(
      {.work = "moves", .schemes = {scheme}, .seed = context.seed, .numbers = {{"curves", static_cast<double>(n)}}},
      "random G1 conditions"));
  return jobs;
}

// ---- what follows

/// The sweeps with an effect, and the sizes of its first moves.
struct First {
  double sweeps = 0.0, median_size = 0.0, smallest_size = 0.0;
};
First first(const Rows& rows, const Quantity& from) {
  std::vector<double> found = rows.values(from);
  std::erase_if(found, [](double size) { return std::isnan(size); });
  return {static_cast<double>(found.size()), median(found),
          found.empty() ? std::nan("") : *std::ranges::min_element(found)};
}

Table move_table(const Findings& found) {
  Table table("moves", "How far a control curvature can be moved",
              fmt::format("Every inner control of random curves, up and down, by {:g} times the largest "
                          "control curvature and on in steps of a factor of {:g} to {:.3g}. Size: of the first "
                          "move with that effect.",
                          smallest, growth, smallest * std::pow(growth, sizes - 1)));
  table.words("other inner controls").words("effect").counts("sweeps").counts("with it");
  table.numbers("smallest size").numbers("median size");
  for (const auto& [others, words] : both) {
    const Rows rows = found.rows().where({other_controls(words)});
    if (rows.empty()) continue;
    for (const Quantity& from : {extremum_from, inflection_from, unsolved_from}) {
      const First effect = first(rows, from);
      table.row({words, from.name.substr(0, from.name.find(" from")), rows.total(sweeps), effect.sweeps,
                 effect.smallest_size, effect.median_size});
    }
  }
  return table;
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{
      .id = "intrinsic-control",
      .title = "Control curvatures that are moved",
      .caption =
          "The fourth control curvature of a stand-in is moved up, then the fifth down; points and tangents stay. "
          "Below: curvature with control curvatures (squares) and knots (ticks) when the other inner controls "
          "keep their values, and when they follow the ends again.",
      .columns = 3,
      .panels = {}};
  for (int stage = 0; stage < std::ssize(stages); ++stage) {
    std::vector<int> cells;
    for (const auto& [others, words] : both)
      if (const auto cell = found.find(dataset_of(stage, words), stage == 0 ? "before" : words);
          cell && (stage > 0 || cells.empty()))
        cells.push_back(*cell);
    if (!cells.empty())
      figure.panels.push_back(Panel::curves(cells, std::string(stages[static_cast<std::size_t>(stage)])).comb());
  }
  for (const auto& [others, words] : both)
    for (int stage = 0; stage < std::ssize(stages); ++stage)
      add_curvature_panel(figure, found, dataset_of(stage, words), std::string(stage == 0 ? "before" : words));
  return figure;
}

void claim_kept(Findings& found) {
  const Rows& rows = found.rows();
  const Tally tally{rows.total(moderate_solved), rows.total(moderate_moves)};
  found.judge(
      "moved-controls-keep-data", tally,
      {fmt::format("{} moves between the neighbours are solved", tally.words()),
       fmt::format("The data are missed by at most {:.2g} chords and radians after any solved move, others kept "
                   "or interpolated; a move that is not solved is a miss.",
                   std::max(0.0, rows.largest(missed)))});
}

/// Each of the three effects must be seen. That a control moved far enough makes an extremum cannot fail; that it makes
/// an inflection, or leaves no solution for the ends, can.
void claim_large(Findings& found) {
  std::array<Tally, 3> seen;
  std::vector<std::string> lines;
  for (const auto& [others, words] : both) {
    const Rows rows = found.rows().where({other_controls(words)});
    const First extremum = first(rows, extremum_from), inflection = first(rows, inflection_from),
                unsolved = first(rows, unsolved_from);
    seen[0] += {extremum.sweeps, rows.total(sweeps)};
    seen[1] += {inflection.sweeps, rows.total(sweeps)};
    seen[2] += {unsolved.sweeps, rows.total(sweeps)};
    lines.push_back(
        fmt::format("{}: extremum in {:.0f} (median size {:.2g}), inflection in {:.0f} ({:.2g}), no solution "
                    "in {:.0f} ({:.2g})",
                    words, extremum.sweeps, extremum.median_size, inflection.sweeps, inflection.median_size,
                    unsolved.sweeps, unsolved.median_size));
  }
  found.judge("large-moves", study::weaker(seen[0], study::weaker(seen[1], seen[2])),
              {fmt::format("{:.0f} sweeps of growing moves; {}", found.rows().total(sweeps), fmt::join(lines, "; ")),
               "The rarest of the three effects is judged. Sizes over the largest control curvature before; an "
               "inflection is one more than before."});
}

void conclude(Findings& found) {
  found.add(drawn_table(found));
  found.add(move_table(found));
  found.add(figure(found));
  claim_kept(found);
  claim_large(found);
}

}  // namespace

Experiment intrinsic_control_experiment() {
  return study::experiment({.id = "intrinsic-control",
                            .title = "Control curvatures moved by hand (Yoshida 2022, Fig. 9)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"moved-controls-keep-data", "large-moves"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
