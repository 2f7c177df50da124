#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "datasets/random_points.hpp"
#include "datasets/random_source.hpp"
#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/study/summaries.hpp"
#include "metrics/self_intersection.hpp"
#include "schemes/curve/arc_length.hpp"

namespace kappabench {

using namespace wang;

namespace {

constexpr std::string_view about =
    "The eight pairs of weights of Table 1. First as in the paper, on one drawing. Then what the paper does not have: "
    "on random curves, with the change that a perturbation of the points by 1e-9 mean chords makes, and at several "
    "scales, because the energies have units (E_p 1/length, E_e length⁴, E_c length²) and the paper does not state its "
    "own. The windows are solved as printed (mode=paper): stage 2 drops both weights and is capped, here at 10 "
    "iterations; its tolerance and cap are not printed either.";

/// A column of Table 1.
struct Pair {
  std::string_view words, lambda_e, lambda_c;
  double mean, largest;  ///< printed
};
constexpr std::array<Pair, 8> pairs{{{"(0, 0)", "0", "0", 8.33e-3, 4.98e-2},
                                     {"(0, 0.1)", "0", "0.1", 3.18e-4, 1.56e-3},
                                     {"(0.01, 0.1)", "0.01", "0.1", 3.02e-4, 1.56e-3},
                                     {"(1, 0.1)", "1", "0.1", 1.67e-2, 8.36e-2},
                                     {"(0.1, 0.1)", "0.1", "0.1", 1.18e-4, 3.24e-4},
                                     {"(0.1, 0)", "0.1", "0", 6.51e-4, 4.07e-3},
                                     {"(0.1, 0.01)", "0.1", "0.01", 2.27e-3, 1.29e-2},
                                     {"(0.1, 1)", "0.1", "1", 3.32e-4, 1.52e-3}}};
constexpr std::size_t unweighted = 0, chosen = 4, heavy_edges = 3;
/// Sect. 6.1: "favourable" for lambda_e in [0, 0.1] and lambda_c in [0.1, 1].
constexpr std::array<std::size_t, 4> favourable{1, 2, 4, 7}, others{0, 3, 5, 6};

constexpr std::string_view shown = "weights", random_name = "random";
constexpr int version = 1, points = 6, curves = 100, robust_curves = 15, perturbed_curves = 10, scaled_curves = 6;
/// Of the scales tried, where the medians of the rows agree best with the printed order (table "ranks").
constexpr double usual_chord = 8.5, perturbation = 1e-9;
constexpr std::array scales{1.0, 3.0, 8.5, 25.0};
constexpr std::array caps{0, 3, 10, 30};
constexpr int capped_curves = 6;
/// "Excessively long" begins here: a tenth longer than with weights (0.1, 0.1).
constexpr double elongated = 1.1;
constexpr double no_energy = std::numeric_limits<double>::infinity();

SchemePtr printed(const Registry& registry, const Pair& pair) {
  return pkappa(registry, fmt::format("mode=paper,lambda_e={},lambda_c={}", pair.lambda_e, pair.lambda_c));
}
SchemePtr capped(const Registry& registry, const Pair& pair, int cap) {
  return pkappa(registry, fmt::format("mode=paper,lambda_e={},lambda_c={},stage2_iterations={}", pair.lambda_e,
                                      pair.lambda_c, cap));
}
SchemePtr robust(const Registry& registry, const Pair& pair) {
  return pkappa(registry, fmt::format("lambda_e={},lambda_c={}", pair.lambda_e, pair.lambda_c));
}

struct Energy {
  double mean = no_energy, largest = no_energy;
};

Energy energy_of(const Fit& fit) {
  if (!study::solved(fit)) return {};
  const std::vector<double> all = parabola_energies(*fit.curve);
  return {mean(all), largest(all)};
}

Input walk(std::uint64_t seed, int index) {
  return random_input(RandomKind::walk, points, seed + static_cast<std::uint64_t>(index), false);
}

Input perturbed(Input input, int index) {
  RandomSource random(static_cast<std::uint64_t>(index) + 1);
  const double size = perturbation * mean_chord(input);
  for (Vec2& point : input.points) {
    const double x = random.normal(), y = random.normal();
    point += size * Vec2(x, y);
  }
  return input;
}

/// One random curve: everything that the tables ask of it. A curve that was not solved counts with infinite energy.
void measure(const Scheme& scheme, std::uint64_t seed, int index, store::CellRecord& cell) {
  const Input usual = scaled_to(walk(seed, index), usual_chord);
  const Fit fit = scheme.fit(usual);
  const Energy energy = energy_of(fit);
  const auto put = [&cell](std::string column, double value) {
    study::put(cell, std::move(column), value, Method::sampled);
  };
  put("mean", energy.mean);
  put("largest", energy.largest);
  put("solved", study::solved(fit) ? 1.0 : 0.0);
  const bool drawn = fit.curve.has_value();
  put("length", drawn ? arc_length(*fit.curve, 1e-6) / (usual_chord * (points - 1)) : std::nan(""));
  put("crossings", drawn ? static_cast<double>(self_intersections(*fit.curve).found.size()) : std::nan(""));
  if (index < perturbed_curves)
    put("sensitivity", std::abs(energy_of(scheme.fit(perturbed(usual, index))).mean / energy.mean - 1.0));
  if (index < scaled_curves)
    for (const double scale : scales) {
      const double mean = scale == usual_chord ? energy.mean : energy_of(scheme.fit(scaled_to(usual, scale))).mean;
      put(fmt::format("at {:g}", scale), mean * scale);
    }
}

std::string random_label(const Pair& pair) { return fmt::format("{} {}", random_name, pair.words); }
std::string robust_label(const Pair& pair) { return fmt::format("robust {}", pair.words); }

std::string cap_label(const Pair& pair, int cap) { return fmt::format("cap {} {}", cap, pair.words); }

void measure_capped(const Scheme& scheme, const Input& input, store::CellRecord& cell) {
  const Fit fit = scheme.fit(input);
  study::put(cell, "capped mean", energy_of(fit).mean, Method::sampled);
  study::put(cell, "capped length", fit.curve ? arc_length(*fit.curve, 1e-6) : std::nan(""), Method::sampled);
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const Drawing stand_in = scaled_to(drawing(shown), usual_chord);
  const std::uint64_t seed = context.seed;
  const std::vector<const Metric*> metrics{&find_metric("parabola_energy"), &find_metric("fairness"),
                                           &find_metric("features")};
  for (const Pair& pair : pairs) {
    CellJob job = fit_job(stand_in, printed(context.registry, pair), metrics);
    job.label = pair.words;
    jobs.push_back(std::move(job));
  }
  const std::string dataset = fmt::format("random walks, {} points, seed {}", points, seed);
  for (const Pair& pair : pairs) {
    const SchemePtr scheme = printed(context.registry, pair);
    jobs.push_back(
        sweep_job(dataset, scheme, random_label(pair), version, curves,
                  [scheme, seed](int index, store::CellRecord& cell) { measure(*scheme, seed, index, cell); }));
    const SchemePtr own = robust(context.registry, pair);
    jobs.push_back(sweep_job(dataset, own, robust_label(pair), version, robust_curves,
                             [own, seed](int index, store::CellRecord& cell) {
                               const Input input = walk(seed, index);
                               study::put(cell, "robust mean", energy_of(own->fit(input)).mean, Method::sampled);
                             }));
  }
  for (const std::size_t p : {unweighted, chosen})
    for (const int cap : caps) {
      const SchemePtr scheme = capped(context.registry, pairs[p], cap);
      jobs.push_back(sweep_job(dataset, scheme, cap_label(pairs[p], cap), version, capped_curves,
                               [scheme, seed](int index, store::CellRecord& cell) {
                                 measure_capped(*scheme, scaled_to(walk(seed, index), usual_chord), cell);
                               }));
    }
  return jobs;
}

/// All values of a column for one pair, in the order of the curves.
std::vector<double> column_of(const store::ExperimentRecord& record, const std::string& label,
                              std::string_view column) {
  std::vector<double> all;
  for (const int c : cells_labelled(record, label))
    for (const store::MeasurementRecord& m : record.cells[static_cast<std::size_t>(c)].measurements)
      if (m.column == column) all.push_back(m.value);
  return all;
}

/// The pairs' values of a column for every curve: [pair][curve]. Empty unless all pairs have equally many.
std::vector<std::vector<double>> by_pair(const store::ExperimentRecord& record, std::string_view column) {
  std::vector<std::vector<double>> all;
  for (const Pair& pair : pairs) all.push_back(column_of(record, random_label(pair), column));
  const auto unequal = [&all](const auto& values) { return values.empty() || values.size() != all.front().size(); };
  if (std::ranges::any_of(all, unequal)) return {};
  return all;
}

std::vector<double> medians_of(const std::vector<std::vector<double>>& all) {
  std::vector<double> found;
  for (const auto& values : all) found.push_back(median(values));
  return found;
}

std::vector<double> printed_means() {
  std::vector<double> found;
  for (const Pair& pair : pairs) found.push_back(pair.mean);
  return found;
}

const store::CurveRecord* shown_curve(const store::ExperimentRecord& record, const Pair& pair) {
  const auto cell = study::drawn_cell(record, shown, pair.words);
  if (!cell || record.cells[static_cast<std::size_t>(*cell)].curves.empty()) return nullptr;
  return &record.cells[static_cast<std::size_t>(*cell)].curves.front();
}

store::TableRecord stand_in_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "table-1", "Table 1 and a stand-in",
      fmt::format("Mean and largest E_p as printed, and of a drawing of ten points (8 segments) with mean chord {:g}: "
                  "other points than the paper's, in another unit, so only the order of the rows compares. Length over "
                  "that of the polygon through the points, and crossings of the curve with itself.",
                  usual_chord));
  builder.words("weights").numbers("mean E, printed").numbers("max E, printed");
  builder.numbers("mean E", "1/length").numbers("max E", "1/length").numbers("length").counts("crossings");
  builder.words("outcome");
  for (const Pair& pair : pairs)
    if (const auto* curve = shown_curve(record, pair)) {
      const auto value = [curve](std::string_view column) { return measured(*curve, column).value_or(std::nan("")); };
      builder.row({std::string(pair.words), pair.mean, pair.largest, value("parabola_energy_native_mean"),
                   value("parabola_energy_native_max"), value("length_over_chords"), value("loops"), curve->outcome});
    }
  return builder.table();
}

