#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "datasets/datasets.hpp"
#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/papers/fpc-2019-chen/inputs.hpp"
#include "experiments/study/summaries.hpp"
#include "metrics/locality.hpp"

namespace kappabench {

using namespace fpc;

namespace {

constexpr std::string_view about =
    "One point of a closed curve is moved in opposite directions, as in Fig. 10, and the three curves are drawn over "
    "one another. On the typed drawings and random typed inputs every point is moved by 5 % of the mean chord in eight "
    "directions; for every span between two points the largest deviation over the displacement is kept, by distance "
    "from the moved point.";

constexpr int version = 1;
constexpr std::string_view shown = "blob-12";
constexpr int moved_point = 6;  ///< the upper right corner of the drawing
constexpr double shown_move = 0.45, measured_move = 0.05;
constexpr int farthest = 6;
/// "Drops dramatically" is taken as: at least by half from each span to the next.
constexpr double dramatic = 0.5;
constexpr int inputs = 30, fewest_points = 7;

Drawing moved(Drawing drawing, double by) {
  Input& input = drawing.curves.front();
  const double chord = mean_chord(input);
  input.points[moved_point] += by * chord * Vec2(1.0, 1.0).normalized();
  return drawing;
}

void measure(const Scheme& scheme, const Input& input, store::CellRecord& cell) {
  const Fit fit = scheme.fit(input);
  if (!study::solved(fit) || input.size() < fewest_points) return;
  const LocalityProfile profile = locality_profile(scheme, fit, measured_move);
  study::put(cell, "moves", profile.fits, Method::sampled);
  study::put(cell, "failed", profile.failed, Method::sampled);
  if (const double decay = decay_per_span(profile); std::isfinite(decay))
    study::put(cell, "decay", decay, Method::sampled);
  for (int d = 1; d <= farthest && d <= static_cast<int>(profile.influence.size()); ++d)
    study::put(cell, fmt::format("influence {}", d), profile.influence[static_cast<std::size_t>(d) - 1],
               Method::sampled);
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const SchemePtr scheme = context.registry.create("fpc");
  const Drawing blob = open_drawings(shown).front();
  for (const auto& [by, words] :
       {std::pair(0.0, "as it is"), std::pair(shown_move, "moved outwards"), std::pair(-shown_move, "moved inwards")})
    jobs.push_back(study::drawn_job(moved(blob, by), scheme, words));
  std::vector<Drawing> drawings = gallery_or(context);
  drawings.push_back(blob);
  for (const Drawing& drawing : drawings)
    jobs.push_back(study::study_job(drawing, scheme, "locality", version,
                                    [scheme](const Drawing& points, store::CellRecord& cell) {
                                      for (const Input& input : points.curves) measure(*scheme, input, cell);
                                    }));
  const std::uint64_t seed = context.seed;
  jobs.push_back(random_job(scheme, fmt::format("locality, seed {}", seed), version, inputs,
                            [scheme, seed](std::uint64_t index, store::CellRecord& cell) {
                              measure(*scheme, typed_random_input(seed, index), cell);
                            }));
  return jobs;
}

std::vector<double> influence(const store::ExperimentRecord& record, int distance, std::string_view dataset = {}) {
  return study::values(record, fmt::format("influence {}", distance), dataset);
}

store::TableRecord table(const store::ExperimentRecord& record) {
  TableBuilder builder("influence", "Influence of a point by distance",
                       "Largest deviation of a span over the displacement (5 % of the mean chord), over all points and "
                       "eight directions (random inputs: the median over inputs); curves of at least seven points. The "
                       "spans beside the point are at distance 1.");
  builder.words("drawing").counts("distance").numbers("influence");
  for (const store::CellRecord& cell : record.cells)
    if (measured(cell, "influence 1"))
      for (int d = 1; d <= farthest; ++d)
        if (const auto values = influence(record, d, cell.dataset); !values.empty())
          builder.row({cell.dataset.starts_with("random") ? "random, median" : cell.dataset, static_cast<double>(d),
                       cell.dataset.starts_with("random") ? median(values) : largest(values)});
  return builder.table();
}

store::ClaimRecord decay_claim(const store::ExperimentRecord& record) {
  const std::vector<double> decays = study::values(record, "decay");
  const auto agree = static_cast<double>(std::ranges::count_if(decays, [](double v) { return v <= dramatic; }));
  const auto cases = static_cast<double>(decays.size());
  return claim(
      "local-influence", study::verdict_in_general(agree, cases),
      fmt::format("falls by half or more with each span on {} curves; median factor {:.2g}", study::share(agree, cases),
                  median(decays)),
      fmt::format("{:.0f} moves of single points of typed drawings and random typed inputs. Influence is the largest "
                  "over all points and directions; its median over curves is {:.2g} at distance 1, {:.2g} at 2, "
                  "{:.2g} at 3, {:.2g} at 4, its largest {:.3g}, where big loops magnify a displacement. {:.0f} "
                  "moved inputs were left out: not solved, or other nodes.",
                  study::total(record, "moves"), median(influence(record, 1)), median(influence(record, 2)),
                  median(influence(record, 3)), median(influence(record, 4)), largest(influence(record, 1)),
                  study::total(record, "failed")));
}

store::FigureRecord figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{.id = "fpc-locality",
                             .title = "Moving one point",
                             .caption =
                                 "Left: one point moved outwards and inwards, three curves. Right: influence by "
                                 "distance in spans.",
                             .columns = 2,
                             .panels = {}};
  store::PanelRecord panel{.kind = "curve", .title = "a point moved both ways", .cells = {}};
  panel.joints = false;
  for (std::size_t i = 0; i < record.cells.size(); ++i)
    if (!record.cells[i].curves.empty()) panel.cells.push_back(static_cast<int>(i));
  if (!panel.cells.empty()) figure.panels.push_back(std::move(panel));
  store::PanelRecord graph{.kind = "graph", .title = "influence"};
  graph.table = "influence";
  graph.x = "distance";
  graph.y = {"influence"};
  graph.series = "drawing";
  graph.log_y = true;
  graph.x_label = "distance in spans";
  graph.y_label = "deviation / displacement";
  figure.panels.push_back(std::move(graph));
  return figure;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {table(record)};
  record.figures = {figure(record)};
  record.claims = {decay_claim(record)};
}

}  // namespace

Experiment fpc_locality_experiment() {
  return {.id = "fpc-locality",
          .title = "Locality (Chen 2019, Fig. 10)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
