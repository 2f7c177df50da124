#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "datasets/datasets.hpp"
#include "datasets/random_source.hpp"
#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/study/summaries.hpp"
#include "metrics/self_intersection.hpp"

namespace kappabench {

using namespace fpc;

namespace {

constexpr std::string_view about =
    "Two loops, made in four ways. The C2 cubic spline, the kappa-curve and the FPC-curve of regular points pass six "
    "points that suggest them, and their loops close wherever they happen to. The FPC-curve of typed points is told "
    "where: three points between two ends are enough, two of them of type loop. How few points a kappa-curve needs for "
    "two loops is searched for among random points.";

constexpr int version = 1;
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> shown{
    {{"loops-regular", "cubic-spline"}, {"loops-regular", "fpc"}, {"loops-regular", "kappa"}, {"loops-typed", "fpc"}}};
constexpr std::array point_counts{3, 4, 5, 6};
constexpr int tries = 400;

/// The most self-crossings of a kappa-curve through n points in a square, open and closed, over many tries.
void search(const Scheme& kappa, int n, store::CellRecord& cell) {
  RandomSource random(static_cast<std::uint64_t>(n));
  for (const bool closed : {false, true}) {
    double most = 0.0;
    for (int i = 0; i < tries; ++i) {
      Input input{.points = {}, .closed = closed, .options = {}, .ids = {}};
      for (int k = 0; k < n; ++k) {
        const double x = random.uniform(0.0, 1.0), y = random.uniform(0.0, 1.0);
        input.points.emplace_back(x, y);
      }
      const Fit fit = kappa.fit(input);
      if (!study::solved(fit)) continue;
      study::put(cell, fmt::format("{} {} solved", closed ? "closed" : "open", n), 1.0);
      most = std::max(most, static_cast<double>(self_intersections(*fit.curve).found.size()));
    }
    study::put(cell, fmt::format("{} {} most loops", closed ? "closed" : "open", n), most);
  }
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  jobs.reserve(shown.size() + 1);
  for (const auto& [drawing, scheme] : shown)
    jobs.push_back(
        fit_job(open_drawings(drawing).front(), context.registry.create(scheme), {&find_metric("features")}));
  const SchemePtr kappa = context.registry.create("kappa");
  jobs.push_back(other_job("random points in a square", kappa, fmt::format("loops {}, {} tries", version, tries),
                           [kappa](store::CellRecord& cell) {
                             for (const int n : point_counts) search(*kappa, n, cell);
                           }));
  return jobs;
}

/// The cell of `shown[which]`.
Loops loops_of(const store::ExperimentRecord& record, std::size_t which) {
  return fpc::loops_of(record, shown[which].first, shown[which].second);
}

double most_loops(const store::ExperimentRecord& record, std::string_view kind, int n) {
  return largest(study::values(record, fmt::format("{} {} most loops", kind, n)));
}

/// The fewest points with which two loops were found; 0 if none.
int fewest(const store::ExperimentRecord& record, std::string_view kind) {
  for (const int n : point_counts)
    if (most_loops(record, kind, n) >= 2.0) return n;
  return 0;
}

store::TableRecord loops_table(const store::ExperimentRecord& record) {
  TableBuilder builder("loops", "Loops and where they close",
                       "Crossings of the curve with itself; at a point means within 1e-6 mean chord of one.");
  builder.words("drawing").words("scheme").counts("points").counts("loops").counts("at points");
  for (std::size_t k = 0; k < shown.size(); ++k)
    if (const Loops loops = loops_of(record, k); loops.cell >= 0)
      builder.row(
          {std::string(shown[k].first), std::string(shown[k].second), loops.points, loops.loops, loops.at_points});
  return builder.table();
}

store::TableRecord search_table(const store::ExperimentRecord& record) {
  TableBuilder builder("search", "Most loops of a κ-curve",
                       fmt::format("Over {} sets of random points in a square, each open and closed.", tries));
  builder.counts("points").counts("open, solved").counts("open, most loops");
  builder.counts("closed, solved").counts("closed, most loops");
  for (const int n : point_counts) {
    const auto solved = [&](std::string_view kind) {
      return study::total(record, fmt::format("{} {} solved", kind, n));
    };
    builder.row({static_cast<double>(n), solved("open"), most_loops(record, "open", n), solved("closed"),
                 most_loops(record, "closed", n)});
  }
  return builder.table();
}

store::ClaimRecord typed_claim(const store::ExperimentRecord& record) {
  const Loops typed = loops_of(record, 3);
  const bool holds = typed.loops == 2.0 && typed.at_points == 2.0 && typed.points <= 5.0;
  return claim(
      "three-points-two-loops",
      typed.cell < 0 ? "not reproduced"
      : holds        ? "reproduced"
                     : "contradicted",
      fmt::format("{:.0f} points with both ends: {:.0f} loops, {:.0f} of them at a point", typed.points, typed.loops,
                  typed.at_points),
      "The drawing loops-typed; loops are crossings of the exact curve, at a point if within 1e-6 mean chord.");
}

store::ClaimRecord spline_claim(const store::ExperimentRecord& record) {
  const Loops spline = loops_of(record, 0);
  const bool away = spline.loops - spline.at_points > 0.0;
  return claim("spline-loops-away",
               spline.cell < 0 || spline.loops == 0.0 ? "not reproduced"
               : away                                 ? "reproduced"
                                                      : "contradicted",
               fmt::format("{:.0f} loops, {:.0f} of them at a point", spline.loops, spline.at_points),
               "The natural C2 cubic spline with chord-length parameters through the six points of loops-regular.");
}

store::ClaimRecord kappa_claim(const store::ExperimentRecord& record) {
  const int open = fewest(record, "open"), closed = fewest(record, "closed");
  const int all = open == 0 ? closed : closed == 0 ? open : std::min(open, closed);
  double tried = 0.0;
  for (const int n : point_counts)
    for (const std::string_view kind : {"open", "closed"})
      tried += study::total(record, fmt::format("{} {} solved", kind, n));
  return claim("kappa-needs-five",
               tried == 0.0 || all == 0 ? "not reproduced"
               : all < 5                ? "contradicted"
                                        : "reproduced",
               fmt::format("two loops from {} points open and {} closed", open == 0 ? "more" : std::to_string(open),
                           closed == 0 ? "more" : std::to_string(closed)),
               fmt::format("Solved κ-curves through 3 to 6 random points in a square, {:.0f} in all; the ends of an "
                           "open curve are counted as points.",
                           tried));
}

store::FigureRecord figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{.id = "fpc-loops",
                             .title = "Two loops in four ways",
                             .caption =
                                 "Six points that suggest two loops, by the C2 cubic spline, by the FPC-curve of "
                                 "regular points and by the κ-curve; three points between two ends, two of "
                                 "them of type loop, by the FPC-curve.",
                             .columns = 4,
                             .panels = {}};
  constexpr std::array<std::string_view, 4> titles{"C2 cubic spline", "FPC, regular points", "κ-curve",
                                                   "FPC, two points typed"};
  for (std::size_t k = 0; k < shown.size(); ++k)
    if (const Loops loops = loops_of(record, k); loops.cell >= 0)
      figure.panels.push_back(curve_panel(loops.cell, std::string(titles[k])));
  return figure;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {loops_table(record), search_table(record)};
  if (auto drawn = figure(record); !drawn.panels.empty()) record.figures = {std::move(drawn)};
  record.claims = {typed_claim(record), spline_claim(record), kappa_claim(record)};
}

}  // namespace

Experiment fpc_loops_experiment() {
  return {.id = "fpc-loops",
          .title = "Modelling two loops (Chen 2019, Fig. 2)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