store::TableRecord random_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "random", "The same over random curves",
      fmt::format("{} random open walks of {} points, mean chord {:g}. "
                  "Medians over the curves of mean and largest E_p; a curve that was not solved counts as infinite. "
                  "Best: curves on which the row has the lowest mean E. Sensitivity: relative change of mean E when "
                  "every point moves by {:g} mean chords, over {} curves. Robust: mean E times mean chord over {} "
                  "curves by the "
                  "default mode, whose unit is the mean chord and whose stage 2 keeps a tenth of the weights.",
                  curves, points, usual_chord, perturbation, perturbed_curves, robust_curves));
  builder.words("weights").counts("solved").numbers("mean E", "1/length").numbers("max E", "1/length").counts("best");
  builder.numbers("length").counts("curves that cross");
  builder.numbers("sensitivity, median").numbers("sensitivity, largest").numbers("robust");
  const auto means = by_pair(record, "mean");
  if (means.empty()) return builder.table();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const std::string label = random_label(pairs[p]);
    double best = 0.0, solved = 0.0;
    for (std::size_t i = 0; i < means[p].size(); ++i) {
      const auto lowest = [&](const auto& other) { return means[p][i] <= other[i]; };
      best += std::isfinite(means[p][i]) && std::ranges::all_of(means, lowest) ? 1.0 : 0.0;
    }
    for (const double s : column_of(record, label, "solved")) solved += s;
    const auto crossings = column_of(record, label, "crossings");
    const auto sensitivity = column_of(record, label, "sensitivity");
    builder.row({std::string(pairs[p].words), solved, median(means[p]), median(column_of(record, label, "largest")),
                 best, median(column_of(record, label, "length")),
                 static_cast<double>(std::ranges::count_if(crossings, [](double c) { return c > 0.0; })),
                 median(sensitivity), largest(sensitivity),
                 median(column_of(record, robust_label(pairs[p]), "robust mean"))});
  }
  return builder.table();
}

