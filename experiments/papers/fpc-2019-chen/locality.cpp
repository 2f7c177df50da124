// Chen 2019, Fig. 10: how far does the influence of moving one point reach?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "datasets/datasets.hpp"
#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/papers/fpc-2019-chen/inputs.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "metrics/locality.hpp"

namespace kappabench {
namespace {

using namespace chen;
using study::count_of, study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Table;

constexpr std::string_view about =
    "One point of a closed curve is moved in opposite directions, as in Fig. 10, and the three curves are drawn over "
    "one another. On the typed drawings and random typed inputs every point is moved by 5 % of the mean chord in eight "
    "directions; for every span between two points the largest deviation over the displacement is kept, by distance "
    "from the moved point.";

// ---- what is measured

constexpr std::string_view shown = "blob-12";
constexpr int moved_point = 6;  // the upper right corner of the drawing
constexpr std::array<std::pair<double, std::string_view>, 3> shown_moves{
    {{0.0, "as it is"}, {0.45, "moved outwards"}, {-0.45, "moved inwards"}}};
constexpr double measured_move = 0.05;
constexpr int farthest = 6, inputs = 30, fewest_points = 7;

const Key distance{"distance"};
const Quantity influence{"influence", "1", Method::sampled}, decay{"decay", "1", Method::sampled};
const Quantity moves = count_of("moves"), failed = count_of("failed");

Drawing moved(Drawing drawing, double by) {
  Input& input = drawing.curves.front();
  const double chord = mean_chord(input);
  input.points[moved_point] += by * chord * Vec2(1.0, 1.0).normalized();
  return drawing;
}

void measure(const Uses& uses, const Input& input, Notes& notes) {
  const Scheme& scheme = *uses.schemes.front();
  const Fit fit = scheme.fit(input);
  if (!study::solved(fit) || input.size() < fewest_points) return;
  const LocalityProfile profile = locality_profile(scheme, fit, measured_move);
  notes.row({}, {moves(profile.fits), failed(profile.failed)});
  if (const double factor = decay_per_span(profile); std::isfinite(factor)) notes.put(decay(factor));
  for (int d = 1; d <= std::min<int>(farthest, static_cast<int>(profile.influence.size())); ++d)
    notes.row({distance(d)}, {influence(profile.influence[static_cast<std::size_t>(d) - 1])});
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
    jobs.push_back(study::curves_job<measure>(
        {.work = "locality", .schemes = {scheme}, .drawings = {drawing}, .metrics = {&find_metric("locality")}}));
  return jobs;
}

// ---- what follows

Table table(const Findings& found) {
  Table table("influence", "Influence of a point by distance",
              "Largest deviation of a span over the displacement (5 % of the mean chord), over all points and "
              "eight directions (random inputs: the median over inputs); curves of at least seven points. The "
              "spans beside the point are at distance 1.");
  table.words("drawing").counts("distance").numbers("influence");
  for (const auto& [dataset, rows] : found.rows().by(study::key::dataset))
    for (const auto& [d, spans] : rows.by(distance)) {
      const auto& drawing = std::get<std::string>(dataset);
      table.row({is_random(drawing) ? "random, median" : drawing, std::get<double>(d),
                 is_random(drawing) ? spans.median(influence) : spans.largest(influence)});
    }
  return table;
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{.id = "fpc-locality",
                             .title = "Moving one point",
                             .caption =
                                 "Left: one point moved outwards and inwards, three curves. Right: influence by "
                                 "distance in spans.",
                             .columns = 2};
  std::vector<int> cells;
  for (const auto& [by, words] : shown_moves)
    if (const auto cell = found.find(shown, words)) cells.push_back(*cell);
  if (!cells.empty()) figure.panels.push_back(Panel::curves(cells, "a point moved both ways").without_joints());
  figure.panels.push_back(Panel::graph("influence", "distance", {"influence"}, "influence")
                              .series("drawing")
                              .labels("distance in spans", "deviation / displacement")
                              .log_y());
  return figure;
}

void conclude(Findings& found) {
  found.add(table(found));
  found.add(figure(found));
  const study::Rows& rows = found.rows();
  const auto at = [&rows](int d) { return rows.where({distance(d)}); };
  // "Drops dramatically" is taken as: at least by half from each span to the next.
  const study::Tally falls = study::tally_of(rows.values(decay), [](double factor) { return factor <= 0.5; });
  found.claim(
      "local-influence", falls.in_general(),
      fmt::format("falls by half or more with each span on {} curves; median factor {:.2g}", falls.words(),
                  rows.median(decay)),
      fmt::format("{:.0f} moves of single points of typed drawings and random typed inputs. Influence is the largest "
                  "over all points and directions; its median over curves is {:.2g} at distance 1, {:.2g} at 2, "
                  "{:.2g} at 3, {:.2g} at 4, its largest {:.3g}, where big loops magnify a displacement. {:.0f} "
                  "moved inputs were left out: not solved, or other nodes.",
                  rows.total(moves), at(1).median(influence), at(2).median(influence), at(3).median(influence),
                  at(4).median(influence), at(1).largest(influence), rows.total(failed)));
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
