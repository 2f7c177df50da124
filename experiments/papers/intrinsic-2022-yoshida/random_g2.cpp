#include "experiments/papers/intrinsic-2022-yoshida/random_g2.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/study/summaries.hpp"
#include "experiments/study/timing.hpp"

namespace kappabench::yoshida {

using namespace intrinsic;

void measure_kind(Kind kind, std::uint64_t seed, long from, long to, store::CellRecord& cell) {
  double solved = 0.0, rising = 0.0, iterations = 0.0, most_iterations = 0.0, largest_gap = 0.0;
  std::vector<double>& seconds = cell.timings["solve"];
  for (long i = from; i < to; ++i) {
    const StandardData data = random_viable(kind, seed, static_cast<std::uint64_t>(i));
    const double start = processor_seconds();
    const HermiteFit fit = solve(data);
    seconds.push_back(processor_seconds() - start);
    iterations += fit.iterations;
    most_iterations = std::max<double>(most_iterations, fit.iterations);
    const bool met = fit.outcome == Outcome::converged;
    solved += met ? 1.0 : 0.0;
    if (met) largest_gap = std::max(largest_gap, fit.residual);
    if (met && monotone(fit)) {
      rising += 1.0;
      continue;
    }
    study::put(cell, "failure: chord angle", data.chord_angle);
    study::put(cell, "failure: turning", data.turning);
    study::put(cell, "failure: start curvature", *data.start_curvature);
    study::put(cell, "failure: end curvature", *data.end_curvature);
    study::put(cell, "failure: gap", fit.residual, kappabench::Method::sampled);
  }
  study::put(cell, "data", static_cast<double>(to - from));
  study::put(cell, "solved", solved);
  study::put(cell, "monotone", rising);
  study::put(cell, "iterations", iterations);
  study::put(cell, "most iterations", most_iterations);
  study::put(cell, "largest gap", largest_gap, kappabench::Method::sampled);
}

/// Data that should have no monotone curve: does any family find one?
void measure_infeasible(std::uint64_t seed, long n, store::CellRecord& cell) {
  for (long i = 0; i < n; ++i) {
    const StandardData data = random_infeasible(seed, static_cast<std::uint64_t>(i));
    study::put(cell, "infeasible", 1.0);
    study::put(cell, "infeasible refused", solve(data).outcome == Outcome::unsupported_input ? 1.0 : 0.0);
    bool found = false;
    for (const FixedFamily& family : families_of_figure_6()) found = found || rises(solve(data, family.settings()));
    study::put(cell, "infeasible with a monotone curve", found ? 1.0 : 0.0);
  }
}

store::TableRecord kind_table(const store::ExperimentRecord& record) {
  TableBuilder builder("kinds", "Random viable data, automatic family",
                       "Iterations are Newton steps in all, continuation included. Gap: chords and radians.");
  builder.words("data").counts("cases").counts("solved").counts("monotone").numbers("mean iterations");
  builder.counts("most iterations").numbers("largest gap");
  for (const Kind kind : all_kinds) {
    const double cases = study::total(record, "data", name(kind));
    if (!(cases > 0.0)) continue;
    builder.row({std::string(name(kind)), cases, study::total(record, "solved", name(kind)),
                 study::total(record, "monotone", name(kind)), study::total(record, "iterations", name(kind)) / cases,
                 largest(study::values(record, "most iterations", name(kind))),
                 largest(study::values(record, "largest gap", name(kind)))});
  }
  return builder.table();
}

store::TableRecord kind_seconds_table(const store::ExperimentRecord& record) {
  TableBuilder builder("kinds-seconds", "Time of the automatic family",
                       "Processor time of one solution on this machine, check of its gap included.");
  builder.words("data").numbers("median", "us").numbers("longest", "us");
  for (const Kind kind : all_kinds) {
    std::vector<double> seconds;
    for (const store::CellRecord& cell : record.cells)
      if (const auto found = cell.timings.find("solve"); cell.dataset == name(kind) && found != cell.timings.end())
        std::ranges::copy(found->second, std::back_inserter(seconds));
    if (!seconds.empty()) builder.row({std::string(name(kind)), 1e6 * median(seconds), 1e6 * largest(seconds)});
  }
  return builder.table();
}

store::TableRecord kind_failure_table(const store::ExperimentRecord& record) {
  constexpr std::size_t most = 50;
  std::array<std::vector<double>, 5> columns;
  constexpr std::array<std::string_view, 5> names{"chord angle", "turning", "start curvature", "end curvature", "gap"};
  for (std::size_t c = 0; c < names.size(); ++c)
    columns[c] = study::values(record, fmt::format("failure: {}", names[c]));
  TableBuilder builder("failures", "Viable data that the automatic family does not solve",
                       fmt::format("{} in all; at most {} are listed.", columns[0].size(), most));
  for (const std::string_view column : names) builder.numbers(std::string(column));
  for (std::size_t i = 0; i < std::min(columns[0].size(), most); ++i) {
    std::vector<TableBuilder::Cell> row;
    row.reserve(columns.size());
    for (const auto& column : columns) row.emplace_back(column[i]);
    builder.row(row);
  }
  return builder.table();
}

}  // namespace kappabench::yoshida