store::TableRecord scale_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "scales", "The same at several scales",
      fmt::format("Median over {} random curves of mean E times mean chord, with the weights as printed and the mean "
                  "chord as given: the choice of the unit is a choice of the weights.",
                  scaled_curves));
  builder.words("weights").numbers("mean chord").numbers("mean E times mean chord");
  for (const Pair& pair : pairs)
    for (const double scale : scales)
      if (const auto values = column_of(record, random_label(pair), fmt::format("at {:g}", scale)); !values.empty())
        builder.row({std::string(pair.words), scale, median(values)});
  return builder.table();
}

store::TableRecord rank_table(const store::ExperimentRecord& record) {
  TableBuilder builder("ranks", "Does the order of the rows agree with Table 1?",
                       "Spearman's rank correlation of the eight mean energies with the printed ones: of the medians "
                       "over random curves, and the median of the single curves' correlations.");
  builder.numbers("mean chord").numbers("correlation of medians").numbers("median correlation");
  for (const double scale : scales) {
    const auto all = by_pair(record, fmt::format("at {:g}", scale));
    if (all.empty()) continue;
    std::vector<double> single;
    for (std::size_t i = 0; i < all.front().size(); ++i) {
      std::vector<double> row;
      for (const auto& values : all) row.push_back(values[i]);
      single.push_back(rank_correlation(row, printed_means()));
    }
    builder.row({scale, rank_correlation(medians_of(all), printed_means()), median(single)});
  }
  return builder.table();
}

