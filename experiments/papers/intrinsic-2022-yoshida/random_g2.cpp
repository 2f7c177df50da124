#include "experiments/papers/intrinsic-2022-yoshida/random_g2.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <ranges>
#include <string>
#include <variant>
#include <vector>

#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/study/timing.hpp"

namespace kappabench::yoshida {

using namespace intrinsic;
using kappabench::Method;
using study::count_of, study::Findings, study::Key, study::Notes, study::Quantity, study::Row, study::Rows,
    study::Table;

namespace {

const Quantity solved = count_of("solved"), steps = count_of("iterations"), most_steps = count_of("most iterations");
const Quantity largest_gap{"largest gap", "1", Method::sampled};
/// A failure that a reader can repeat.
const Key chord_angle{"chord angle"}, turning{"turning"}, start_curvature{"start curvature"},
    end_curvature{"end curvature"};
const Quantity failure_gap{"failure: gap", "1", Method::sampled};

}  // namespace

void measure_kind(const Uses& uses, Notes& notes) {
  const Kind kind = kind_named(uses.words.at("kind"));
  const auto from = static_cast<std::uint64_t>(uses.numbers.at("from")),
             to = static_cast<std::uint64_t>(uses.numbers.at("to"));
  int met = 0, rising = 0, iterations = 0, most_iterations = 0;
  double gap = 0.0;
  std::vector<double>& seconds = notes.cell().timings["solve"];
  for (std::uint64_t i = from; i < to; ++i) {
    const StandardData data = random_viable(kind, uses.seed, i);
    const double start = processor_seconds();
    const HermiteFit fit = solve(data);
    seconds.push_back(processor_seconds() - start);
    iterations += fit.iterations;
    most_iterations = std::max(most_iterations, fit.iterations);
    if (fit.outcome == Outcome::converged) {
      ++met;
      gap = std::max(gap, fit.residual);
    }
    if (monotone(fit))
      ++rising;
    else
      notes.row({chord_angle(data.chord_angle), turning(data.turning), start_curvature(*data.start_curvature),
                 end_curvature(*data.end_curvature)},
                {failure_gap(fit.residual)});
  }
  notes.row({}, {kind_data(to - from), solved(met), kind_monotone(rising), steps(iterations),
                 most_steps(most_iterations), largest_gap(gap)});
}

void measure_infeasible(const Uses& uses, Notes& notes) {
  const auto n = static_cast<std::uint64_t>(uses.numbers.at("data"));
  for (std::uint64_t i = 0; i < n; ++i) {
    const StandardData data = random_infeasible(uses.seed, i);
    const bool refused = solve(data).outcome == Outcome::unsupported_input;
    const bool curve = std::ranges::any_of(
        families_of_figure_6(), [&data](const FixedFamily& family) { return rises(solve(data, family.settings())); });
    notes.row({}, {infeasible(1), infeasible_refused(refused ? 1 : 0), infeasible_monotone(curve ? 1 : 0)});
  }
}

Table kind_table(const Findings& found) {
  Table table("kinds", "Random viable data, automatic family",
              "Iterations are Newton steps in all, continuation included. Gap: chords and radians.");
  table.words("data").counts("cases").counts("solved").counts("monotone").numbers("mean iterations");
  table.counts("most iterations").numbers("largest gap");
  for (const Kind kind : all_kinds) {
    const Rows rows = found.rows().where({study::key::dataset(name(kind))});
    const double cases = rows.total(kind_data);
    if (cases > 0.0)
      table.row({name(kind), cases, rows.total(solved), rows.total(kind_monotone), rows.total(steps) / cases,
                 rows.largest(most_steps), rows.largest(largest_gap)});
  }
  return table;
}

Table kind_seconds_table(const Findings& found) {
  Table table("kinds-seconds", "Time of the automatic family",
              "Processor time of one solution on this machine, check of its gap included.");
  table.words("data").numbers("median", "us").numbers("longest", "us");
  for (const Kind kind : all_kinds) {
    std::vector<double> seconds;
    for (const store::CellRecord& cell : found.cells())
      if (const auto timed = cell.timings.find("solve"); cell.dataset == name(kind) && timed != cell.timings.end())
        std::ranges::copy(timed->second, std::back_inserter(seconds));
    if (!seconds.empty()) table.row({name(kind), 1e6 * median(seconds), 1e6 * largest(seconds)});
  }
  return table;
}

Table kind_failure_table(const Findings& found) {
  constexpr std::size_t most = 50;
  const Rows failures = found.rows().where_row([](const Row& row) { return row.has(failure_gap); });
  Table table("failures", "Viable data that the automatic family does not solve",
              fmt::format("{} in all; at most {} are listed.", failures.size(), most));
  table.numbers("chord angle").numbers("turning").numbers("start curvature").numbers("end curvature").numbers("gap");
  for (const Row* row : failures | std::views::take(most)) {
    std::vector<study::TableValue> values;
    for (const Key& key : {chord_angle, turning, start_curvature, end_curvature})
      values.emplace_back(std::get<double>((*row)[key]));
    values.emplace_back((*row)[failure_gap]);
    table.row(values);
  }
  return table;
}

}  // namespace kappabench::yoshida
