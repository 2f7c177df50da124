// The experiments on pκ-curves: what they conclude, and that they conclude otherwise from other data.

#include "experiments/papers/pkappa-2024-wang/common.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "experiments/study/summaries.hpp"
#include "metrics/parabola_energy.hpp"
#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"
#include "tests/integration/experiment_records.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

/// The cells of an experiment without their results: nothing is computed.
store::ExperimentRecord blank(const std::string& id) {
  store::ExperimentRecord record{.id = id};
  for (const CellJob& job : find_experiment(id).jobs({.registry = all_schemes()}))
    record.cells.push_back({.dataset = job.dataset,
                            .scheme = job.scheme,
                            .parameters = job.parameters,
                            .label = job.label,
                            .key = job.key,
                            .outcome = "converged"});
  return record;
}

/// Appends values of a column to the cells whose label contains `part`.
void fill(store::ExperimentRecord& record, const std::string& part, const std::string& column,
          const std::vector<double>& values) {
  bool found = false;
  for (store::CellRecord& cell : record.cells) {
    if (cell.label.find(part) == std::string::npos) continue;
    found = true;
    for (const double value : values) study::put(cell, column, value);
  }
  REQUIRE(found);
}

std::string verdict_with(const std::string& experiment, const std::string& claim,
                         const std::function<void(store::ExperimentRecord&)>& fill_in) {
  store::ExperimentRecord record = blank(experiment);
  fill_in(record);
  return verdict(concluded(record), claim);
}

const std::array<std::string, 8> weights{"(0, 0)",     "(0, 0.1)", "(0.01, 0.1)", "(1, 0.1)",
                                         "(0.1, 0.1)", "(0.1, 0)", "(0.1, 0.01)", "(0.1, 1)"};
/// Mean energies of Table 1.
const std::array<double, 8> printed{8.33e-3, 3.18e-4, 3.02e-4, 1.67e-2, 1.18e-4, 6.51e-4, 2.27e-3, 3.32e-4};

/// Gives every pair of weights one curve with this mean energy.
void fill_means(store::ExperimentRecord& record, const std::array<double, 8>& means) {
  for (std::size_t p = 0; p < weights.size(); ++p) fill(record, "random " + weights[p], "mean", {means[p]});
}

}  // namespace

