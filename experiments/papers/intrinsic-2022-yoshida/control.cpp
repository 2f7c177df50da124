#include "experiments/run/experiment.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/inputs.hpp"
#include "experiments/study/summaries.hpp"
#include "schemes/curve/exact_curvature.hpp"
#include "schemes/intrinsic/edit.hpp"
#include "schemes/segments/intrinsic.hpp"

namespace kappabench {

using namespace yoshida;
using namespace intrinsic;

namespace {

constexpr std::string_view about =
    "A G1 curve with six control curvatures. The fourth is moved, then the fifth; the first and the last are solved "
    "for again, so that the curve still meets both points and tangents. The paper does not say whether the other inner "
    "controls stay or follow the ends again (Eqs. (10) and (11)): both are drawn. Then every inner control of random "
    "curves (the paper's angles) is moved by more and more, up and down, until curvature has an extremum, another "
    "inflection, or there is no solution. Moves are given over the largest control curvature before.";

constexpr int version = 1;
constexpr long random_curves = 12;  ///< unless the plan says otherwise
/// A factor of 1.6 between sizes of moves: 0.001 to about 300.
constexpr int sizes = 28;
constexpr double smallest = 0.001, growth = 1.6;
constexpr std::array both{std::pair{Others::kept, std::string_view("others kept")},
                          std::pair{Others::interpolated, std::string_view("others interpolated")}};

StandardData drawn_condition() {
  constexpr double degree = std::numbers::pi / 180.0;
  return {25.0 * degree, 75.0 * degree, {}, {}};
}

/// The moves of Fig. 9(b) and (c) on the stand-in, controls counted from 0.
std::vector<MovedControl> drawn_moves(const StandardCurve& curve, int stage) {
  std::vector<MovedControl> moves;
  if (stage >= 1) moves.push_back({3, curve.controls[3] + 0.3});
  if (stage >= 2) moves.push_back({4, curve.controls[4] - 0.3});
  return moves;
}

HermiteFit drawn_fit(int stage, Others others) {
  const StandardData data = drawn_condition();
  HermiteFit fit = solve(data);
  if (stage == 0 || !fit.curve) return fit;
  return with_moved_controls(data, *fit.curve, drawn_moves(*fit.curve, stage), others);
}

int inflections_of(const StandardCurve& curve) {
  const auto [low, high] = std::ranges::minmax(curve.controls);
  if (low >= 0.0 || high <= 0.0) return 0;
  return static_cast<int>(inflections(IntrinsicSegment(form_of(curve, 0.0))).at.size());
}

/// A control moved by `size` times the largest one, in steps that grow.
void sweep_moves(const StandardData& data, const StandardCurve& curve, int control, double direction, Others others,
                 std::string_view words, store::CellRecord& cell) {
  const double unit = direction * largest_control(curve), before = curve.controls[static_cast<std::size_t>(control)];
  const int neighbour = unit > 0.0 ? control + 1 : control - 1;
  const double next = curve.controls[static_cast<std::size_t>(neighbour)];
  const int inflections_before = inflections_of(curve);
  const auto column = [words](std::string_view what) { return fmt::format("{}: {}", words, what); };
  double extremum = std::nan(""), inflection = std::nan(""), unsolved = std::nan("");
  double size = smallest;
  for (int i = 0; i < sizes && std::isnan(unsolved); ++i, size *= growth) {
    const MovedControl move{control, before + size * unit};
    const HermiteFit fit = with_moved_controls(data, curve, {&move, 1}, others);
    const bool met = fit.outcome == Outcome::converged;
    // Between its neighbours as they were.
    const bool moderate = size * std::abs(unit) <= std::abs(next - before);
    if (moderate) {
      study::put(cell, column("moderate moves"), 1.0);
      study::put(cell, column("moderate moves solved"), met ? 1.0 : 0.0);
    }
    if (!met) {
      unsolved = size;
      continue;
    }
    study::put(cell, column("gap"), fit.residual, kappabench::Method::sampled);
    if (std::isnan(extremum) && verdict_of(*fit.curve).extrema > 0) extremum = size;
    if (std::isnan(inflection) && inflections_of(*fit.curve) > inflections_before) inflection = size;
  }
  study::put(cell, column("sweeps"), 1.0);
  study::put(cell, column("extremum from"), extremum);
  study::put(cell, column("inflection from"), inflection);
  study::put(cell, column("no solution from"), unsolved);
}

void measure(std::uint64_t seed, long n, store::CellRecord& cell) {
  for (long i = 0; i < n; ++i) {
    const StandardData data = random_angles(Angles::ordinary, seed, static_cast<std::uint64_t>(i));
    const HermiteFit fit = solve(data);
    if (fit.outcome != Outcome::converged) continue;
    for (const auto& [others, words] : both)
      for (int control = 1; control + 1 < std::ssize(fit.curve->controls); ++control)
        for (const double direction : {-1.0, 1.0})
          sweep_moves(data, *fit.curve, control, direction, others, words, cell);
  }
}

constexpr std::array<std::string_view, 3> stages{"before", "fourth control up", "fifth control down, too"};

std::string dataset_of(int stage, std::string_view words) {
  return stage == 0 ? "before" : fmt::format("{}, {}", stages[static_cast<std::size_t>(stage)], words);
}

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr scheme = context.registry.create("intrinsic");
  std::vector<CellJob> jobs;
  const auto add = [&](int stage, Others others, std::string_view words, const std::string& label) {
    std::ranges::move(drawn_jobs(scheme, dataset_of(stage, words), label, version,
                                 [stage, others] { return as_fit(drawn_condition(), drawn_fit(stage, others)); }),
                      std::back_inserter(jobs));
  };
  add(0, Others::kept, both[0].second, "before");
  for (const auto& [others, words] : both)
    for (const int stage : {1, 2}) add(stage, others, words, std::string(words));
  const std::uint64_t seed = context.seed;
  const long n = amounts(context, "intrinsic-control", {{"random-g1", random_curves}}).front();
  jobs.push_back(numbers_job(scheme, "random G1 conditions", fmt::format("moves, {} curves, seed {}", n, seed), version,
                             [seed, n](store::CellRecord& cell) { measure(seed, n, cell); }));
  return jobs;
}

double sum(const store::ExperimentRecord& record, std::string_view words, std::string_view what) {
  return study::total(record, fmt::format("{}: {}", words, what));
}

/// The sizes at which something first happened, and in how many sweeps it did.
struct First {
  double sweeps = 0.0, median_size = 0.0, smallest_size = 0.0;
};
First first(const store::ExperimentRecord& record, std::string_view words, std::string_view what) {
  std::vector<double> found = study::values(record, fmt::format("{}: {}", words, what));
  std::erase_if(found, [](double size) { return std::isnan(size); });
  return {static_cast<double>(found.size()), median(found),
          found.empty() ? std::nan("") : *std::ranges::min_element(found)};
}

store::TableRecord move_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "moves", "How far a control curvature can be moved",
      fmt::format("Every inner control of random curves, up and down, by {:g} times the largest "
                  "control curvature and on in steps of a factor of {:g} to {:.3g}. Size: of the first "
                  "move with that effect.",
                  smallest, growth, smallest * std::pow(growth, sizes - 1)));
  builder.words("other inner controls").words("effect").counts("sweeps").counts("with it");
  builder.numbers("smallest size").numbers("median size");
  for (const auto& [others, words] : both)
    for (const std::string_view what : {"extremum from", "inflection from", "no solution from"}) {
      const First found = first(record, words, what);
      const double sweeps = sum(record, words, "sweeps");
      if (sweeps > 0.0)
        builder.row({std::string(words), std::string(what.substr(0, what.find(" from"))), sweeps, found.sweeps,
                     found.smallest_size, found.median_size});
    }
  return builder.table();
}

