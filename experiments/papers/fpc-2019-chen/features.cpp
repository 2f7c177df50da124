// Chen 2019, Sect. 3: are cusps, loops and inflections where the points ask for them, and nowhere else?
#include <fmt/format.h>

#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/papers/fpc-2019-chen/feature_check.hpp"
#include "experiments/papers/fpc-2019-chen/inputs.hpp"
#include "experiments/run/record.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"

namespace kappabench {
namespace {

using namespace chen;
using study::count_of, study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Table;

constexpr std::string_view about =
    "The promise of FPC-curves: cusps and local loops only at points of that type, inflections only at such points and "
    "at joints, and every typed point what it is called. Checked on random typed inputs of six families, each with 4 "
    "to 12 points, open or closed, all types equally likely: cusps, sign changes of the curvature and self-crossings "
    "of every segment are isolated on the exact cubics. Counterexamples are drawn; without any, the first inputs are.";

// ---- what is measured

constexpr int inputs = 400, parts = 4, drawn = 6;
constexpr std::string_view counterexamples = "counterexamples";

const Quantity solved = count_of("solved"), residual{"residual", "1", Method::exact};
const Key feature{"feature"};
const Quantity inside = count_of("found in segments"), misplaced = count_of("not at a point of that type");
const Quantity typed = count_of("typed points"), missing = count_of("missing");
const Quantity thin = count_of("thin loops"), uncertified = count_of("uncertified segments");

void measure(const Uses& uses, const Input& input, Notes& notes) {
  const Fit fit = uses.schemes.front()->fit(input);
  notes.row({}, {solved(study::solved(fit)), residual(fit.report.residual)});
  if (!study::solved(fit)) return;
  const FeatureCheck check = check_features(fit);
  notes.row({feature("cusps")}, {inside(check.cusps), misplaced(check.misplaced_cusps)});
  notes.row({feature("loops")}, {inside(check.loops), misplaced(check.misplaced_loops)});
  notes.row({feature("inflections")}, {inside(check.inflections), misplaced(check.misplaced_inflections)});
  notes.row({}, {typed(check.typed), missing(check.missing), thin(check.thin_loops), uncertified(check.uncertified)});
  if (check.holds() || std::ssize(notes.cell().curves) >= drawn) return;
  notes.cell().curves.push_back(record_of(*uses.schemes.front(), fit, {}));
  notes.cell().curves.back().message = check.first;
}

std::string example(int i) { return fmt::format("random-typed-{}", i); }
std::string example_label(int i) { return fmt::format("input {}", i); }

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const SchemePtr scheme = context.registry.create("fpc");
  const std::vector<Input> all = typed_random_inputs("features", context.seed, inputs).curves;
  for (int part = 0; part < parts; ++part) {
    const auto first = all.begin() + part * inputs / parts;
    jobs.push_back(
        study::curves_job<measure>({.work = "features",
                                    .schemes = {scheme},
                                    .drawings = {{.id = fmt::format("random typed inputs, part {}", part + 1),
                                                  .curves = {first, first + inputs / parts}}},
                                    .metrics = {&find_metric("features")}},
                                   {}, std::string(counterexamples)));
  }
  for (int i = 0; i < drawn; ++i)
    jobs.push_back(fit_job({.id = example(i),
                            .title = fmt::format("random typed input {}", i),
                            .curves = {all[static_cast<std::size_t>(i)]}},
                           scheme, {}, example_label(i)));
  return jobs;
}

// ---- what follows

Table table(const Findings& found) {
  const study::Tally fits = study::tally_of(found.rows().values(solved));
  Table table("features", "Features found and where",
              fmt::format("{:.0f} random typed inputs, {:.0f} of them solved; {:.0f} typed points.", fits.cases,
                          fits.agree, found.rows().total(typed)));
  table.words("feature").counts("found in segments").counts("not at a point of that type");
  for (const auto& [name, rows] : found.rows().by(feature))
    table.row({std::get<std::string>(name), rows.total(inside), rows.total(misplaced)});
  return table;
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{.id = "fpc-features",
                             .title = "Random typed inputs",
                             .caption = "Curves with a feature where none was asked for, or without one that was.",
                             .columns = 3};
  for (const int cell : found.labelled(counterexamples)) {
    const std::vector<store::CurveRecord>& curves = found.cell(cell).curves;
    for (int c = 0; c < std::ssize(curves) && std::ssize(figure.panels) < drawn; ++c)
      figure.panels.push_back(Panel::curves({cell}, curves[static_cast<std::size_t>(c)].message).of_curve(c));
  }
  if (!figure.panels.empty()) return figure;
  figure.caption = "The first of the inputs; none of them all has a feature in the wrong place.";
  for (int i = 0; i < drawn; ++i)
    if (const auto cell = found.find(example(i), example_label(i)); cell && found.curve(*cell) != nullptr)
      figure.panels.push_back(Panel::curves({*cell}, example_label(i)));
  return figure;
}

void claim_features(Findings& found) {
  const study::Rows& rows = found.rows();
  const study::Tally fits = study::tally_of(rows.values(solved));
  const double unsolved = fits.misses();  // each is a miss of every claim
  const std::string evidence = fmt::format(
      "{:.0f} random typed inputs, {:.0f} of them not solved: one miss each. {:.0f} segments could not be searched "
      "completely.",
      fits.cases, unsolved, rows.total(uncertified));
  const study::Tally kept = study::all_but(rows.total(missing) + unsolved, rows.total(typed) + unsolved);
  found.judge(
      "points-have-their-type", kept,
      {kept.words() + " points of type cusp, loop or inflection are one",
       fmt::format("{} A cusp is a place where the speed falls below 1e-8 of its mean. {:.0f} loops are too thin to be "
                   "seen crossing themselves; the exact discriminant says that they do.",
                   evidence, rows.total(thin))});

  const study::Rows inflections = rows.where({feature("inflections")});
  const auto cusps_and_loops =
      rows.where_row([](const study::Row& row) { return row.has(inside) && !row.has(feature("inflections")); });
  const double wrong = cusps_and_loops.total(misplaced), all = cusps_and_loops.total(inside);
  found.judge("cusps-and-loops-at-points",
              study::all_but(wrong + rows.total(uncertified) + unsolved, all + rows.total(uncertified) + unsolved),
              {fmt::format("{:.0f} of {:.0f} elsewhere", wrong, all), evidence});
  found.judge("inflections-at-points-or-joints",
              study::all_but(inflections.total(misplaced) + unsolved, inflections.total(inside) + unsolved),
              {fmt::format("{:.0f} of {:.0f} inside a segment elsewhere", inflections.total(misplaced),
                           inflections.total(inside)),
               evidence});
}

void conclude(Findings& found) {
  found.add(table(found));
  found.add(figure(found));
  claim_features(found);
}

}  // namespace

Experiment fpc_features_experiment() {
  return study::experiment(
      {.id = "fpc-features",
       .title = "Cusps, loops and inflections where they belong (Chen 2019, Sect. 3)",
       .about = std::string(about),
       .paper = std::string(paper),
       .claims = {"points-have-their-type", "cusps-and-loops-at-points", "inflections-at-points-or-joints"},
       .jobs = jobs,
       .conclude = conclude});
}

}  // namespace kappabench
