// What the scheme reads from points and options, and what it refuses.

#include "schemes/curve/exact_curvature.hpp"
#include "tests/catch.hpp"
#include "tests/unit/schemes/fpc_inputs.hpp"

using namespace kappabench;
using namespace kappabench::fpc;
using namespace kappabench::test;

namespace {

Input arch(const PointOptions& middle) {
  return {.points = {{0, 0}, {1, 2}, {3, 1}}, .closed = false, .options = {{}, middle, {}}, .ids = {}};
}

PointTask only_task(const PointOptions& options, const Defaults& defaults = {}) {
  const Tasks read = read_tasks(arch(options), defaults);
  REQUIRE(read.problem.empty());
  REQUIRE(read.tasks.size() == 1);
  return read.tasks.front();
}

std::string refused(const std::string& scheme, const Input& input) {
  const Fit result = fit(scheme, input);
  CHECK(result.report.outcome == Outcome::unsupported_input);
  CHECK_FALSE(result.curve.has_value());
  CHECK(result.report.message.find('\n') == std::string::npos);
  return result.report.message;
}

}  // namespace

TEST_CASE("fpc: parameters come from chord lengths") {
  const Input even{.points = {{0, 0}, {1, 0}, {1, 3}}, .closed = false, .options = {}, .ids = {}};
  const Tasks read = read_tasks(even, {});
  REQUIRE(read.tasks.size() == 1);
  CHECK(read.tasks[0].t == 0.25);
  CHECK(read.tasks[0].type == PointType::regular);
}

TEST_CASE("fpc: a loop's size is its own, the scheme's, or half of what fits") {
  const double t = 0.5;  // both chords have length sqrt(5)
  const PointTask by_default = only_task({.type = PointType::loop});
  CHECK(by_default.t1 == Approx(t - 0.25));
  CHECK(by_default.t2 == Approx(t + 0.25));
  const PointTask common = only_task({.type = PointType::loop}, {.alpha = 0.1, .beta = 0.2});
  CHECK(common.t1 == Approx(t - 0.1));
  CHECK(common.t2 == Approx(t + 0.2));
  const PointTask own = only_task({.type = PointType::loop, .alpha = 0.4}, {.alpha = 0.1, .beta = 0.2});
  CHECK(own.t1 == Approx(t - 0.4));
  CHECK(own.t2 == Approx(t + 0.2));
}

TEST_CASE("fpc: the sign of h follows the rule unless someone says otherwise") {
  Input late{.points = {{0, 0}, {3, 0.5}, {3.5, 2}}, .closed = false, .options = {{}, {}, {}}, .ids = {}};
  late.options[1].type = PointType::inflection;  // t = 0.66
  CHECK(read_tasks(late, {.h = 0.7}).tasks.front().h == -0.7);
  CHECK(read_tasks(late, {.h = 0.7, .h_sign_by_rule = false}).tasks.front().h == 0.7);
  late.options[1].h = 0.9;
  CHECK(read_tasks(late, {.h = 0.7}).tasks.front().h == 0.9);
  CHECK(only_task({.type = PointType::inflection}).h == 0.5);
}

TEST_CASE("fpc: what cannot be is refused with its reason") {
  CHECK_THAT(refused("fpc", arch({.type = PointType::loop, .alpha = 0.6})), ContainsSubstring("alpha = 0.6"));
  CHECK_THAT(refused("fpc:beta=0.7", arch({.type = PointType::loop})), ContainsSubstring("beta = 0.7"));
  CHECK_THAT(refused("fpc", arch({.type = PointType::inflection, .h = 0.1})), ContainsSubstring("second inflection"));
  Input end = arch({});
  end.options[2].type = PointType::cusp;
  CHECK_THAT(refused("fpc", end), ContainsSubstring("end of an open curve"));

  // t = (sqrt(5) - 1) / 2: the arriving chord is the golden ratio times the leaving one.
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  Input singular{.points = {{0, 0}, {golden, 0}, {golden, 1}}, .closed = false, .options = {{}, {}, {}}, .ids = {}};
  singular.options[1].type = PointType::inflection;
  CHECK(fit("fpc", singular).report.outcome == Outcome::converged);
  CHECK_THAT(refused("fpc:h_sign=given", singular), ContainsSubstring("singular"));
  singular.options[1].h = 0.5;
  CHECK_THAT(refused("fpc", singular), ContainsSubstring("singular"));
  singular.options[1].h = 0.51;
  CHECK(fit("fpc", singular).report.outcome == Outcome::converged);
}

TEST_CASE("fpc: an open curve starts at three points, a closed one too") {
  const Fit open = fit("fpc", arch({.type = PointType::cusp}));
  REQUIRE(open.report.outcome == Outcome::converged);
  CHECK(open.curve->size() == 1);
  CHECK(open.curve->joints().empty());
  CHECK(cusps(open.curve->segment(0)).size() == 1);
  for (const PointType type : all_types) {
    Input triangle{.points = {{0, 0}, {3, 0}, {1, 2}}, .closed = true, .options = {}, .ids = {}};
    triangle.options.assign(3, PointOptions{.type = type});
    INFO(name(type));
    CHECK(fit("fpc", triangle).report.outcome == Outcome::converged);
  }
  CHECK_THAT(refused("fpc", {.points = {{0, 0}, {1, 0}}, .closed = true, .options = {}, .ids = {}}),
             ContainsSubstring("at least 3"));
}

TEST_CASE("fpc: points on one line") {
  Input line{.points = {{0, 0}, {1, 1}, {3, 3}, {4, 4}}, .closed = false, .options = {}, .ids = {}};
  const Fit straight = fit("fpc", line);
  REQUIRE(straight.report.outcome == Outcome::converged);
  for (const Jet& jet : sample(*straight.curve, 5, 2).jets) {
    CHECK(std::abs(jet.position().x() - jet.position().y()) < 1e-15);
    CHECK(curvature(jet) == 0.0);
  }
  line.options = {{}, {.type = PointType::loop}, {}, {}};
  CHECK_THAT(refused("fpc", line), ContainsSubstring("on one line"));
  Input back{.points = {{0, 0}, {2, 2}, {1, 1}, {4, 4}}, .closed = false, .options = {}, .ids = {}};
  CHECK_THAT(refused("fpc", back), ContainsSubstring("turn back"));
}