TEST_CASE("pkappa experiments: every claim of the paper is judged once, and by data alone") {
  std::multiset<std::string> judged;
  for (const Experiment& experiment : all_experiments()) {
    if (!experiment.id.starts_with("pkappa-")) continue;
    INFO(experiment.id);
    for (const store::ClaimRecord& claim : concluded({.id = experiment.id}).claims) {
      INFO(claim.claim);
      CHECK(claim.paper == "pkappa-2024-wang");
      CHECK(claim.verdict == "not reproduced");
      judged.insert(claim.claim);
    }
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
      fill(record, "as printed", "changed by an insertion", {3, inserted});
      fill(record, "as printed", "changed by moving", {3, moved});
      fill(record, "as printed", "changed by moving near an end", {2, at_end});
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
  const auto means = [](const std::array<double, 8>& all) {
    return [all](store::ExperimentRecord& record) { fill_means(record, all); };
  };
  std::array<double, 8> opposite{};
  for (std::size_t p = 0; p < 8; ++p) opposite[p] = 1e-6 / printed[p];
  for (const std::string claim : {"table-1-order", "best-weights", "favourable-range"}) {
    INFO(claim);
    CHECK(verdict_with("pkappa-weights", claim, means(printed)) == "reproduced");
    CHECK(verdict_with("pkappa-weights", claim, means(opposite)) == "contradicted");
  }
  const auto lengths = [](double without) {
    return [without](store::ExperimentRecord& record) {
      for (const std::string& pair : weights)
        fill(record, "random " + pair, "length", {pair == "(0, 0)" ? without : 1});
    };
  };
  CHECK(verdict_with("pkappa-weights", "no-weights-elongate", lengths(2.0)) == "reproduced");
  CHECK(verdict_with("pkappa-weights", "no-weights-elongate", lengths(0.5)) == "contradicted");
  const auto crossings = [](double heavy) {
    return [heavy](store::ExperimentRecord& record) {
      for (const std::string& pair : weights)
        fill(record, "random " + pair, "crossings", {pair == "(1, 0.1)" ? heavy : 1});
    };
  };
  CHECK(verdict_with("pkappa-weights", "large-edge-weight-crosses", crossings(3)) == "reproduced");
  CHECK(verdict_with("pkappa-weights", "large-edge-weight-crosses", crossings(1)) == "not reproduced");
  CHECK(verdict_with("pkappa-weights", "large-edge-weight-crosses", crossings(0)) == "contradicted");
  const auto sensitivity = [](double change) {
    return [change](store::ExperimentRecord& record) { fill(record, "random ", "sensitivity", {change}); };
  };
  CHECK(verdict_with("pkappa-weights", "table-1-three-digits", sensitivity(1e-6)) == "reproduced");
  CHECK(verdict_with("pkappa-weights", "table-1-three-digits", sensitivity(0.5)) == "contradicted");
}

TEST_CASE("pkappa experiments: verdicts on stages, continuity, symmetry and cost follow the data") {
  const auto stages = [](double after) {
    return [after](store::ExperimentRecord& record) {
      fill(record, "random: printed, stage 1", "mean E", {1e-3});
      fill(record, "random: printed, stage 2", "mean E", {after});
    };
  };
  CHECK(verdict_with("pkappa-stages", "stage-2-lowers-energy", stages(1e-4)) == "reproduced");
  CHECK(verdict_with("pkappa-stages", "stage-2-lowers-energy", stages(1e-2)) == "contradicted");

  const auto energies = [](double geometric) {
    return [geometric](store::ExperimentRecord& record) {
      for (const std::string parametric : {"C1, open", "C2, open"}) fill(record, parametric, "mean E", {1e-3});
      for (const std::string other : {"G1, open", "G2, open"}) fill(record, other, "mean E", {geometric});
    };
  };
  CHECK(verdict_with("pkappa-continuity", "geometric-lowers-energy", energies(1e-4)) == "reproduced");
  CHECK(verdict_with("pkappa-continuity", "geometric-lowers-energy", energies(1e-2)) == "contradicted");
  const auto curves = [](const std::string& column, double value) {
    return [column, value](store::ExperimentRecord& record) {
      fill(record, "open, local", "solved", {1});
      fill(record, "open, local", "segments", {8});
      fill(record, "open, local", column, {value});
    };
  };
  const std::string few = "segments_with_at_most_two_intervals", offset = "extremum_offset_mean";
  CHECK(verdict_with("pkappa-continuity", "two-intervals", curves(few, 0.9)) == "reproduced");
  CHECK(verdict_with("pkappa-continuity", "two-intervals", curves(few, 0.3)) == "contradicted");
  CHECK(verdict_with("pkappa-continuity", "points-near-extrema", curves(offset, 0.01)) == "reproduced");
  CHECK(verdict_with("pkappa-continuity", "points-near-extrema", curves(offset, 0.3)) == "contradicted");
  CHECK(verdict_with("pkappa-continuity", "continuity-held", curves("missed joints", 0)) == "reproduced");
  CHECK(verdict_with("pkappa-continuity", "continuity-held", curves("missed joints", 1)) == "contradicted");

  const auto asymmetry = [](double local, double global) {
    return [local, global](store::ExperimentRecord& record) {
      for (store::CellRecord& cell : record.cells)
        if (cell.label == "numbers: local" || cell.label == "numbers: global")
          study::put(cell, "symmetric, open", cell.label == "numbers: local" ? local : global);
    };
  };
  const std::string order = "pkappa-order-and-symmetry";
  CHECK(verdict_with(order, "symmetry-not-ensured", asymmetry(0.1, 0.0)) == "reproduced");
  CHECK(verdict_with(order, "symmetry-not-ensured", asymmetry(1e-9, 0.0)) == "contradicted");
  CHECK(verdict_with(order, "global-may-improve", asymmetry(0.1, 1e-9)) == "reproduced");
  CHECK(verdict_with(order, "global-may-improve", asymmetry(0.1, 0.2)) == "contradicted");

  const auto times = [](double global) {
    return [global](store::ExperimentRecord& record) {
      record.cells.front().timings["lm, local, both stages"] = {1e-3};
      record.cells.front().timings["lm, global, both stages"] = {global};
    };
  };
  CHECK(verdict_with("pkappa-solvers", "global-costs-more", times(5e-3)) == "reproduced");
  CHECK(verdict_with("pkappa-solvers", "global-costs-more", times(1e-4)) == "contradicted");
}

TEST_CASE("pkappa experiments: the table of solvers compares with Levenberg-Marquardt in the same windows") {
  store::ExperimentRecord record = blank("pkappa-solvers");
  store::CellRecord& cell = record.cells.front();
  for (const auto& [way, energy, seconds] :
       {std::tuple("lm, local, stage 1", 0.02, 1e-3), std::tuple("nlopt, local, stage 1", 0.03, 4e-3)}) {
    cell.timings[way] = {seconds, seconds};
    study::put(cell, std::string(way) + ": energy", energy);
    study::put(cell, std::string(way) + ": energy", std::numeric_limits<double>::quiet_NaN());
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
  CHECK(verdict(record, "mean-energy-bound") == "reproduced");
  set_column(record, "parabola_energy_native_mean", 0.01);
  CHECK(verdict(concluded(record), "mean-energy-bound") == "contradicted");
  for (store::CellRecord& cell : record.cells)
    for (store::CurveRecord& curve : cell.curves) curve.seconds = 100.0;
  CHECK(verdict(concluded(record), "time-bound") == "contradicted");
}

TEST_CASE("pkappa experiments: energies are those of the paper's equations") {
  const Drawing stages = wang::scaled_to(wang::drawing("stages"), 3.0);
  CHECK(mean_chord(stages.curves.front()) == Approx(3.0));
  const SchemePtr scheme = wang::pkappa(all_schemes(), "");
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
  CHECK(wang::same(line.segment(0), line.segment(0)));
  CHECK_FALSE(wang::same(line.segment(0), fit.curve->segment(0)));
}

TEST_CASE("pkappa experiments: rank correlation and verdicts on what happens often") {
  CHECK(wang::rank_correlation({1, 2, 3, 4}, {10, 20, 30, 1000}) == Approx(1.0));
  CHECK(wang::rank_correlation({1, 2, 3, 4}, {4, 3, 2, 1}) == Approx(-1.0));
  CHECK(wang::rank_correlation({1, 2, 2, 3}, {1, 2, 2, 3}) == Approx(1.0));
  // By hand: ranks (0, 1, 2) against (1, 0, 2) give 1 - 6 * 2 / (3 * 8).
  CHECK(wang::rank_correlation({1, 2, 3}, {5, 4, 6}) == Approx(0.5));
  CHECK(std::isnan(wang::rank_correlation({1, 2}, {1, 2})));
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(wang::rank_correlation({1, 2, infinite}, {1, 2, 3}) == Approx(1.0));
  CHECK(wang::verdict_often({}) == "not reproduced");
  CHECK(wang::verdict_often({.agree = 2, .cases = 3}) == "reproduced");
  CHECK(wang::verdict_often({.agree = 3, .cases = 5}) == "not reproduced");
  CHECK(wang::verdict_often({.agree = 2, .cases = 5}) == "contradicted");
}
