// The experiments on FPC-curves: what they conclude, and that they conclude otherwise from other data.

#include <cmath>
#include <cstdlib>
#include <set>

#include "datasets/datasets.hpp"
#include "experiments/papers/fpc-2019-chen/feature_check.hpp"
#include "experiments/papers/fpc-2019-chen/inputs.hpp"
#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"
#include "tests/integration/experiment_records.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

const std::vector<std::string> experiments{"fpc-features",     "fpc-loops",   "fpc-convergence",   "fpc-loop-size",
                                           "fpc-inflection-h", "fpc-gallery", "fpc-point-economy", "fpc-locality"};

/// Tables, figures and claims of an experiment. Without data a claim is undecided, but for those that ask no cell.
void check_conclusions(const store::ExperimentRecord& record, std::multiset<std::string>& judged) {
  check_same_conclusions(concluded(record), record);
  check_filled(record);
  for (const store::ClaimRecord& claim : record.claims) {
    CHECK(claim.paper == "fpc-2019-chen");
    CHECK_FALSE(claim.ours.empty());
    judged.insert(claim.claim);
  }
  store::ExperimentRecord empty{.id = record.id};
  for (const store::ClaimRecord& claim : concluded(empty).claims)
    if (claim.claim != "h-range" && claim.claim != "twelve-points") CHECK(claim.verdict == "undecided");
}

/// A claim whose verdict another value in a column turns. An empty `before` is the study's to find.
struct Turn {
  std::string experiment, claim, column;
  double value;
  std::string before, after;
};

const std::vector<Turn> turns{
    {"fpc-features", "cusps-and-loops-at-points", "not at a point of that type", 1, "reproduced", "contradicted"},
    {"fpc-features", "inflections-at-points-or-joints", "not at a point of that type", 1, "reproduced", "contradicted"},
    {"fpc-features", "points-have-their-type", "missing", 1, "reproduced", "contradicted"},
    {"fpc-features", "points-have-their-type", "solved", 0, "reproduced", "contradicted"},
    {"fpc-gallery", "g2-almost-everywhere", "kept", 0, "reproduced", "contradicted"},
    {"fpc-loops", "three-points-two-loops", "loops_at_nodes", 1, "reproduced", "undecided"},
    {"fpc-loops", "spline-loops-away", "loops_at_nodes", 2, "reproduced", "undecided"},
    {"fpc-loops", "kappa-needs-five", "with two loops", 1, "reproduced", "contradicted"},
    {"fpc-point-economy", "twelve-points", "loops", 11, "by construction", "by construction"},
    {"fpc-loop-size", "loop-size", "length", 0, "reproduced", "contradicted"},
    {"fpc-inflection-h", "h-sign", "bends the other way", 0, "not reproduced", "contradicted"},
    {"fpc-inflection-h", "h-sign", "bends the other way", 1, "not reproduced", "reproduced"},
    {"fpc-inflection-h", "h-size", "stretch", 0, "", "contradicted"},
    {"fpc-inflection-h", "h-size", "stretch", 2, "", "reproduced"},
    {"fpc-inflection-h", "joint-system-regular", "no singular system", 0, "reproduced", "contradicted"},
    {"fpc-convergence", "step-15", "error factor a step", 0.9, "reproduced", "contradicted"},
    {"fpc-convergence", "step-50", "relative mismatch", 1e-6, "reproduced", "not reproduced"},
    {"fpc-convergence", "dozens-of-iterations", "steps to 1e-10", std::nan(""), "reproduced", "contradicted"},
    {"fpc-locality", "local-influence", "decay", 0.1, "", "reproduced"},
    {"fpc-locality", "local-influence", "decay", 0.9, "", "contradicted"},
};

}  // namespace

TEST_CASE("fpc experiments: tables, figures, one verdict for every claim of the paper, and verdicts follow the data") {
  std::multiset<std::string> judged;
  for (const std::string& id : experiments) {
    INFO(id);
    const store::ExperimentRecord record = concluded(computed(id));
    check_conclusions(record, judged);
    for (const Turn& turn : turns) {
      if (turn.experiment != id) continue;
      INFO(turn.claim);
      if (!turn.before.empty()) CHECK(verdict(record, turn.claim) == turn.before);
      store::ExperimentRecord turned = record;
      set_column(turned, turn.column, turn.value);
      CHECK(verdict(concluded(turned), turn.claim) == turn.after);
    }
  }
  check_each_claim_is_judged_once("fpc-2019-chen", judged);
}

