#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "experiments/across/compare.hpp"
#include "experiments/study/measured.hpp"
#include "metrics/fairness.hpp"
#include "metrics/monotone_intervals.hpp"
#include "metrics/parabola_energy.hpp"

namespace kappabench::comparison {
namespace {

using study::Findings, study::Panel, study::Table;

constexpr const char* share_of_curves = "share of curves";

/// What is shown as a distribution, and how.
struct Distributed {
  const Column* column;
  const char *title, *axis;
  bool log;

  [[nodiscard]] std::string table() const { return "distribution-" + column->name; }
};

const std::array<Distributed, 3> distributed{
    {{&column::parabola_energy_centred.scaled_mean, "parabola-fit energy", "E_p times mean chord, mean over pieces",
      true},
     {&column::prominent_intervals_per_centred_piece_max, "intervals of monotone curvature",
      "most in a piece, small reversals ignored", false},
     {&column::mvc_energy, "variation of curvature", "L^3 times integral of (dκ/ds)^2", true}}};

/// The curves by scheme in the order of the cells.
std::vector<std::pair<std::string, std::vector<double>>> by_scheme(
    const Findings& found, const std::function<double(const store::CurveRecord&)>& value) {
  std::vector<std::pair<std::string, std::vector<double>>> values;
  for (const store::CellRecord& cell : found.cells()) {
    auto scheme = std::ranges::find(values, cell.label, &std::pair<std::string, std::vector<double>>::first);
    if (scheme == values.end()) scheme = values.insert(values.end(), {cell.label, {}});
    for (const store::CurveRecord& curve : cell.curves) scheme->second.push_back(value(curve));
  }
  return values;
}

bool converged(const store::CurveRecord& curve) { return curve.outcome == name(Outcome::converged); }

/// Empirical distribution functions, at most 50 steps each. A curve that did not converge, or has an infinite value,
/// is never below anything: the function ends below 1.
Table distribution_table(const Findings& found, const Distributed& shown_as) {
  constexpr std::size_t steps = 50;
  constexpr double least_shown = 1e-12, most_shown = 1e9;  // beyond: rounding, and all but cusps
  const Column& column = *shown_as.column;
  Table table(shown_as.table(), "Distribution of " + column.name,
              "Share of all curves given to a scheme on which it converged with at most this value. Values outside "
              "1e-12 to 1e9 are put at these ends.");
  table.words("scheme").numbers(column.name).numbers(share_of_curves);
  for (auto& [label, values] : by_scheme(found, [&](const store::CurveRecord& curve) {
         return converged(curve) ? measured(curve, column).value_or(undefined) : undefined;
       })) {
    const auto all = static_cast<double>(values.size());
    std::erase_if(values, [](double v) { return !std::isfinite(v); });
    for (double& v : values) v = std::clamp(v, least_shown, most_shown);
    std::ranges::sort(values);
    const std::size_t n = values.size(), shown = std::min(n, steps);
    for (std::size_t k = 1; k <= shown; ++k) {
      const std::size_t below = k * n / shown;
      table.row({label, values[below - 1], static_cast<double>(below) / all});
    }
  }
  return table;
}

}  // namespace

std::vector<Table> distribution_tables(const Findings& found) {
  std::vector<Table> tables;
  tables.reserve(std::size(distributed));
  for (const Distributed& each : distributed) tables.push_back(distribution_table(found, each));
  return tables;
}

/// Performance profiles of Dolan and More (Math. Program. 91, 2002): the share of curves that a scheme solves within
/// a factor of the fastest scheme's time.
Table profile_table(const Findings& found) {
  constexpr double never = std::numeric_limits<double>::infinity();
  Table table("profile-seconds", "Time of a fit against the fastest scheme's",
              "Share of all curves on which a scheme converged within a factor of the time of the fastest that "
              "converged there. Single fits on a machine that may be busy: experiments on timing repeat.");
  table.words("scheme").numbers("factor").numbers(share_of_curves);
  auto seconds =
      by_scheme(found, [](const store::CurveRecord& curve) { return converged(curve) ? curve.seconds : never; });
  std::size_t curves = 0;
  for (const auto& [label, values] : seconds) curves = std::max(curves, values.size());
  // A scheme whose cell was lost has no row for the curve: curves could not be matched.
  std::erase_if(seconds, [curves](const auto& scheme) { return scheme.second.size() != curves; });
  // Nobody knows how long it took to make a curve that was made elsewhere.
  std::erase_if(seconds, [](const auto& scheme) {
    return std::ranges::any_of(scheme.second, [](double value) { return std::isnan(value); });
  });
  std::vector<double> fastest(curves, never);
  for (const auto& [label, values] : seconds)
    for (std::size_t i = 0; i < curves; ++i) fastest[i] = std::min(fastest[i], values[i]);
  for (const auto& [label, values] : seconds)
    for (int k = 0; k <= 40; ++k) {  // factors 1 to 10^5, eight a decade
      const double factor = std::pow(10.0, k / 8.0);
      double within = 0.0;
      for (std::size_t i = 0; i < curves; ++i)
        within += std::isfinite(values[i]) && values[i] <= factor * fastest[i] ? 1.0 : 0.0;
      table.row({label, factor, within / static_cast<double>(curves)});
    }
  return table;
}

store::FigureRecord distribution_figure() {
  store::FigureRecord figure{
      .id = "compare-distributions",
      .title = "Distributions over all curves",
      .caption =
          "Share of curves on which a scheme converged with at most the value on the axis; last, "
          "within a factor of the fastest scheme's time (profiles of Dolan and Moré).",
      .columns = 2,
      .panels = {}};
  const auto add = [&](std::string table, std::string x, std::string title, std::string axis, bool log) {
    figure.panels.push_back(Panel::graph(std::move(table), std::move(x), {share_of_curves}, std::move(title))
                                .series("scheme")
                                .labels(std::move(axis), "")
                                .log_x(log));
  };
  for (const Distributed& each : distributed) add(each.table(), each.column->name, each.title, each.axis, each.log);
  add("profile-seconds", "factor", "time of a fit", "factor of the fastest scheme's time", true);
  return figure;
}

}  // namespace kappabench::comparison
