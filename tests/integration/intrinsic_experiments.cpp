// The experiments on curves with B-spline curvature: what they conclude, and that they conclude otherwise from other
// data.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "datasets/random_source.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/inputs.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/region.hpp"
#include "schemes/intrinsic/viable_region.hpp"
#include "tests/catch.hpp"
#include "tests/integration/experiment_records.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

/// The experiments with amounts that take moments.
const std::vector<PlannedExperiment> experiments{
    {.id = "intrinsic-example"},
    {.id = "intrinsic-timing", .datasets = {"random-g1:n=10"}},
    {.id = "intrinsic-g1", .datasets = {"random-g1:n=40"}},
    {.id = "intrinsic-viable-region", .datasets = {"grid:n=6", "random-g2:n=15", "infeasible:n=30", "spirals:n=200"}},
    {.id = "intrinsic-g2"},
    {.id = "intrinsic-control", .datasets = {"random-g1:n=1"}},
    {.id = "intrinsic-g1-to-g2"}};

/// Claims that no data decide.
const std::map<std::string, std::string> without_data{
    {"level-ends", "by construction"}, {"g1-made-g2", "by construction"}, {"time-grows", "undecidable"}};

store::ExperimentRecord computed(const PlannedExperiment& planned) {
  return test::computed(planned.id, {.registry = all_schemes(), .datasets = planned.datasets});
}

store::ExperimentRecord computed_small(const std::string& id) {
  return computed(*std::ranges::find(experiments, id, &PlannedExperiment::id));
}

}  // namespace

TEST_CASE("intrinsic experiments: tables, figures and one verdict for every claim of the paper") {
  std::multiset<std::string> judged;
  for (const PlannedExperiment& planned : experiments) {
    INFO(planned.id);
    const store::ExperimentRecord record = concluded(computed(planned));
    check_same_conclusions(concluded(record), record);
    REQUIRE_FALSE(record.figures.empty());
    for (const store::FigureRecord& figure : record.figures) CHECK_FALSE(figure.panels.empty());
    for (const store::TableRecord& table : record.tables) {
      INFO(table.id);
      const bool rows = std::visit([](const auto& cells) { return !cells.empty(); }, table.columns.front().cells);
      CHECK(rows == (table.id != "failures"));  // there are none
    }
    for (const store::ClaimRecord& claim : record.claims) {
      CHECK(claim.paper == yoshida::paper);
      CHECK_FALSE(claim.ours.empty());
      judged.insert(claim.claim);
    }
    // A verdict needs data.
    const store::ExperimentRecord empty{.id = planned.id};
    for (const store::ClaimRecord& claim : concluded(empty).claims) {
      INFO(claim.claim);
      CHECK(claim.verdict == (without_data.contains(claim.claim) ? without_data.at(claim.claim) : "undecided"));
    }
  }
  check_each_claim_is_judged_once(std::string(yoshida::paper), judged);
}

