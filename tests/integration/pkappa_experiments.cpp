// The experiments on pκ-curves: what they conclude, and that they conclude otherwise from other data.

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "experiments/papers/pkappa-2024-wang/energies.hpp"
#include "experiments/papers/pkappa-2024-wang/inputs.hpp"
#include "experiments/papers/pkappa-2024-wang/ranks.hpp"
#include "experiments/papers/pkappa-2024-wang/two_ways.hpp"
#include "experiments/papers/pkappa-2024-wang/weights.hpp"
#include "experiments/study/notes.hpp"
#include "metrics/statistics.hpp"
#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"
#include "tests/integration/experiment_records.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

/// Rows of one number each: the numbers of a quantity, told apart by curve.
void fill(store::CellRecord& cell, const std::vector<study::KeyIs>& keys, const std::string& quantity,
          const std::vector<double>& values) {
  const study::Quantity what{quantity, "1", Method::sampled};
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::vector<study::KeyIs> own = keys;
    own.push_back(wang::curve_number(i));
    study::Notes(cell).row(own, {what(values[i])});
  }
}

/// The same in every cell of random curves with this label.
void fill(store::ExperimentRecord& record, const std::string& label, const std::string& quantity,
          const std::vector<double>& values, const std::vector<study::KeyIs>& keys = {}) {
  bool found = false;
  for (store::CellRecord& cell : record.cells) {
    if (cell.label != label || !cell.dataset.starts_with("random")) continue;
    found = true;
    fill(cell, keys, quantity, values);
  }
  REQUIRE(found);
}

/// As many cases as a verdict on what happens in general needs.
constexpr std::size_t enough = 200;
std::vector<double> many(double value) { return std::vector<double>(enough, value); }

/// Gives every pair of weights one curve with a number of its own.
void fill_weights(store::ExperimentRecord& record, const std::string& quantity, const std::array<double, 8>& values) {
  for (std::size_t p = 0; p < values.size(); ++p) {
    const std::string_view words = wang::table_1[p].words;
    fill(record, "random " + std::string(words), quantity, {values[p]}, {wang::weights_key(words)});
  }
}

std::string verdict_with(const std::string& experiment, const std::string& claim,
                         const std::function<void(store::ExperimentRecord&)>& fill_in) {
  store::ExperimentRecord record = blank(experiment);
  fill_in(record);
  return verdict(concluded(record), claim);
}

}  // namespace

TEST_CASE("pkappa experiments: every claim of the paper is judged once, and by data alone") {
  std::multiset<std::string> judged;
  for (const Experiment& experiment : all_experiments()) {
    if (!experiment.id.starts_with("pkappa-")) continue;
    INFO(experiment.id);
    std::set<std::string> here;
    for (const store::ClaimRecord& claim : concluded({.id = experiment.id}).claims) {
      INFO(claim.claim);
      CHECK(claim.paper == "pkappa-2024-wang");
      CHECK((claim.verdict == "undecided" || claim.verdict == "undecidable" || claim.verdict == "by construction"));
      here.insert(claim.claim);
    }
    judged.insert(here.begin(), here.end());
  }
  check_each_claim_is_judged_once("pkappa-2024-wang", judged);
}

TEST_CASE("pkappa experiments: runs repeat, tables and figures are filled") {
  for (const std::string id : {"pkappa-toy", "pkappa-construction", "pkappa-order-and-symmetry"}) {
    INFO(id);
    const store::ExperimentRecord record = run_one({.id = id});
    // Not the whole record: a curve that was not solved has NaN among its numbers.
    const store::ExperimentRecord once_more = concluded(record);
    CHECK(once_more.tables == record.tables);
    CHECK(once_more.figures == record.figures);
    CHECK(once_more.claims == record.claims);
    check_filled(record);
    if (id == "pkappa-toy") {
      const store::ExperimentRecord again = run_one({.id = id}, 1);
      CHECK(again.tables == record.tables);
      CHECK(again.claims == record.claims);
    }
  }
}

TEST_CASE("pkappa experiments: verdicts on what an edit changes follow the counts") {
  const auto with = [](double inserted, double moved, double at_end) {
    return [=](store::ExperimentRecord& record) {
      const study::Key edit{"edit"};
      const auto changed = [&](const std::string& what, const std::vector<double>& counts) {
        fill(record, "as printed", "changed segments", counts, {edit(what)});
      };
      changed("a point appended", {3, inserted});
      changed("a point moved", {3, moved});
      changed("one of the two at an open end moved", {2, at_end});
    };
  };
  for (const auto& [claim, values] : {std::pair("insertion-changes-three", std::array{4.0, 3.0, 2.0}),
                                      std::pair("move-changes-three", std::array{3.0, 4.0, 2.0}),
                                      std::pair("move-at-end-changes-two", std::array{3.0, 3.0, 3.0})}) {
    INFO(claim);
    CHECK(verdict_with("pkappa-construction", claim, with(3, 3, 2)) == "reproduced");
    CHECK(verdict_with("pkappa-construction", claim, with(values[0], values[1], values[2])) == "contradicted");
  }
}

