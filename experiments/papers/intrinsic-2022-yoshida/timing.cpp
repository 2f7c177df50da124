// Yoshida 2022, Table 1: how long a solution takes, by the published method and by ours.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/inputs.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/timing.hpp"
#include "schemes/intrinsic/fixed_knots.hpp"
#include "schemes/intrinsic/sampling.hpp"
#include "schemes/intrinsic/simplex.hpp"

namespace kappabench {
namespace {

using namespace yoshida;
using namespace intrinsic;
using kappabench::Method;
using study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Rows, study::Table;

constexpr std::string_view about =
    "500 random G1 conditions with the paper's angles, p = 0, equal knots, 500 points of every curve. The published "
    "method is downhill simplex on the distance of the end, stopped at 1e-12 chords; it and Newton's method read the "
    "same tables, which depend on the knots alone and are set up once. Points are evaluated in one pass of the "
    "trapezium rule with its first correction, with sines and cosines of the C library or of xsimd. All works are "
    "timed in one process, samples in random order, by Google Benchmark in processor time, so that load hits all of "
    "them alike: only ratios compare "
    "across machines. The paper's times are from a Ryzen 9 3950X and GSL, with a tolerance that it does not name. "
    "Asked of this program are 40 times the simplex for the solution alone, 4 times with the same evaluation and 10 "
    "times with the vectorised one, at residuals of 1e-13.";

// ---- what is measured

constexpr long conditions = 500;  ///< unless the plan says otherwise
constexpr int points = 500;
constexpr double asked_residual = 1e-13;
/// Table 1.
struct Row {
  int degree, controls;
  double milliseconds, deviation;
};
constexpr std::array<Row, 5> printed{
    {{1, 2, 0.27, 0.008}, {2, 3, 0.32, 0.009}, {3, 4, 0.37, 0.103}, {3, 6, 0.49, 0.108}, {3, 8, 0.60, 0.118}}};

constexpr std::string_view simplex = "simplex", newton = "Newton", simplex_points = "simplex and points",
                           newton_points = "Newton and points", newton_fast_points = "Newton and points, vectorised",
                           set_up = "tables", each_condition = "each condition";

/// How often the published way takes, and which of ours is compared with it.
struct Aim {
  std::string_view ours, theirs, words;
  double ratio;
};
constexpr std::array<Aim, 3> aims{{{newton, simplex, "solution alone", 40.0},
                                   {newton_points, simplex_points, "with the same evaluation", 4.0},
                                   {newton_fast_points, simplex_points, "with vectorised evaluation", 10.0}}};

/// Rows are of one condition, solved for one row of Table 1.
const Key family{"family"}, solver{"solver"};
const Quantity residual{"residual", "1", Method::sampled};
const Quantity converged = study::count_of("converged"), steps = study::count_of("steps");

/// What depends on the knots alone.
struct Tools {
  FixedKnots knots;
  Sampler sampler;

