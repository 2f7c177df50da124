#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/papers/fpc-2019-chen/feature_check.hpp"
#include "experiments/papers/fpc-2019-chen/inputs.hpp"
#include "experiments/run/record.hpp"
#include "experiments/study/summaries.hpp"

namespace kappabench {

using namespace fpc;

namespace {

constexpr std::string_view about =
    "The promise of FPC-curves: cusps and local loops only at points of that type, inflections only at such points and "
    "at joints, and every typed point what it is called. Checked on random typed inputs of six families, each with 4 "
    "to 12 points, open or closed, all types equally likely: cusps, sign changes of the curvature and self-crossings "
    "of every segment are isolated on the exact cubics. Counterexamples are drawn; without any, the first inputs are.";

constexpr int version = 1;
constexpr int inputs = 400;
constexpr int drawn = 6;

void measure(const Scheme& scheme, std::uint64_t seed, int from, int count, store::CellRecord& cell) {
  for (int i = from; i < from + count; ++i) {
    const Fit fit = scheme.fit(typed_random_input(seed, static_cast<std::uint64_t>(i)));
    study::put(cell, "inputs", 1.0);
    study::put(cell, "residual", fit.report.residual);
    if (!study::solved(fit)) {
      study::put(cell, "unsolved", 1.0);
      continue;
    }
    const FeatureCheck check = check_features(fit);
    study::put(cell, "cusps", check.cusps);
    study::put(cell, "loops", check.loops);
    study::put(cell, "inflections", check.inflections);
    study::put(cell, "misplaced cusps", check.misplaced_cusps);
    study::put(cell, "misplaced loops", check.misplaced_loops);
    study::put(cell, "misplaced inflections", check.misplaced_inflections);
    study::put(cell, "typed", check.typed);
    study::put(cell, "missing", check.missing);
    study::put(cell, "thin", check.thin_loops);
    study::put(cell, "uncertified", check.uncertified);
    if (!check.holds() && std::ssize(cell.curves) < drawn) {
      cell.curves.push_back(record_of(scheme, fit, {}));
      cell.message = fmt::format("input {}: {}", i, check.first);
    }
  }
}

/// Inputs to look at: each in a cell of its own.
CellJob example_job(const SchemePtr& scheme, std::uint64_t seed, int index) {
  Drawing drawing{.id = fmt::format("random-typed-{}", index),
                  .title = fmt::format("random typed input {}", index),
                  .curves = {typed_random_input(seed, static_cast<std::uint64_t>(index))}};
  return study::drawn_job(drawing, scheme, fmt::format("input {}", index));
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const SchemePtr scheme = context.registry.create("fpc");
  const std::uint64_t seed = context.seed;
  constexpr int parts = 4;
  for (int part = 0; part < parts; ++part) {
    CellJob job = other_job(fmt::format("random typed inputs, part {}", part + 1), scheme,
                            fmt::format("features {}, seed {}, {} inputs", version, seed, inputs),
                            [scheme, seed, part](store::CellRecord& cell) {
                              measure(*scheme, seed, part * inputs / parts, inputs / parts, cell);
                            });
    job.label = "counterexamples";
    jobs.push_back(std::move(job));
  }
  for (int i = 0; i < drawn; ++i) jobs.push_back(example_job(scheme, seed, i));
  return jobs;
}

store::TableRecord table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "features", "Features found and where",
      fmt::format("{:.0f} random typed inputs, {:.0f} of them solved; {:.0f} typed points.",
                  study::total(record, "inputs"), study::total(record, "inputs") - study::total(record, "unsolved"),
                  study::total(record, "typed")));
  builder.words("feature").counts("found in segments").counts("not at a point of that type");
  for (const std::string_view what : {"cusps", "loops", "inflections"})
    builder.row(
        {std::string(what), study::total(record, what), study::total(record, fmt::format("misplaced {}", what))});
  return builder.table();
}

std::string inputs_in_words(const store::ExperimentRecord& record) {
  return fmt::format(
      "{:.0f} random typed inputs; {:.0f} were not solved and are left out. {:.0f} segments could not be "
      "searched completely.",
      study::total(record, "inputs"), study::total(record, "unsolved"), study::total(record, "uncertified"));
}

store::ClaimRecord cusps_claim(const store::ExperimentRecord& record) {
  const double found = study::total(record, "cusps") + study::total(record, "loops");
  const double wrong = study::total(record, "misplaced cusps") + study::total(record, "misplaced loops");
  return claim("cusps-and-loops-at-points", study::verdict_for_all(wrong + study::total(record, "uncertified"), found),
               fmt::format("{:.0f} of {:.0f} elsewhere", wrong, found), inputs_in_words(record));
}

store::ClaimRecord inflections_claim(const store::ExperimentRecord& record) {
  const double found = study::total(record, "inflections"), wrong = study::total(record, "misplaced inflections");
  return claim("inflections-at-points-or-joints", study::verdict_for_all(wrong, found),
               fmt::format("{:.0f} of {:.0f} inside a segment elsewhere", wrong, found), inputs_in_words(record));
}

store::ClaimRecord types_claim(const store::ExperimentRecord& record) {
  const double typed = study::total(record, "typed"), missing = study::total(record, "missing");
  return claim(
      "points-have-their-type", study::verdict_for_all(missing, typed),
      fmt::format("{} points of type cusp, loop or inflection are one", study::share(typed - missing, typed)),
      fmt::format("{} A cusp is a place where the speed falls below 1e-8 of its mean. {:.0f} loops are too thin to be "
                  "seen crossing themselves; the exact discriminant says that they do.",
                  inputs_in_words(record), study::total(record, "thin")));
}

store::FigureRecord figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{
      .id = "fpc-features", .title = "Random typed inputs", .caption = {}, .columns = 3, .panels = {}};
  for (std::size_t i = 0; i < record.cells.size(); ++i) {
    const store::CellRecord& cell = record.cells[i];
    if (cell.label != "counterexamples") continue;
    for (int c = 0; c < std::ssize(cell.curves) && std::ssize(figure.panels) < drawn; ++c) {
      figure.panels.push_back(curve_panel(static_cast<int>(i), cell.message));
      figure.panels.back().curve = c;
    }
  }
  figure.caption = "Curves with a feature where none was asked for, or without one that was.";
  if (!figure.panels.empty()) return figure;
  figure.caption = "The first of the inputs; none of them all has a feature in the wrong place.";
  for (std::size_t i = 0; i < record.cells.size(); ++i)
    if (!record.cells[i].curves.empty())
      figure.panels.push_back(curve_panel(static_cast<int>(i), record.cells[i].label));
  return figure;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {table(record)};
  if (auto shown = figure(record); !shown.panels.empty()) record.figures = {std::move(shown)};
  record.claims = {types_claim(record), cusps_claim(record), inflections_claim(record)};
}

}  // namespace

Experiment fpc_features_experiment() {
  return {.id = "fpc-features",
          .title = "Cusps, loops and inflections where they belong (Chen 2019, Sect. 3)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
