// Chen 2019, Fig. 10: how far does the influence of moving one point reach?
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>

#include "datasets/datasets.hpp"
#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/papers/fpc-2019-chen/inputs.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "metrics/correspondence.hpp"
#include "metrics/locality.hpp"

namespace kappabench {
namespace {

using namespace chen;
using study::count_of, study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Table;

constexpr std::string_view about =
    "One point of a closed curve is moved in opposite directions, as in Fig. 10, and the three curves are drawn over "
    "one another. On the typed drawings and random typed inputs every point is moved by 5 % of the mean chord in eight "
    "directions; the influence of a move is the largest deviation of a span between two points over the displacement, "
    "by distance from the moved point. The statement is about drawings and judged on these, by medians over the moves: "
    "big loops magnify single moves beyond measure.";

// ---- what is measured

constexpr std::string_view shown = "blob-12";
constexpr int moved_point = 6;  // the upper right corner of the drawing
constexpr std::array<std::pair<double, std::string_view>, 3> shown_moves{
    {{0.0, "as it is"}, {0.45, "moved outwards"}, {-0.45, "moved inwards"}}};
constexpr double measured_move = 0.05;
constexpr int farthest = 6, inputs = 30, fewest_points = 7, directions = 8;

const Key distance{"distance"};
const Quantity influence{"influence", "1", Method::sampled};
/// Of the median influence of a curve's moves, from one distance to the next.
const Quantity decay{"decay", "1", Method::sampled};
const Quantity moves = count_of("moves"), failed = count_of("failed");

Drawing moved(Drawing drawing, double by) {
  Input& input = drawing.curves.front();
  const double chord = mean_chord(input);
  input.points[moved_point] += by * chord * Vec2(1.0, 1.0).normalized();
  return drawing;
}

/// In points along the curve; the spans beside a point are at 1.
int distance_of(const Span& span, int point, const Input& input) {
  const auto apart = [&](int other) {
    const int between = std::abs(other - point);
    return input.closed ? std::min(between, input.size() - between) : between;
  };
  return 1 + std::min(apart(span.from), apart(span.to));
}

/// The influence of a move by distance, from 1, NaN where there is no span; nothing if the nodes are others.
using Influence = std::array<double, farthest>;
std::optional<Influence> influence_of(const Scheme& scheme, Input input, const std::vector<Span>& before, int point,
                                      const Vec2& by) {
  input.points[static_cast<std::size_t>(point)] += by;
  const Fit other = scheme.fit(input);
  if (!study::solved(other)) return std::nullopt;
  const auto deviations = span_deviations(before, spans(*other.curve), input.closed);
  if (!deviations) return std::nullopt;
  Influence found;
  found.fill(undefined);
  for (std::size_t k = 0; k < before.size(); ++k)
    if (const int d = distance_of(before[k], point, input); d <= farthest) {
      double& largest = found[static_cast<std::size_t>(d) - 1];
      if (!((*deviations)[k] / by.norm() <= largest)) largest = (*deviations)[k] / by.norm();
    }
  return found;
}

void measure(const Uses& uses, const Input& input, Notes& notes) {
  const Scheme& scheme = *uses.schemes.front();
  const Fit fit = scheme.fit(input);
  if (input.size() < fewest_points) return;
  if (!study::solved(fit)) {
    notes.put(decay(1.0));  // no influence is known: as if it did not fall
    return;
  }
  const std::vector<Span> before = spans(*fit.curve);
  const double step = measured_move * mean_chord(input);
  LocalityProfile medians{.displacement = measured_move, .influence = {}};
  std::array<std::vector<double>, farthest> of_moves;
  for (int point = 0; point < input.size(); ++point)
    for (int k = 0; k < directions; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / directions;
      const auto found = influence_of(scheme, input, before, point, step * Vec2(std::cos(angle), std::sin(angle)));
      ++medians.fits;
      medians.failed += found ? 0 : 1;
      for (std::size_t d = 0; found && d < farthest; ++d)
        if (!std::isnan((*found)[d])) {
          of_moves[d].push_back((*found)[d]);
          notes.row({distance(d + 1)}, {influence((*found)[d])});
        }
    }
  for (const std::vector<double>& here : of_moves) medians.influence.push_back(median(here));
  notes.row({}, {moves(medians.fits), failed(medians.failed)});
  if (const double factor = decay_per_span(medians); std::isfinite(factor)) notes.put(decay(factor));
}

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr scheme = context.registry.create("fpc");
  const Drawing blob = open_drawings(shown).front();
  std::vector<CellJob> jobs;
  jobs.reserve(shown_moves.size());
  for (const auto& [by, words] : shown_moves) jobs.push_back(fit_job(moved(blob, by), scheme, {}, std::string(words)));
  std::vector<Drawing> drawings = gallery_or(context);
  drawings.push_back(blob);
  drawings.push_back(typed_random_inputs("locality", context.seed, inputs));
  for (const Drawing& drawing : drawings)
    jobs.push_back(study::curves_job<measure>({.work = "locality",
                                               .version = 2,
                                               .schemes = {scheme},
                                               .drawings = {drawing},
                                               .metrics = {&find_metric("locality")}}));
  return jobs;
}

// ---- what follows

Table table(const Findings& found) {
  Table table(
      "influence", "Influence of a point by distance",
      "Largest deviation of a span over the displacement, 5 % of the mean chord: median over all points and eight "
      "directions, what nine in ten moves stay below, and the largest; curves of at least seven points. The "
      "spans beside the point are at distance 1.");
  table.words("drawing").counts("distance").numbers("median").numbers("nine in ten").numbers("largest");
  for (const auto& [dataset, rows] : found.rows().by(study::key::dataset))
    for (const auto& [d, of_moves] : rows.by(distance)) {
      const auto& drawing = std::get<std::string>(dataset);
      table.row({is_random(drawing) ? "random" : drawing, std::get<double>(d), of_moves.median(influence),
                 quantile(of_moves.values(influence), 0.9), of_moves.largest(influence)});
    }
  return table;
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{.id = "fpc-locality",
                             .title = "Moving one point",
                             .caption =
                                 "Left: one point moved outwards and inwards, three curves. Right: median influence "
                                 "by distance in spans.",
                             .columns = 2};
  std::vector<int> cells;
  for (const auto& [by, words] : shown_moves)
    if (const auto cell = found.find(shown, words)) cells.push_back(*cell);
  if (!cells.empty()) figure.panels.push_back(Panel::curves(cells, "a point moved both ways").without_joints());
  figure.panels.push_back(Panel::graph("influence", "distance", {"median"}, "median influence")
                              .series("drawing")
                              .labels("distance in spans", "deviation / displacement")
                              .log_y());
  return figure;
}

void claim_local(Findings& found) {
  const auto of = [&found](bool random) {
    return found.rows().where_row([random](const study::Row& row) {
      return is_random(std::get<std::string>(row[study::key::dataset])) == random;
    });
  };
  const study::Rows drawings = of(false), stress = of(true);
  std::vector<std::string> by_distance;
  for (const auto& [d, of_moves] : drawings.by(distance))
    by_distance.push_back(
        fmt::format("{:.2g} ({:.2g})", of_moves.median(influence), quantile(of_moves.values(influence), 0.9)));
  const std::vector<double> factors = drawings.values(decay);
  found.judge(
      "local-influence", study::interval_of_median(factors),
      {fmt::format("the median influence falls to {:.2g} of itself with each span, median of {} curves",
                   median(factors), factors.size()),
       fmt::format(
           "{:.0f} moves of single points of typed drawings. Influence at distances from 1 on, the median (what "
           "nine in ten stay below): {}; the largest at 1 is {:.3g}, where big loops magnify a displacement. "
           "Random typed inputs: falls to {:.2g}. {:.0f} of {:.0f} moved inputs could not be compared: not "
           "solved, or other nodes.",
           drawings.total(moves), fmt::join(by_distance, ", "), drawings.where({distance(1)}).largest(influence),
           stress.median(decay), found.rows().total(failed), found.rows().total(moves))});
}

void conclude(Findings& found) {
  found.add(table(found));
  found.add(figure(found));
  claim_local(found);
}

}  // namespace

Experiment fpc_locality_experiment() {
  return study::experiment({.id = "fpc-locality",
                            .title = "Locality (Chen 2019, Fig. 10)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"local-influence"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