store::FigureRecord figure(const store::ExperimentRecord& record) {
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
    store::PanelRecord panel{.kind = "curve", .title = std::string(stages[static_cast<std::size_t>(stage)])};
    panel.comb = true;
    for (const auto& [others, words] : both)
      if (const auto cell = curve_of(record, dataset_of(stage, words)); cell && (stage > 0 || panel.cells.empty()))
        panel.cells.push_back(*cell);
    if (!panel.cells.empty()) figure.panels.push_back(std::move(panel));
  }
  for (const auto& [others, words] : both)
    for (int stage = 0; stage < std::ssize(stages); ++stage)
      add_curvature_panel(figure, record, dataset_of(stage, words), std::string(stage == 0 ? "before" : words));
  return figure;
}

store::ClaimRecord kept_claim(const store::ExperimentRecord& record) {
  double moves = 0.0, solved = 0.0, missed = 0.0;
  for (const auto& [others, words] : both) {
    moves += sum(record, words, "moderate moves");
    solved += sum(record, words, "moderate moves solved");
    missed = std::max({missed, 0.0, largest(study::values(record, fmt::format("{}: gap", words)))});
  }
  return claim(
      "moved-controls-keep-data", study::verdict_for_all(moves - solved, moves),
      fmt::format("{} moves between the neighbours are solved", study::share(solved, moves)),
      fmt::format("The data are missed by at most {:.2g} chords and radians after any solved move, others kept "
                  "or interpolated.",
                  missed));
}

store::ClaimRecord large_claim(const store::ExperimentRecord& record) {
  double effects = 0.0, sweeps = 0.0;
  std::vector<std::string> lines;
  for (const auto& [others, words] : both) {
    sweeps += sum(record, words, "sweeps");
    const First extremum = first(record, words, "extremum from"), inflection = first(record, words, "inflection from"),
                unsolved = first(record, words, "no solution from");
    effects += extremum.sweeps + inflection.sweeps + unsolved.sweeps;
    lines.push_back(
        fmt::format("{}: extremum in {:.0f} (median size {:.2g}), inflection in {:.0f} ({:.2g}), no solution "
                    "in {:.0f} ({:.2g})",
                    words, extremum.sweeps, extremum.median_size, inflection.sweeps, inflection.median_size,
                    unsolved.sweeps, unsolved.median_size));
  }
  return claim("large-moves",
               !(sweeps > 0.0) ? "not reproduced"
               : effects > 0.0 ? "reproduced"
                               : "contradicted",
               fmt::format("{:.0f} sweeps of growing moves; {}", sweeps, fmt::join(lines, "; ")),
               "Sizes over the largest control curvature before; an inflection is one more than before.");
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {drawn_table(record), move_table(record)};
  if (auto drawn = figure(record); !drawn.panels.empty()) record.figures = {std::move(drawn)};
  record.claims = {kept_claim(record), large_claim(record)};
}

}  // namespace

Experiment intrinsic_control_experiment() {
  return {.id = "intrinsic-control",
          .title = "Control curvatures moved by hand (Yoshida 2022, Fig. 9)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