TEST_CASE("pkappa experiments: verdicts on weights follow the energies") {
  const auto with = [](const std::string& claim, const std::string& quantity, const std::array<double, 8>& values) {
    return verdict_with("pkappa-weights", claim,
                        [&](store::ExperimentRecord& record) { fill_weights(record, quantity, values); });
  };
  std::array<double, 8> printed{}, opposite{};
  for (std::size_t p = 0; p < 8; ++p) {
    printed[p] = wang::table_1[p].mean;
    opposite[p] = 1e-6 / printed[p];
  }
  // What is not printed decides, whatever we measure.
  for (const std::string claim : {"table-1-order", "best-weights", "favourable-range"})
    for (const auto& values : {printed, opposite}) CHECK(with(claim, "mean E", values) == "undecidable");
  const auto all_but = [](double others, std::size_t pair, double value) {
    std::array<double, 8> values{};
    values.fill(others);
    values[pair] = value;
    return values;
  };
  CHECK(with("no-weights-elongate", "length over chords", all_but(1, wang::unweighted, 2.0)) == "reproduced");
  CHECK(with("no-weights-elongate", "length over chords", all_but(1, wang::unweighted, 0.5)) == "undecided");
  for (const auto& [crossings, expected] : {std::pair(3.0, "reproduced"), std::pair(1.0, "undecided")})
    CHECK(with("large-edge-weight-crosses", "crossings", all_but(1, wang::heavy_edges, crossings)) == expected);
}

TEST_CASE("pkappa experiments: verdicts on stages, continuity, symmetry and cost follow the data") {
  const auto stages = [](double after) {
    return [after](store::ExperimentRecord& record) {
      fill(record, "printed, stage 1", "mean E", many(1e-3));
      fill(record, "printed, stage 2", "mean E", many(after));
    };
  };
  CHECK(verdict_with("pkappa-stages", "stage-2-lowers-energy", stages(1e-4)) == "reproduced");
  CHECK(verdict_with("pkappa-stages", "stage-2-lowers-energy", stages(1e-2)) == "contradicted");

  const auto energies = [](double geometric) {
    return [geometric](store::ExperimentRecord& record) {
      for (const std::string parametric : {"C1, open, local", "C2, open, local"})
        fill(record, parametric, "mean E", many(1e-3));
      for (const std::string other : {"G1, open, local", "G2, open, local"})
        fill(record, other, "mean E", many(geometric));
    };
  };
  CHECK(verdict_with("pkappa-continuity", "geometric-lowers-energy", energies(1e-4)) == "reproduced");
  CHECK(verdict_with("pkappa-continuity", "geometric-lowers-energy", energies(1e-2)) == "contradicted");
  const auto curves = [](const std::string& column, double value) {
    return [column, value](store::ExperimentRecord& record) {
      const study::Quantity solved = study::count_of("solved"), segments = study::count_of("segments"),
                            measured{column, "1", Method::sampled};
      for (store::CellRecord& cell : record.cells)
        if (cell.label.ends_with("open, local"))
          for (std::size_t i = 0; i < enough; ++i)
            study::Notes(cell).row({wang::curve_number(i)}, {solved(1), segments(8), measured(value)});
    };
  };
  const std::string few = "segments_with_at_most_two_intervals", offset = "extremum_offset_mean";
  CHECK(verdict_with("pkappa-continuity", "two-intervals", curves(few, 0.9)) == "reproduced");
  CHECK(verdict_with("pkappa-continuity", "two-intervals", curves(few, 0.3)) == "contradicted");
  CHECK(verdict_with("pkappa-continuity", "points-near-extrema", curves(offset, 0.01)) == "reproduced");
  CHECK(verdict_with("pkappa-continuity", "points-near-extrema", curves(offset, 0.3)) == "contradicted");
  CHECK(verdict_with("pkappa-continuity", "continuity-held", curves("missed joints", 0)) == "by construction");

  const auto asymmetry = [](double local, double global) {
    return [local, global](store::ExperimentRecord& record) {
      const study::Key question{"question"};
      fill(record, "local", "deviation", many(local), {question("symmetric, open")});
      fill(record, "global", "deviation", many(global), {question("symmetric, open")});
    };
  };
  const std::string order = "pkappa-order-and-symmetry";
  CHECK(verdict_with(order, "symmetry-not-ensured", asymmetry(0.1, 0.0)) == "reproduced");
  CHECK(verdict_with(order, "symmetry-not-ensured", asymmetry(1e-9, 0.0)) == "not reproduced");
  CHECK(verdict_with(order, "global-may-improve", asymmetry(0.1, 1e-9)) == "reproduced");
  CHECK(verdict_with(order, "global-may-improve", asymmetry(0.1, 0.2)) == "not reproduced");

  const auto times = [](double global) {
    return [global](store::ExperimentRecord& record) {
      record.cells.front().timings["lm, local, both stages"] = {1e-3};
      record.cells.front().timings["lm, global, both stages"] = {global};
    };
  };
  CHECK(verdict_with("pkappa-solvers", "global-costs-more", times(5e-3)) == "reproduced");
  CHECK(verdict_with("pkappa-solvers", "global-costs-more", times(1e-6)) == "contradicted");
}