TEST_CASE("intrinsic experiments: verdicts follow the data") {
  struct Row {
    std::string experiment, claim, column;
    double value;
    std::string before, after;
  };
  std::map<std::string, store::ExperimentRecord> once;
  for (const Row& row :
       {Row{"intrinsic-example", "integral-of-bezier-segments", "whole is off", 1e-3, "reproduced", "contradicted"},
        Row{"intrinsic-example", "angle-in-closed-form", "printed is off", 1e-16, "misprint", "reproduced"},
        Row{"intrinsic-example", "angle-in-closed-form", "corrected is off", 1e-3, "misprint", "contradicted"},
        Row{"intrinsic-g1", "monotone-for-p", "not monotone", 1, "reproduced", "contradicted"},
        Row{"intrinsic-g1", "inflection-may-appear", "inflected", 0, "reproduced", "not reproduced"},
        // Of 80 conditions 79 change, which could be less than 95 % of all.
        Row{"intrinsic-g1", "p-changes-shape", "reshaped", 40, "undecided", "reproduced"},
        Row{"intrinsic-g1", "p-changes-shape", "reshaped", 1, "undecided", "contradicted"},
        Row{"intrinsic-g1", "length-from-turning", "lengths by Eq. (8)", 1, "reproduced", "contradicted"},
        Row{"intrinsic-viable-region", "any-g2-data", "monotone", 14, "reproduced", "contradicted"},
        Row{"intrinsic-viable-region", "more-with-b-splines", "covered to", 0, "reproduced", "undecided"},
        Row{"intrinsic-viable-region", "curvature-over-chord", "inside by multiplication", 1, "misprint",
            "contradicted"},
        Row{"intrinsic-g2", "beyond-previous-method", "nearest end", 0, "reproduced", "undecided"},
        Row{"intrinsic-g2", "like-a-step", "transition", 0.5, "reproduced", "contradicted"},
        Row{"intrinsic-g2", "like-a-step", "monotone", 0, "reproduced", "undecided"},
        Row{"intrinsic-control", "moved-controls-keep-data", "moderate moves solved", 0, "reproduced", "contradicted"},
        Row{"intrinsic-control", "large-moves", "no solution from", std::nan(""), "reproduced", "undecided"}}) {
    INFO(row.claim);
    if (!once.contains(row.experiment)) once.emplace(row.experiment, computed_small(row.experiment));
    store::ExperimentRecord record = once.at(row.experiment);
    CHECK(verdict(concluded(record), row.claim) == row.before);
    set_column(record, row.column, row.value);
    CHECK(verdict(concluded(record), row.claim) == row.after);
  }
}

TEST_CASE("intrinsic experiments: Eq. (12) is judged by the curves that are found") {
  store::ExperimentRecord record = computed_small("intrinsic-viable-region");
  // Were all ends of spirals inside with curvatures over the chord, that would stand.
  set_column(record, "spirals with chord 4", 7);
  set_column(record, "inside by division", 7);
  CHECK(verdict(concluded(record), "curvature-over-chord") == "reproduced");
  CHECK(verdict(concluded(record), "monotone-region") == "misprint");
  // Were there a monotone curve everywhere, the printed inequality would stand.
  for (store::CellRecord& cell : record.cells) {
    if (cell.label != "automatic") continue;
    yoshida::Region region = yoshida::region_of(study::Rows({cell}));
    std::ranges::fill(region.inside, 1);
    cell.rows.clear();
    study::Notes notes(cell);
    yoshida::put_region(region, notes);
  }
  CHECK(verdict(concluded(record), "monotone-region") == "reproduced");
}

TEST_CASE("intrinsic experiments: times decide about times") {
  store::ExperimentRecord record = computed_small("intrinsic-timing");
  const auto set_times = [&record](const std::string& work, auto&& seconds) {
    for (store::CellRecord& cell : record.cells) {
      double row = 0.0;
      for (const std::string name : {"degree 1, 2", "degree 2, 3", "degree 3, 4", "degree 3, 6", "degree 3, 8"})
        cell.timings.at(name + " controls: " + work).assign(3, seconds(row++));
    }
  };
  set_times("each condition", [](double row) { return 1e-3 * (1.0 + row); });
  CHECK(verdict(concluded(record), "interactive") == "reproduced");
  set_times("each condition", [](double row) { return 1e-2 * (1.0 + row); });
  CHECK(verdict(concluded(record), "interactive") == "undecided");
  set_times("each condition", [](double) { return 1.0; });
  CHECK(verdict(concluded(record), "interactive") == "not reproduced");
  // How it grows is our quadrature's doing, whatever it is.
  set_times("simplex and points", [](double row) { return 1e-3 * (1.0 + row); });
  CHECK(verdict(concluded(record), "time-grows") == "undecidable");
}

