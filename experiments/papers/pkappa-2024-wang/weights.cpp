// Wang 2024, Fig. 10 and Table 1: which weights (λe, λc) bring curvature nearest to parabolas?
#include "experiments/papers/pkappa-2024-wang/weights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "experiments/papers/pkappa-2024-wang/ranks.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/measured.hpp"
#include "metrics/fairness.hpp"
#include "metrics/features.hpp"
#include "metrics/parabola_energy.hpp"

namespace kappabench {
namespace {

using namespace wang;
using study::Findings, study::Panel, study::Quantity, study::Rows, study::Table, study::Tally;

constexpr std::string_view about =
    "The eight pairs of weights of Table 1. First as in the paper, on one drawing. Then what the paper does not have: "
    "on random curves, with the change that a perturbation of the points by 1e-9 mean chords makes, and at several "
    "scales, because the energies have units (E_p 1/length, E_e length⁴, E_c length²) and the paper does not state its "
    "own. The windows are solved as printed (mode=paper): stage 2 drops both weights and is capped, here at 10 "
    "iterations; its tolerance and cap are not printed either.";

Rows rows_of(const Findings& found, const Weights& weights) { return found.rows().where({weights_key(weights.words)}); }

/// The eight numbers of every curve that has all of them, in the order of Table 1.
std::vector<std::vector<double>> by_curve(const Rows& rows, const Quantity& what) {
  std::vector<std::vector<double>> all;
  for (const auto& [curve, own] : rows.by(curve_number))
    if (std::vector<double> eight = own.values(what); eight.size() == table_1.size()) all.push_back(std::move(eight));
  return all;
}

/// The eight medians over the curves.
std::vector<double> medians(const Rows& rows, const Quantity& what) {
  std::vector<double> all;
  for (const Weights& weights : table_1) all.push_back(rows.where({weights_key(weights.words)}).median(what));
  return all;
}

std::vector<double> printed_means() {
  std::vector<double> all;
  for (const Weights& weights : table_1) all.push_back(weights.mean);
  return all;
}

/// Has this pair of weights the lowest energy of the eight?
bool best(const std::vector<double>& energies, std::size_t pair) {
  return std::isfinite(energies[pair]) && energies[pair] == *std::ranges::min_element(energies);
}

/// The stand-in for Fig. 10; null if it is not there.
const store::CurveRecord* stand_in(const Findings& found, const Weights& weights) {
  const auto cell = found.find(weights_drawing, weights.words);
  return cell ? found.curve(*cell) : nullptr;
}

double energy_of(const store::CurveRecord& stand_in) {
  return measured(stand_in, column::parabola_energy_native.mean).value_or(std::numeric_limits<double>::infinity());
}

double crossing_curves(const Rows& rows) {
  return static_cast<double>(std::ranges::count_if(rows.values(crossings), [](double c) { return c > 0.0; }));
}

// ---- tables

Table stand_in_table(const Findings& found) {
  Table table(
      "table-1", "Table 1 and a stand-in",
      fmt::format("Mean and largest E_p as printed, and of a drawing of ten points (8 segments) with mean chord "
                  "{:g}: other points than the paper's, in another unit, so only the order of the rows "
                  "compares. Length over that of the polygon through the points, and crossings of the curve "
                  "with itself.",
                  usual_chord));
  table.words("weights").numbers("mean E, printed").numbers("max E, printed");
  table.numbers("mean E", "1/length").numbers("max E", "1/length").numbers("length").counts("crossings");
  table.words("outcome");
  for (const Weights& weights : table_1)
    if (const auto* curve = stand_in(found, weights)) {
      const auto value = [curve](const Column& column) { return measured(*curve, column).value_or(undefined); };
      table.row({weights.words, weights.mean, weights.largest, value(column::parabola_energy_native.mean),
                 value(column::parabola_energy_native.max), value(column::length_over_chords), value(column::loops),
                 curve->outcome});
    }
  return table;
}

Table random_table(const Findings& found) {
  Table table("random", "The same over random curves",
              fmt::format("{} random open walks of {} points, mean chord {:g}. "
                          "Medians over the curves of mean and largest E_p; a curve that was not solved counts as "
                          "infinite. Best: curves on which the row has the lowest mean E. Sensitivity: relative change "
                          "of mean E when every point moves by {:g} mean chords, over {} curves. Robust: mean E times "
                          "mean chord over {} curves by mode=local with unit=chord, whose stage 2 keeps a tenth of the "
                          "weights.",
                          walks, walk_points, usual_chord, perturbation, perturbed_walks, robust_walks));
  table.words("weights").counts("solved").numbers("mean E", "1/length").numbers("max E", "1/length").counts("best");
  table.numbers("length").counts("curves that cross");
  table.numbers("sensitivity, median").numbers("sensitivity, largest").numbers("robust");
  const auto energies = by_curve(found.rows(), mean_energy);
  for (std::size_t p = 0; p < table_1.size() && !energies.empty(); ++p) {
    const Rows own = rows_of(found, table_1[p]);
    table.row({table_1[p].words, own.total(was_solved), own.median(mean_energy), own.median(largest_energy),
               std::ranges::count_if(energies, [p](const auto& eight) { return best(eight, p); }), own.median(length),
               crossing_curves(own), own.median(sensitivity), own.largest(sensitivity), own.median(robust_energy)});
  }
  return table;
}

Table scale_table(const Findings& found) {
  Table table(
      "scales", "The same at several scales",
      fmt::format("Median over {} random curves of mean E times mean chord, with the weights as printed and the "
                  "mean chord as given: the choice of the unit is a choice of the weights.",
                  scaled_walks));
  table.words("weights").numbers("mean chord").numbers("mean E times mean chord");
  for (const Weights& weights : table_1)
    for (const auto& [chord, own] : rows_of(found, weights).by(chord_key))
      table.row({weights.words, std::get<double>(chord), own.median(scaled_energy)});
  return table;
}

Table rank_table(const Findings& found) {
  Table table("ranks", "Does the order of the rows agree with Table 1?",
              "Spearman's rank correlation of the eight mean energies with the printed ones: of the medians "
              "over random curves, and the median of the single curves' correlations.");
  table.numbers("mean chord").numbers("correlation of medians").numbers("median correlation");
  for (const auto& [chord, own] : found.rows().by(chord_key)) {
    std::vector<double> single;
    for (const auto& eight : by_curve(own, scaled_energy)) single.push_back(rank_correlation(eight, printed_means()));
    table.row(
        {std::get<double>(chord), rank_correlation(medians(own, scaled_energy), printed_means()), median(single)});
  }
  return table;
}

/// Length without weights over that with (0.1, 0.1), curve by curve.
std::vector<double> elongations(const Rows& rows, const Quantity& length) {
  std::vector<double> ratios;
  for (const auto& [without, with] :
       rows.pairs(length, weights_key(table_1[unweighted].words), weights_key(table_1[chosen].words)))
    ratios.push_back(without / with);
  return ratios;
}

Table cap_table(const Findings& found) {
  Table table("caps", "How far stage 2 goes",
              fmt::format("Stage 2 as printed, without weights, from weights (0, 0) and (0.1, 0.1) in stage 1, "
                          "by the cap on its iterations; {} random walks, mean chord {:g}. Medians of mean E, "
                          "and length of the first over that of the second.",
                          capped_walks, usual_chord));
  table.counts("cap").numbers("mean E, (0, 0)", "1/length").numbers("mean E, (0.1, 0.1)", "1/length");
  table.numbers("length ratio, median").numbers("length ratio, largest");
  for (const auto& [cap, rows] : found.rows().by(cap_key)) {
    const Rows& own = rows;  // a lambda cannot name a part of a pair
    const auto energy = [&own](std::size_t p) {
      return own.where({weights_key(table_1[p].words)}).median(capped_energy);
    };
    const std::vector<double> ratios = elongations(own, capped_length);
    table.row({std::get<double>(cap), energy(unweighted), energy(chosen), median(ratios), largest(ratios)});
  }
  return table;
}

/// What the graph shows, long.
Table bars_table(const Findings& found) {
  Table table("bars", "Mean E by pair of weights",
              "Printed; of the stand-in; medians over random curves (mode=paper, and the default mode in units "
              "of the mean chord).");
  table.words("weights").words("of").numbers("mean E");
  for (const Weights& weights : table_1) table.row({weights.words, "printed", weights.mean});
  for (const Weights& weights : table_1)
    if (const auto* curve = stand_in(found, weights)) table.row({weights.words, "stand-in", energy_of(*curve)});
  for (const auto& [of, what] :
       {std::pair("random, as printed", &mean_energy), std::pair("random, default mode", &robust_energy)})
    for (const Weights& weights : table_1)
      if (const Rows own = rows_of(found, weights); !own.values(*what).empty())
        table.row({weights.words, of, own.median(*what)});
  return table;
}

// ---- verdicts

/// Why Table 1 and what follows from it cannot be judged.
constexpr std::string_view not_printed =
    "The unit of the paper's drawing, its tolerance and its cap are not printed, and neither is how far stage 2 went; "
    "the order of the eight rows changes with them (tables of this experiment).";

void claim_elongation(Findings& found) {
  /// "Excessively long" begins here: a tenth longer than with weights (0.1, 0.1).
  constexpr double elongated = 1.1;
  std::vector<double> ratios = elongations(found.rows(), length);
  std::erase_if(ratios, [](double ratio) { return !std::isfinite(ratio); });
  Tally longer;
  for (const double ratio : ratios) longer.add(ratio >= elongated);
  const std::vector<double> capped = elongations(found.rows().where({cap_key(caps.back())}), capped_length);
  found.judge(
      "no-weights-elongate", longer,
      {fmt::format("at least a tenth longer than with (0.1, 0.1) on {}; median ratio {:.3g}, largest {:.3g}",
                   longer.words(), median(ratios), largest(ratios)),
       fmt::format("Random curves that both rows drew, of which {} are longer at all. Curves that cross themselves: "
                   "{:.0f} without weights, {:.0f} with (0.1, 0.1). With a cap of {} iterations in stage 2 the median "
                   "ratio is {:.3g}, the largest {:.3g}. The paper's cap is unknown.",
                   std::ranges::count_if(ratios, [](double r) { return r > 1.0; }),
                   crossing_curves(rows_of(found, table_1[unweighted])),
                   crossing_curves(rows_of(found, table_1[chosen])), caps.back(), median(capped), largest(capped))});
}

void claim_best(Findings& found) {
  Tally lowest;
  for (const auto& eight : by_curve(found.rows(), mean_energy)) lowest.add(best(eight, chosen));
  found.undecidable(
      "best-weights",
      {fmt::format("lowest of the eight on {}", lowest.words()),
       fmt::format("Random open curves of {} points, mean chord {:g}; unsolved curves count as infinite. {}",
                   walk_points, usual_chord, not_printed)});
}

/// Sect. 6.1: "favourable" for λe in [0, 0.1] and λc in [0.1, 1].
void claim_range(Findings& found) {
  Tally lower;
  for (const auto& eight : by_curve(found.rows(), mean_energy))
    for (const std::size_t in : {1UL, 2UL, chosen, 7UL})
      for (const std::size_t out : {unweighted, heavy_edges, edges_alone, 6UL}) lower.add(eight[in] < eight[out]);
  found.undecidable(
      "favourable-range",
      {fmt::format("lower mean E inside the range than outside in {}", lower.words()),
       fmt::format("Every pair of a row inside the range and one outside it, on every random curve. {}", not_printed)});
}

void claim_crossings(Findings& found) {
  Tally more, fewer;
  for (const auto& eight : by_curve(found.rows(), crossings)) {
    more.add(eight[heavy_edges] > eight[chosen]);
    fewer.add(eight[heavy_edges] < eight[chosen]);
  }
  found.judge("large-edge-weight-crosses", more,
              {fmt::format("more crossings than with (0.1, 0.1) on {:.0f} of {:.0f} curves, fewer on {:.0f}",
                           more.agree, more.cases, fewer.agree),
               "Crossings of random curves with themselves at weights (1, 0.1). The paper says that they may occur."});
}

void claim_order(Findings& found) {
  const double of_medians = rank_correlation(medians(found.rows(), mean_energy), printed_means());
  std::vector<double> ours, theirs;
  for (const Weights& weights : table_1)
    if (const auto* curve = stand_in(found, weights)) {
      ours.push_back(energy_of(*curve));
      theirs.push_back(weights.mean);
    }
  found.undecidable("table-1-order",
                    {fmt::format("rank correlation {:.2f} for medians over random curves, {:.2f} for the stand-in",
                                 of_medians, rank_correlation(ours, theirs)),
                     fmt::format("{} random curves. {}", by_curve(found.rows(), mean_energy).size(), not_printed)});
}

// ---- figures

store::FigureRecord drawn_figure(const Findings& found) {
  store::FigureRecord figure{.id = "pkappa-weights",
                             .title = "Eight pairs of weights (λe, λc)",
                             .caption = "The same ten points; combs have one scale. Stand-in for Fig. 10.",
                             .columns = 4,
                             .panels = {}};
  for (const Weights& weights : table_1)
    if (const auto cell = found.find(weights_drawing, weights.words))
      figure.panels.push_back(Panel::curves({*cell}, std::string(weights.words)).comb());
  return figure;
}

store::FigureRecord random_figure() {
  return {.id = "pkappa-weights-random",
          .title = "The weights on random curves",
          .caption =
              "Left: mean E as printed, of the stand-in, and its median over random curves, "
              "as printed and by the default mode. Right: the rank correlation of our eight "
              "rows with the printed ones, by the unit of length.",
          .columns = 2,
          .panels = {Panel::graph("bars", "weights", {"mean E"}, "printed, and random curves")
                         .series("of")
                         .labels("(λe, λc)", "mean E")
                         .log_y(),
                     Panel::graph("ranks", "mean chord", {"correlation of medians", "median correlation"},
                                  "agreement with the printed order")
                         .labels("mean chord in units of the energies", "rank correlation")
                         .log_x()}};
}

void conclude(Findings& found) {
  for (const auto table : {stand_in_table, random_table, scale_table, rank_table, cap_table, bars_table})
    found.add(table(found));
  for (const auto claim : {claim_elongation, claim_best, claim_range, claim_crossings, claim_order}) claim(found);
  found.add(drawn_figure(found));
  if (!found.cells().empty()) found.add(random_figure());
}

}  // namespace

Experiment pkappa_weights_experiment() {
  return study::experiment({.id = "pkappa-weights",
                            .title = "Weights of the energy (Wang 2024, Fig. 10 and Table 1)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"no-weights-elongate", "best-weights", "favourable-range",
                                       "large-edge-weight-crosses", "table-1-order"},
                            .jobs = wang::weights_jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
