// Chen 2019, Fig. 2: two loops, made in four ways; how few points a kappa-curve needs for them.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "datasets/random_source.hpp"
#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "metrics/self_intersection.hpp"

namespace kappabench {
namespace {

using namespace chen;
using study::count_of, study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Table;

constexpr std::string_view about =
    "Two loops, made in four ways. The C2 cubic spline, the kappa-curve and the FPC-curve of regular points pass six "
    "points that suggest them, and their loops close wherever they happen to. The FPC-curve of typed points is told "
    "where: three points between two ends are enough, two of them of type loop. How few points a kappa-curve needs for "
    "two loops is searched for among random points.";

// ---- what is measured

constexpr LoopCase spline{"loops-regular", "cubic-spline", "C2 cubic spline"};
constexpr LoopCase regular{"loops-regular", "fpc", "FPC, regular points"};
constexpr LoopCase kappa_curve{"loops-regular", "kappa", "κ-curve"};
constexpr LoopCase typed{"loops-typed", "fpc", "FPC, two points typed"};
constexpr std::array shown{spline, regular, kappa_curve, typed};

constexpr std::array point_counts{3, 4, 5, 6};
constexpr int tries = 400;
const Key ends{"ends"}, points{"points"};
const Quantity tried = count_of("tried"), solved = count_of("solved");
const Quantity most_loops{"most loops", "1", Method::sampled}, two_loops{"with two loops", "1", Method::sampled};

Input points_in_a_square(RandomSource& random, int n, bool closed) {
  Input input{.closed = closed};
  for (int k = 0; k < n; ++k) {
    const double x = random.uniform(0.0, 1.0), y = random.uniform(0.0, 1.0);
    input.points.emplace_back(x, y);
  }
  return input;
}

/// The most self-crossings of a kappa-curve through n points in a square, open and closed, over many tries.
void search(const Uses& uses, Notes& notes) {
  for (const int n : point_counts) {
    RandomSource random(static_cast<std::uint64_t>(n));
    for (const bool closed : {false, true}) {
      std::size_t count = 0, most = 0, with_two = 0;
      for (int i = 0; i < tries; ++i) {
        const Fit fit = uses.schemes.front()->fit(points_in_a_square(random, n, closed));
        if (!study::solved(fit)) continue;
        ++count;
        const std::size_t loops = self_intersections(*fit.curve).found.size();
        most = std::max(most, loops);
        with_two += loops >= 2 ? 1U : 0U;
      }
      notes.row({ends(closed ? "closed" : "open"), points(n)},
                {tried(tries), solved(count), most_loops(most), two_loops(with_two)});
    }
  }
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  jobs.reserve(shown.size() + 1);
  for (const LoopCase& which : shown) jobs.push_back(loops_job(context, which));
  jobs.push_back(study::numbers_job<search>({.work = "loops of random points",
                                             .version = 2,
                                             .schemes = {context.registry.create("kappa")},
                                             .metrics = {&find_metric("features")},
                                             .numbers = {{"tries", tries}}},
                                            "random points in a square"));
  return jobs;
}

// ---- what follows

/// The fewest points with which two loops were found; 0 if none.
int fewest(const Findings& found, std::string_view kind) {
  const auto* const n = std::ranges::find_if(point_counts, [&](int count) {
    return found.rows().where({ends(kind), points(count)}).largest(most_loops) >= 2.0;
  });
  return n == point_counts.end() ? 0 : *n;
}

Table loops_table(const Findings& found) {
  Table table("loops", "Loops and where they close",
              "Crossings of the curve with itself; at a point means within 1e-6 mean chord of one.");
  table.words("drawing").words("scheme").counts("points").counts("loops").counts("at points");
  for (const LoopCase& which : shown)
    if (const Loops loops = loops_of(found, which); loops.drawn())
      table.row({which.drawing, which.scheme, loops.points, loops.loops, loops.at_points});
  return table;
}

Table search_table(const Findings& found) {
  Table table("search", "Most loops of a κ-curve",
              fmt::format("Over {} sets of random points in a square, each open and closed.", tries));
  table.counts("points").counts("open, solved").counts("open, most loops");
  table.counts("closed, solved").counts("closed, most loops");
  for (const int n : point_counts) {
    const study::Rows open = found.rows().where({ends("open"), points(n)});
    const study::Rows closed = found.rows().where({ends("closed"), points(n)});
    table.row({n, open.total(solved), open.largest(most_loops), closed.total(solved), closed.largest(most_loops)});
  }
  return table;
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{.id = "fpc-loops",
                             .title = "Two loops in four ways",
                             .caption =
                                 "Six points that suggest two loops, by the C2 cubic spline, by the FPC-curve of "
                                 "regular points and by the κ-curve; three points between two ends, two of "
                                 "them of type loop, by the FPC-curve.",
                             .columns = 4};
  for (const LoopCase& which : shown)
    if (const Loops loops = loops_of(found, which); loops.drawn())
      figure.panels.push_back(Panel::curves({loops.cell}, std::string(which.title)));
  return figure;
}

void claim_typed(Findings& found) {
  const Loops loops = loops_of(found, typed);
  found.judge(
      "three-points-two-loops",
      study::one_case(loops.drawn(), loops.loops == 2.0 && loops.at_points == 2.0 && loops.points <= 5.0),
      {fmt::format("{:.0f} points with both ends: {:.0f} loops, {:.0f} of them at a point", loops.points, loops.loops,
                   loops.at_points),
       "The drawing loops-typed; loops are crossings of the exact curve, at a point if within 1e-6 mean chord."});
}

void claim_spline(Findings& found) {
  const Loops loops = loops_of(found, spline);
  found.judge("spline-loops-away", study::one_case(loops.drawn(), loops.loops > loops.at_points),
              {fmt::format("{:.0f} loops, {:.0f} of them at a point", loops.loops, loops.at_points),
               "The natural C2 cubic spline with chord-length parameters through the six points of loops-regular."});
}

void claim_kappa(Findings& found) {
  const study::Rows fewer = found.rows().where_row(
      [](const study::Row& row) { return row.has(two_loops) && std::get<double>(row[points]) < 5.0; });
  const study::Tally without{fewer.total(solved) - fewer.total(two_loops), fewer.total(tried)};
  const auto words = [](int n) { return n == 0 ? "more" : std::to_string(n); };
  found.judge(
      "kappa-needs-five", without,
      {fmt::format("{} κ-curves through fewer than five points have fewer than two loops", without.words()),
       fmt::format("Random points in a square, the ends of an open curve counted as points. Two loops are found "
                   "from {} points open and {} closed on, among {} tries each.",
                   words(fewest(found, "open")), words(fewest(found, "closed")), tries)});
}

void conclude(Findings& found) {
  found.add(loops_table(found));
  found.add(search_table(found));
  found.add(figure(found));
  claim_typed(found);
  claim_spline(found);
  claim_kappa(found);
}

}  // namespace

Experiment fpc_loops_experiment() {
  return study::experiment({.id = "fpc-loops",
                            .title = "Modelling two loops (Chen 2019, Fig. 2)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"three-points-two-loops", "spline-loops-away", "kappa-needs-five"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