  [[nodiscard]] Vec2 last_point(const Solved& solved, const StandardData& data, Sines sines) const {
    return sampler.points(knots.curve(solved), data.chord_angle, sines).back();
  }
};

Tools tools_of(const Row& row) {
  const BSplineBasis basis = uniform_basis(row.degree, row.controls);
  return {FixedKnots(basis, interpolated(basis, 0, row.controls - 1, 0.0)), Sampler(basis, points)};
}

/// What a work leaves behind, so that nothing of it is optimised away.
struct Sink {
  double sum = 0.0;
};

std::string name_of(const Row& row) { return fmt::format("degree {}, {} controls", row.degree, row.controls); }
std::string key_of(const Row& row, std::string_view work) { return fmt::format("{}: {}", name_of(row), work); }

using Solve = std::function<Solved(const FixedKnots&, const StandardData&)>;
Solved by_newton(const FixedKnots& knots, const StandardData& data) { return knots.solve(data); }
Solved by_simplex(const FixedKnots& knots, const StandardData& data) { return solve_by_simplex(knots, data); }

/// All conditions of a row solved, and evaluated with `sines` if there are any.
std::function<void()> work_of(const Tools& tools, const std::vector<StandardData>& data, Solve solve_one,
                              std::optional<Sines> sines, Sink& sink) {
  return [&tools, &data, solve_one = std::move(solve_one), sines, &sink] {
    for (const StandardData& d : data) {
      const Solved solved = solve_one(tools.knots, d);
      sink.sum += sines ? tools.last_point(solved, d, *sines).x() : solved.x;
    }
  };
}

void measure_residuals(const Row& row, const FixedKnots& knots, const std::vector<StandardData>& data, Notes& notes) {
  for (const auto& [words, solve_one] : {std::pair(newton, &by_newton), std::pair(simplex, &by_simplex)})
    for (const StandardData& d : data) {
      const Solved solved = solve_one(knots, d);
      notes.row({family(name_of(row)), solver(words)},
                {residual(gap(knots.curve(solved), d)), converged(solved.converged ? 1 : 0), steps(solved.iterations)});
    }
}

/// The paper's standard deviation is over the conditions.
std::vector<double> seconds_of_each(const Tools& tools, const std::vector<StandardData>& data, Sink& sink) {
  constexpr int repetitions = 3;
  std::vector<double> each;
  for (const StandardData& d : data) {
    const double start = processor_seconds();
    for (int i = 0; i < repetitions; ++i)
      sink.sum += tools.last_point(by_simplex(tools.knots, d), d, Sines::library).x();
    each.push_back((processor_seconds() - start) / repetitions);
  }
  return each;
}

void time_table_1(const Uses& uses, Notes& notes) {
  std::vector<StandardData> data;
  const auto n = static_cast<std::uint64_t>(uses.numbers.at("conditions"));
  for (std::uint64_t i = 0; i < n; ++i) data.push_back(random_angles(Angles::ordinary, uses.seed, i));
  std::vector<Tools> tools;
  tools.reserve(printed.size());
  for (const Row& row : printed) tools.push_back(tools_of(row));
  Sink sink;
  std::vector<TimedWork> works;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const Row& row = printed[i];
    works.push_back({key_of(row, simplex), work_of(tools[i], data, by_simplex, {}, sink)});
    works.push_back({key_of(row, newton), work_of(tools[i], data, by_newton, {}, sink)});
    works.push_back({key_of(row, simplex_points), work_of(tools[i], data, by_simplex, Sines::library, sink)});
    works.push_back({key_of(row, newton_points), work_of(tools[i], data, by_newton, Sines::library, sink)});
    works.push_back({key_of(row, newton_fast_points), work_of(tools[i], data, by_newton, Sines::vectorised, sink)});
    works.push_back({key_of(row, set_up), [&row, &sink] { sink.sum += tools_of(row).knots.table().first_total; }});
  }
  auto& timings = notes.cell().timings;
  timings = time_all(works, {.repetitions = 7, .least_seconds = 0.01});
  for (std::size_t i = 0; i < printed.size(); ++i) {
    measure_residuals(printed[i], tools[i].knots, data, notes);
    timings[key_of(printed[i], each_condition)] = seconds_of_each(tools[i], data, sink);
  }
}

std::vector<CellJob> jobs(const Context& context) {
  const long n = amounts(context, "intrinsic-timing", {{"random-g1", conditions}}).front();
  return {study::numbers_job<time_table_1>({.work = "Table 1",
                                            .schemes = {context.registry.create("intrinsic")},
                                            .seed = context.seed,
                                            .numbers = {{"conditions", static_cast<double>(n)}}},
                                           "random G1 conditions", "simplex and Newton")};
}

// ---- what follows

std::vector<double> samples(const Findings& found, const Row& row, std::string_view work) {
  for (const store::CellRecord& cell : found.cells())
    if (const auto timed = cell.timings.find(key_of(row, work)); timed != cell.timings.end()) return timed->second;
  return {};
}

/// The rows of Table 1 that were timed.
std::vector<Row> timed_rows(const Findings& found) {
  std::vector<Row> rows;
  for (const Row& row : printed)
    if (!samples(found, row, simplex).empty()) rows.push_back(row);
  return rows;
}

Rows rows_of(const Findings& found, const Row& row, std::string_view words) {
  return found.rows().where({family(name_of(row)), solver(words)});
}

/// Milliseconds a condition.
double milliseconds(const Findings& found, const Row& row, std::string_view work) {
  return 1e3 * median(samples(found, row, work)) / static_cast<double>(samples(found, row, each_condition).size());
}
double ratio(const Findings& found, const Row& row, const Aim& aim) {
  return milliseconds(found, row, aim.theirs) / milliseconds(found, row, aim.ours);
}

double deviation(const std::vector<double>& values) {
  const double middle = mean(values);
  double sum = 0.0;
  for (const double v : values) sum += (v - middle) * (v - middle);
  return values.size() < 2 ? std::nan("") : std::sqrt(sum / static_cast<double>(values.size() - 1));
}

Table time_table(const Findings& found) {
  Table table("times-seconds", "Table 1 beside ours",
              "Milliseconds a condition, medians of samples; standard deviation over the conditions, of the "
              "simplex with points. Tables: what depends on the knots alone, once for all conditions.");
  table.counts("degree").counts("controls").numbers("printed", "ms").numbers("printed deviation", "ms");
  for (const std::string_view work : {simplex_points, newton_points, newton_fast_points, simplex, newton})
    table.numbers(std::string(work), "ms");
  table.numbers("deviation", "ms").numbers("tables", "ms");
  for (const Row& row : timed_rows(found)) {
    std::vector<study::TableValue> cells{row.degree, row.controls, row.milliseconds, row.deviation};
    for (const std::string_view work : {simplex_points, newton_points, newton_fast_points, simplex, newton})
      cells.emplace_back(milliseconds(found, row, work));
    cells.emplace_back(1e3 * deviation(samples(found, row, each_condition)));
    cells.emplace_back(1e3 * median(samples(found, row, set_up)));
    table.row(cells);
  }
  return table;
}

Table ratio_table(const Findings& found) {
  Table table("ratios-seconds", "How many times the simplex takes",
              fmt::format("Medians in one process. Asked: 40 for the solution alone, 4 with the same evaluation, "
                          "10 with the vectorised one, all at residuals of at most {:g}.",
                          asked_residual));
  table.counts("degree").counts("controls").words("compared").numbers("ratio").numbers("asked").words("met");
  for (const Row& row : timed_rows(found)) {
    const bool solved = rows_of(found, row, newton).largest(residual) <= asked_residual;
    for (const Aim& aim : aims) {
      const double times = ratio(found, row, aim);
      table.row({row.degree, row.controls, aim.words, times, aim.ratio, times >= aim.ratio && solved ? "yes" : "no"});
    }
  }
  return table;
}

Table residual_table(const Findings& found) {
  Table table("residuals", "How well the conditions are met",
              "Distance of the end in chords plus difference of the angle in radians; steps of Newton's method, "
              "evaluations of the simplex.");
  table.counts("degree").counts("controls").words("solver").counts("conditions").counts("converged");
  table.numbers("largest residual").numbers("median residual").numbers("mean steps");
  for (const Row& row : timed_rows(found))
    for (const std::string_view words : {newton, simplex})
      if (const Rows rows = rows_of(found, row, words); !rows.empty())
        table.row({row.degree, row.controls, words, rows.size(), rows.total(converged), rows.largest(residual),
                   rows.median(residual), rows.mean(steps)});
  return table;
}

void claim_interactive(Findings& found) {
  std::vector<double> all;
  for (const Row& row : timed_rows(found))
    for (const double seconds : samples(found, row, each_condition)) all.push_back(1e3 * seconds);
  const double fastest = all.empty() ? undefined : *std::ranges::min_element(all), slowest = largest(all);
  found.judge(
      "interactive", study::Interval{fastest, slowest},
      {fmt::format("at most {:.3g} ms for any condition by the published method", slowest),
       fmt::format("Solved by simplex and evaluated at {} points, {} conditions in all rows of Table 1, on this "
                   "machine. The bound, a frame, is 28 times the longest printed time.",
                   points, all.size())});
}

/// Controls and degrees cost what the quadrature makes of them, and the paper does not name the one of GSL that it
/// used.
void claim_growth(Findings& found) {
  std::vector<std::string> words;
  for (const Row& row : timed_rows(found))
    words.push_back(fmt::format("{:.3g}", milliseconds(found, row, simplex_points)));
  found.undecidable(
      "time-grows",
      {words.empty() ? "nothing timed" : fmt::format("{} ms", fmt::join(words, ", ")),
       "Simplex and points, medians, rows in the order of Table 1. The quadrature decides, which is not "
       "printed: ours has as many nodes for every degree, so that the first three rows, of one knot span, "
       "cost the same, and more for more spans."});
}

store::FigureRecord figure() {
  std::vector<std::string> works{"printed"};
  for (const std::string_view work : {simplex_points, newton_points, newton_fast_points, simplex, newton})
    works.emplace_back(work);
  return {.id = "intrinsic-timing",
          .title = "Time to solve and to evaluate 500 points",
          .caption = "Table 1 as printed (another machine) and medians here.",
          .columns = 1,
          .panels = {Panel::graph("times-seconds", "controls", works, "time a condition")
                         .labels("control curvatures", "ms")
                         .log_y()}};
}

void conclude(Findings& found) {
  found.add(time_table(found));
  found.add(ratio_table(found));
  found.add(residual_table(found));
  claim_interactive(found);
  claim_growth(found);
  if (!found.cells().empty()) found.add(figure());
}

}  // namespace

Experiment intrinsic_timing_experiment() {
  return study::experiment({.id = "intrinsic-timing",
                            .title = "Computation time (Yoshida 2022, Table 1)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"interactive", "time-grows"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