TEST_CASE("intrinsic experiments: all but times is the same in every run") {
  for (const PlannedExperiment& planned : experiments) {
    if (planned.id == "intrinsic-timing") continue;
    INFO(planned.id);
    const auto without_times = [](store::ExperimentRecord record) {
      std::erase_if(record.tables, [](const store::TableRecord& table) { return table.id.ends_with("-seconds"); });
      return record;
    };
    check_same_conclusions(without_times(run_one(planned, 1)), without_times(run_one(planned, 2)));
  }
}

TEST_CASE("intrinsic experiments: amounts are named and numbers") {
  const auto jobs = [](const std::string& id, const std::string& dataset) {
    (void)find_experiment(id).jobs({.registry = all_schemes(), .datasets = {dataset}});
  };
  CHECK_THROWS_WITH(jobs("intrinsic-g1", "bird"), ContainsSubstring("random-g1:n=1000"));
  CHECK_THROWS_WITH(jobs("intrinsic-g1", "random-g1:n=0"), ContainsSubstring("n"));
  CHECK_THROWS_WITH(jobs("intrinsic-viable-region", "grid:m=4"), ContainsSubstring("m"));
}

TEST_CASE("random Hermite data are of their kind, and the same for the same seed") {
  using namespace yoshida;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const auto angles = random_angles(Angles::ordinary, 3, i);
    CHECK(angles.chord_angle > 0.0);
    CHECK(angles.end_angle() >= angles.chord_angle);
    CHECK(angles.end_angle() < 1.5708);
    for (const Kind kind : all_kinds) {
      INFO(name(kind) << " " << i);
      const auto data = random_viable(kind, 3, i), again = random_viable(kind, 3, i);
      CHECK(data.start_curvature == again.start_curvature);
      const auto v = intrinsic::viability(data);
      CHECK(v.viable());
      CHECK(v.rising == (kind != Kind::mirrored));
      if (kind == Kind::inflection) CHECK(*data.start_curvature * *data.end_curvature < 0.0);
      if (kind == Kind::s_shape) CHECK(data.chord_angle * data.end_angle() < 0.0);
    }
    CHECK_FALSE(intrinsic::viability(random_infeasible(3, i)).viable());
    const Spiral spiral = random_spiral(3, i);
    CHECK(intrinsic::gap(spiral.curve, spiral.data) < 1e-12);
    CHECK(std::ranges::is_sorted(spiral.curve.controls));
  }
}

TEST_CASE("rising curvature is seen on the function, not on its controls alone") {
  const auto fit = [](std::vector<double> controls) {
    intrinsic::HermiteFit made{Outcome::converged, "",
                               intrinsic::StandardCurve{uniform_basis(3, 4), std::move(controls), 1.0}};
    return made;
  };
  CHECK(yoshida::rises(fit({0, 1, 2, 3})));
  CHECK(yoshida::rises(fit({0, 1, 0.9, 3})));  // derivative 3 (1, -0.1, 2.1): positive
  CHECK_FALSE(yoshida::rises(fit({0, 2, -2, 3})));
  CHECK_FALSE(yoshida::rises(fit({0, -0.1, 2, 3})));
  CHECK_FALSE(yoshida::rises(fit({3, 2, 1, 0})));
  CHECK(yoshida::monotone(fit({3, 2, 1, 0})));
  CHECK(yoshida::monotone(fit({1, 1, 1, 1})));
  CHECK_FALSE(yoshida::monotone(fit({0, 2, -2, 3})));
  // Against exact isolation of the derivative's roots.
  RandomSource random(5);
  for (int i = 0; i < 500; ++i) {
    std::vector<double> controls{0.0};
    for (int k = 1; k < 4; ++k) controls.push_back(controls.back() + random.uniform(-0.5, 1.0));
    const intrinsic::HermiteFit any = fit(controls);
    CHECK(yoshida::rises(any) == (intrinsic::verdict_of(*any.curve).trend == intrinsic::Trend::rising));
  }
  auto unsolved = fit({0, 1, 2, 3});
  unsolved.outcome = Outcome::not_converged;
  CHECK_FALSE(yoshida::rises(unsolved));
  CHECK_FALSE(yoshida::monotone(unsolved));
}