TEST_CASE("pkappa experiments: the table of solvers compares with Levenberg-Marquardt in the same windows") {
  store::ExperimentRecord record = blank("pkappa-solvers");
  store::CellRecord& cell = record.cells.front();
  for (const auto& [way, energy, seconds] :
       {std::tuple("lm, local, stage 1", 0.02, 1e-3), std::tuple("nlopt, local, stage 1", 0.03, 4e-3)}) {
    cell.timings[way] = {seconds, seconds};
    fill(cell, {study::Key{"way"}(way)}, "energy", {energy, undefined});
  }
  const store::ExperimentRecord done = concluded(record);
  const store::TableRecord& solvers = table_of(done, "solvers");
  REQUIRE(column_of(solvers, "solved") == std::vector<double>{1, 1});
  CHECK(column_of(solvers, "higher") == std::vector<double>{0, 1});
  CHECK(column_of(solvers, "lower") == std::vector<double>{0, 0});
  CHECK(column_of(solvers, "energy over lm")[1] == Approx(1.5));
  CHECK(column_of(solvers, "ratio to lm")[1] == Approx(4.0));
}

TEST_CASE("pkappa experiments: the bounds of the gallery are those of its curves") {
  store::ExperimentRecord record = run_one({.id = "pkappa-gallery"});
  const std::string ours = "our default mode";
  CHECK(verdict(record, "mean-energy-bound", ours) == "reproduced");
  set_column(record, "parabola_energy_native_mean", 0.01);
  for (const std::string& method : {ours, std::string("as printed")})
    CHECK(verdict(concluded(record), "mean-energy-bound", method) == "contradicted");
  CHECK(verdict(record, "time-bound") == "by construction");
}

TEST_CASE("pkappa experiments: energies are those of the paper's equations") {
  const Drawing stages = wang::scaled_to(wang::drawing("stages"), 3.0);
  CHECK(mean_chord(stages.curves.front()) == Approx(3.0));
  const SchemePtr scheme = all_schemes().create("pkappa");
  const Fit fit = scheme->fit(stages.curves.front());
  REQUIRE(fit.curve);
  const std::vector<double> energies = wang::parabola_energies(*fit.curve);
  REQUIRE(energies.size() == static_cast<std::size_t>(fit.curve->size()));
  for (const Measurement& m : find_metric("parabola_energy").measure(*scheme, fit)) {
    if (m.column == "parabola_energy_native_mean") CHECK(mean(energies) == Approx(m.value));
    if (m.column == "parabola_energy_native_max") CHECK(largest(energies) == Approx(m.value));
  }

  // A straight segment with edges 1, 2 and 3: E_p = 0, E_c = 14 and E_e = (1 - 4)^2 + (4 - 9)^2 = 34.
  const std::array<Vec2, 4> control{Vec2(0, 0), Vec2(1, 0), Vec2(3, 0), Vec2(6, 0)};
  const Curve line({std::make_shared<const PolynomialSegment>(control)}, {}, {{.point = 1, .segment = 0, .t = 0.5}},
                   false);
  CHECK(wang::first_stage_energy(line, 1.0) == Approx(0.1 * 14.0 + 0.1 * 34.0));
  CHECK(wang::first_stage_energy(line, 2.0) == Approx(0.1 * 14.0 / 4.0 + 0.1 * 34.0 / 16.0));
}

TEST_CASE("pkappa experiments: rank correlation and two ways curve by curve") {
  CHECK(wang::rank_correlation({1, 2, 3, 4}, {10, 20, 30, 1000}) == Approx(1.0));
  CHECK(wang::rank_correlation({1, 2, 3, 4}, {4, 3, 2, 1}) == Approx(-1.0));
  CHECK(wang::rank_correlation({1, 2, 2, 3}, {1, 2, 2, 3}) == Approx(1.0));
  // By hand: ranks (0, 1, 2) against (1, 0, 2) give 1 - 6 * 2 / (3 * 8).
  CHECK(wang::rank_correlation({1, 2, 3}, {5, 4, 6}) == Approx(0.5));
  CHECK(std::isnan(wang::rank_correlation({1, 2}, {1, 2})));
  CHECK(std::isnan(wang::rank_correlation({1, 2, undefined}, {1, 2, 3})));
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(wang::rank_correlation({1, 2, infinite}, {1, 2, 3}) == Approx(1.0));
  // Of the last pair one number is missing; the second differs by less than the margin.
  const wang::TwoWays both({{1.0, 2.0}, {1.0, 1.0 + 1e-9}, {3.0, 1.0}, {undefined, 1.0}}, 1e-6);
  CHECK(both.first_lower.cases == 3.0);
  CHECK(both.first_lower.agree == 1.0);
  CHECK(both.second_lower.agree == 1.0);
  CHECK(both.ratios.back() == 3.0);
}