/// Length without weights over that with (0.1, 0.1), curve by curve, at a cap.
std::vector<double> elongations(const store::ExperimentRecord& record, int cap) {
  const auto without = column_of(record, cap_label(pairs[unweighted], cap), "capped length");
  const auto with = column_of(record, cap_label(pairs[chosen], cap), "capped length");
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(without.size(), with.size()); ++i) ratios.push_back(without[i] / with[i]);
  return ratios;
}

store::TableRecord cap_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "caps", "How far stage 2 goes",
      fmt::format("Stage 2 as printed, without weights, from weights (0, 0) and (0.1, 0.1) in stage 1, "
                  "by the cap on its iterations; {} random walks, mean chord {:g}. Medians of mean E, "
                  "and length of the first over that of the second.",
                  capped_curves, usual_chord));
  builder.counts("cap").numbers("mean E, (0, 0)", "1/length").numbers("mean E, (0.1, 0.1)", "1/length");
  builder.numbers("length ratio, median").numbers("length ratio, largest");
  for (const int cap : caps)
    if (const auto ratios = elongations(record, cap); !ratios.empty())
      builder.row(
          {static_cast<double>(cap), median(column_of(record, cap_label(pairs[unweighted], cap), "capped mean")),
           median(column_of(record, cap_label(pairs[chosen], cap), "capped mean")), median(ratios), largest(ratios)});
  return builder.table();
}

store::ClaimRecord elongation_claim(const store::ExperimentRecord& record) {
  const auto lengths = by_pair(record, "length");
  Tally longer;
  std::vector<double> ratios;
  if (!lengths.empty())
    for (std::size_t i = 0; i < lengths[chosen].size(); ++i) {
      const double ratio = lengths[unweighted][i] / lengths[chosen][i];
      if (!std::isfinite(ratio)) continue;
      ratios.push_back(ratio);
      longer.add(ratio >= elongated);
    }
  const auto crossing = [&record](std::size_t pair) {
    const auto all = column_of(record, random_label(pairs[pair]), "crossings");
    return std::ranges::count_if(all, [](double c) { return c > 0.0; });
  };
  return claim(
      "no-weights-elongate", verdict_often(longer),
      fmt::format("at least a tenth longer than with (0.1, 0.1) on {}; median ratio {:.3g}, largest {:.3g}",
                  study::share(longer.agree, longer.cases), median(ratios), largest(ratios)),
      fmt::format("Random curves that both rows drew, of which {} are longer at all. Curves that cross themselves: {} "
                  "without weights, {} with (0.1, 0.1). With a cap of {} iterations in stage 2 the median ratio is "
                  "{:.3g}, the largest {:.3g}. The paper's cap is unknown.",
                  std::ranges::count_if(ratios, [](double r) { return r > 1.0; }), crossing(unweighted),
                  crossing(chosen), caps.back(), median(elongations(record, caps.back())),
                  largest(elongations(record, caps.back()))));
}