TEST_CASE("fpc experiments: the check of features finds what is wrong") {
  // A cubic with a loop, said to be of a regular point, and one with a cusp said to be an inflection.
  const auto fit_of = [](const std::array<Vec2, 4>& control, PointType type, const Vec2& point, double t) {
    Input input{.points = {control[0], point, control[3]}, .closed = false, .options = {}, .ids = {}};
    input.options.resize(3);
    input.options[1].type = type;
    return Fit{
        input,
        Curve({std::make_shared<const PolynomialSegment>(control)}, {}, {{.point = 1, .segment = 0, .t = t}}, false),
        {.outcome = Outcome::converged}};
  };
  const std::array<Vec2, 4> loop{Vec2(0, 0), Vec2(4, 3), Vec2(-3, 3), Vec2(1, 0)};
  const chen::FeatureCheck crossed = chen::check_features(fit_of(loop, PointType::regular, {0.5, 2.25}, 0.5));
  CHECK(crossed.misplaced_loops == 1);
  CHECK_FALSE(crossed.holds());
  const std::array<Vec2, 4> cusp{Vec2(0, 0), Vec2(1, 1), Vec2(0, 1), Vec2(1, 0)};
  const chen::FeatureCheck pointed = chen::check_features(fit_of(cusp, PointType::inflection, {0.5, 0.75}, 0.5));
  CHECK(pointed.misplaced_cusps == 1);
  CHECK(pointed.missing == 1);
  CHECK(chen::check_features(fit_of(cusp, PointType::cusp, {0.5, 0.75}, 0.5)).holds());
  const std::array<Vec2, 4> wave{Vec2(0, 0), Vec2(1, 1), Vec2(2, -1), Vec2(3, 0)};
  CHECK(chen::check_features(fit_of(wave, PointType::inflection, {1.5, 0.0}, 0.5)).holds());
  CHECK(chen::check_features(fit_of(wave, PointType::regular, {1.5, 0.0}, 0.5)).misplaced_inflections == 1);
}

// KAPPABENCH_FPC_INPUTS=10000 runs the full count, KAPPABENCH_FPC_SEED another sequence.
TEST_CASE("fpc: random typed inputs are solved and have their features where they should be") {
  const char* count = std::getenv("KAPPABENCH_FPC_INPUTS");
  const char* from = std::getenv("KAPPABENCH_FPC_SEED");
  const std::uint64_t inputs = count == nullptr ? 500 : std::strtoull(count, nullptr, 10);
  const std::uint64_t seed = from == nullptr ? 20191 : std::strtoull(from, nullptr, 10);
  const SchemePtr tested = scheme("fpc");
  std::uint64_t solved = 0;
  chen::FeatureCheck total;
  for (std::uint64_t i = 0; i < inputs; ++i) {
    const Fit fit = tested->fit(chen::typed_random_input(seed, i));
    if (fit.report.outcome != Outcome::converged) {
      WARN("input " << i << ": " << fit.report.message);
      continue;
    }
    ++solved;
    CHECK(fit.report.residual <= 1e-12);
    const chen::FeatureCheck check = chen::check_features(fit);
    INFO("input " << i << ": " << check.first);
    CHECK(check.holds());
    total.cusps += check.cusps;
    total.loops += check.loops;
    total.inflections += check.inflections;
    total.typed += check.typed;
    total.thin_loops += check.thin_loops;
  }
  WARN("solved " << solved << " of " << inputs << "; " << total.cusps << " cusps, " << total.loops << " loops, "
                 << total.inflections << " inflections in segments, " << total.typed << " typed points, "
                 << total.thin_loops << " thin loops");
  CHECK(static_cast<double>(solved) >= 0.99 * static_cast<double>(inputs));
}

TEST_CASE("fpc: random typed inputs depend on their arguments alone, and have all types") {
  std::set<PointType> types;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Input a = chen::typed_random_input(3, i), b = chen::typed_random_input(3, i);
    CHECK(a.points == b.points);
    CHECK(a.options == b.options);
    CHECK(a.size() >= 4);
    CHECK(a.size() <= 12);
    if (!a.closed) CHECK_FALSE(a.options.front().type.has_value());
    for (const PointOptions& options : a.options)
      if (options.type) types.insert(*options.type);
  }
  CHECK(types.size() == 4);
}