store::ClaimRecord best_claim(const store::ExperimentRecord& record) {
  const auto means = by_pair(record, "mean");
  Tally best;
  if (!means.empty())
    for (std::size_t i = 0; i < means[chosen].size(); ++i) {
      const auto lowest = [&](const auto& other) { return means[chosen][i] <= other[i]; };
      best.add(std::isfinite(means[chosen][i]) && std::ranges::all_of(means, lowest));
    }
  return claim("best-weights", study::verdict_in_general(best.agree, best.cases),
               fmt::format("lowest of the eight on {}", study::share(best.agree, best.cases)),
               fmt::format("Random open curves of {} points, mean chord {:g}; unsolved curves count as infinite.",
                           points, usual_chord));
}

store::ClaimRecord range_claim(const store::ExperimentRecord& record) {
  const auto means = by_pair(record, "mean");
  Tally lower;
  if (!means.empty())
    for (std::size_t i = 0; i < means.front().size(); ++i)
      for (const std::size_t in : favourable)
        for (const std::size_t out : others) lower.add(means[in][i] < means[out][i]);
  return claim("favourable-range", study::verdict_in_general(lower.agree, lower.cases),
               fmt::format("lower mean E inside the range than outside in {}", study::share(lower.agree, lower.cases)),
               "Every pair of a row inside the range and one outside it, on every random curve.");
}

store::ClaimRecord crossing_claim(const store::ExperimentRecord& record) {
  const auto crossings = by_pair(record, "crossings");
  double more = 0.0, fewer = 0.0, cases = 0.0;
  if (!crossings.empty())
    for (std::size_t i = 0; i < crossings[chosen].size(); ++i) {
      cases += 1.0;
      more += crossings[heavy_edges][i] > crossings[chosen][i] ? 1.0 : 0.0;
      fewer += crossings[heavy_edges][i] < crossings[chosen][i] ? 1.0 : 0.0;
    }
  return claim("large-edge-weight-crosses",
               !(cases > 0.0)  ? "not reproduced"
               : more > fewer  ? "reproduced"
               : more == fewer ? "not reproduced"
                               : "contradicted",
               fmt::format("more crossings than with (0.1, 0.1) on {:.0f} of {:.0f} curves, fewer on {:.0f}", more,
                           cases, fewer),
               "Crossings of random curves with themselves at weights (1, 0.1). The paper says that they may occur.");
}

store::ClaimRecord order_claim(const store::ExperimentRecord& record) {
  const auto means = by_pair(record, "mean");
  const double of_medians = means.empty() ? std::nan("") : rank_correlation(medians_of(means), printed_means());
  std::vector<double> ours, theirs;
  for (const Pair& pair : pairs)
    if (const auto* curve = shown_curve(record, pair)) {
      ours.push_back(measured(*curve, "parabola_energy_native_mean").value_or(no_energy));
      theirs.push_back(pair.mean);
    }
  return claim("table-1-order",
               !(of_medians < 2.0) ? "not reproduced"
               : of_medians >= 0.9 ? "reproduced"
               : of_medians <= 0.0 ? "contradicted"
                                   : "not reproduced",
               fmt::format("rank correlation {:.2f} for medians over random curves, {:.2f} for the stand-in",
                           of_medians, rank_correlation(ours, theirs)),
               fmt::format("{} random curves; reproduced from 0.9, contradicted from 0 down. The unit of the paper's "
                           "drawing, its tolerance and its cap are unknown, and so is how far stage 2 went.",
                           means.empty() ? 0 : means.front().size()));
}

store::ClaimRecord sensitivity_claim(const store::ExperimentRecord& record) {
  const auto sensitivity = by_pair(record, "sensitivity");
  std::string ours = "nothing measured";
  bool steady = false;
  if (!sensitivity.empty()) {
    const std::vector<double> medians = medians_of(sensitivity);
    ours = fmt::format("median change of mean E: {:.2g} at (0, 0), {:.2g} at (0.1, 0), {:.2g} at (0.1, 0.1)",
                       medians[0], medians[5], medians[chosen]);
    // Three digits are printed: a row's number means something if it does not change by half of the last one.
    steady = std::ranges::all_of(medians, [](double m) { return m < 5e-3; });
  }
  return claim("table-1-three-digits",
               sensitivity.empty() ? "not reproduced"
               : steady            ? "reproduced"
                                   : "contradicted",
               std::move(ours),
               fmt::format("Every point of {} random curves moved by {:g} mean chords, the same shift for all rows. "
                           "Reproduced if the median change is below half a unit of the third digit in every row.",
                           perturbed_curves, perturbation));
}

std::vector<store::FigureRecord> figures(const store::ExperimentRecord& record) {
  store::FigureRecord drawn{.id = "pkappa-weights",
                            .title = "Eight pairs of weights (λe, λc)",
                            .caption = "The same ten points; combs have one scale. Stand-in for Fig. 10.",
                            .columns = 4,
                            .panels = {}};
  for (const Pair& pair : pairs)
    if (const auto cell = study::drawn_cell(record, shown, pair.words))
      drawn.panels.push_back(curve_panel({*cell}, std::string(pair.words), true));
  store::PanelRecord energies{.kind = "graph", .title = "printed, and random curves"};
  energies.table = "bars";
  energies.x = "weights";
  energies.y = {"mean E"};
  energies.series = "of";
  energies.log_y = true;
  energies.x_label = "(λe, λc)";
  energies.y_label = "mean E";
  store::PanelRecord scale{.kind = "graph", .title = "agreement with the printed order"};
  scale.table = "ranks";
  scale.x = "mean chord";
  scale.y = {"correlation of medians", "median correlation"};
  scale.log_x = true;
  scale.x_label = "mean chord in units of the energies";
  scale.y_label = "rank correlation";
  store::FigureRecord numbers{.id = "pkappa-weights-random",
                              .title = "The weights on random curves",
                              .caption =
                                  "Left: mean E as printed, of the stand-in, and its median over random curves, "
                                  "as printed and by the default mode. Right: the rank correlation of our eight "
                                  "rows with the printed ones, by the unit of length.",
                              .columns = 2,
                              .panels = {energies, scale}};
  return {std::move(drawn), std::move(numbers)};
}

/// What the graph shows, long.
store::TableRecord bars_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "bars", "Mean E by pair of weights",
      "Printed; of the stand-in; medians over random curves (mode=paper, and the default mode in units "
      "of the mean chord).");
  builder.words("weights").words("of").numbers("mean E");
  for (const Pair& pair : pairs) builder.row({std::string(pair.words), std::string("printed"), pair.mean});
  for (const Pair& pair : pairs)
    if (const auto* curve = shown_curve(record, pair))
      builder.row({std::string(pair.words), std::string("stand-in"),
                   measured(*curve, "parabola_energy_native_mean").value_or(no_energy)});
  for (const Pair& pair : pairs)
    if (const auto all = column_of(record, random_label(pair), "mean"); !all.empty())
      builder.row({std::string(pair.words), std::string("random, as printed"), median(all)});
  for (const Pair& pair : pairs)
    if (const auto all = column_of(record, robust_label(pair), "robust mean"); !all.empty())
      builder.row({std::string(pair.words), std::string("random, default mode"), median(all)});
  return builder.table();
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {stand_in_table(record), random_table(record), scale_table(record),
                   rank_table(record),     cap_table(record),    bars_table(record)};
  record.claims = {elongation_claim(record), best_claim(record),  range_claim(record),
                   crossing_claim(record),   order_claim(record), sensitivity_claim(record)};
  if (!record.cells.empty()) record.figures = figures(record);
}

}  // namespace

Experiment pkappa_weights_experiment() {
  return {.id = "pkappa-weights",
          .title = "Weights of the energy (Wang 2024, Fig. 10 and Table 1)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
