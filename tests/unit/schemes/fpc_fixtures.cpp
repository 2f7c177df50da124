// Numbers computed with 30 to 40 digits, and what the three conditions of each type say about a single segment.

#include "schemes/curve/exact_curvature.hpp"
#include "schemes/fpc/condition.hpp"
#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"
#include "tests/unit/schemes/fpc_inputs.hpp"

using namespace kappabench;
using namespace kappabench::fpc;
using namespace kappabench::test;

namespace {

void check_coefficients(const PointTask& task, const std::array<double, 6>& expected) {
  const std::array<double, 6> got = joint_coefficients(task);
  for (std::size_t i = 0; i < 6; ++i) CHECK(got[i] == Approx(expected[i]).epsilon(1e-14));
}

PolynomialSegment segment_of(const LocalCubic& cubic, const Vec2& x, const Vec2& y) {
  return PolynomialSegment(
      std::array<Vec2, 4>{x, x + cubic.start_velocity(x, y) / 3.0, y - cubic.end_velocity(x, y) / 3.0, y});
}

}  // namespace

TEST_CASE("fpc: Appendix B gives the fixtures' coefficients") {
  check_coefficients({.type = PointType::cusp, .t = 0.4},
                     {2.25, -4.333333333333333, -6.0, 0.4444444444444444, -2.083333333333333, -5.555555555555556});
  check_coefficients({.type = PointType::inflection, .t = 0.35, .h = 0.5},
                     {-3.089370345294516, -5.097703244622676, -3.193635748138118, 0.8395916879329202,
                      -8.187073589917192, -2.354044060205198});
  check_coefficients({.type = PointType::regular, .t = 0.45},
                     {-1.11967115857276, -2.886831703765342, -3.306127637935418, -0.7620137299771167,
                      -4.006502862338102, -4.068141367912535});
  check_coefficients({.type = PointType::loop, .t = 0.25, .t1 = 0.25, .t2 = 0.6},
                     {2.0, -4.833333333333333, -6.666666666666667, 0.5, -2.833333333333333, -6.166666666666667});
}

TEST_CASE("fpc: a segment passes its point with the feature asked for, and no other") {
  Random random(5);
  for (int trial = 0; trial < 400; ++trial) {
    PointTask task{.type = all_types[static_cast<std::size_t>(trial % 4)], .t = random.uniform(0.05, 0.95)};
    task.t1 = random.uniform(0.3, 0.9) * task.t;
    task.t2 = task.t + random.uniform(0.1, 0.7) * (1.0 - task.t);
    task.h = (task.t <= 0.5 ? 1.0 : -1.0) * random.uniform(0.5, 3.0);
    const Vec2 x(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    const Vec2 y(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    if (std::abs(cross(x, y)) < 0.01) continue;
    const LocalCubic cubic(task);
    const PolynomialSegment segment = segment_of(cubic, x, y);
    const bool loop = task.type == PointType::loop;
    INFO(name(task.type) << " t = " << task.t);
    double extent = 1.0;
    for (const Vec2& q : segment.control_points()) extent = std::max(extent, q.norm());
    CHECK(segment.jet(loop ? task.t1 : task.t, 0).position().norm() < 1e-13 * extent);
    if (loop) CHECK(segment.jet(task.t2, 0).position().norm() < 1e-13 * extent);
    // The curvature's numerator at both ends is the promised multiple of the area.
    const Jet start = segment.jet(0.0, 2), end = segment.jet(1.0, 2);
    const double square = extent * extent * 1e-12;
    CHECK(std::abs(0.5 * cross(start.d[1], start.d[2]) - cubic.start_numerator * cross(x, y)) < square);
    CHECK(std::abs(0.5 * cross(end.d[1], end.d[2]) - cubic.end_numerator * cross(x, y)) < square);

    const SignChanges changes = inflections(segment);
    const std::vector<double> reversals = cusps(segment);
    // Rounding of the control points may split the double root at a cusp.
    const bool cusp = task.type == PointType::cusp;
    CHECK(changes.at.size() % 2 == (task.type == PointType::inflection ? 1U : 0U));
    for (const RootBracket& at : changes.at) CHECK(at.mid() == Approx(task.t).epsilon(cusp ? 1e-5 : 1e-9));
    if (!cusp) CHECK(changes.at.size() <= 1);
    CHECK(reversals.size() == (task.type == PointType::cusp ? 1U : 0U));
    if (!reversals.empty()) CHECK(reversals.front() == Approx(task.t).epsilon(1e-6));
    if (task.type == PointType::regular) {
      // Eq. (12): F(-1) = 0; Eq. (13): the axis of F at the point.
      const auto numerator = [&](double t) {
        const Jet jet = segment.jet(t, 2);
        return cross(jet.d[1], jet.d[2]);
      };
      const double scale = std::abs(numerator(task.t));
      CHECK(std::abs(numerator(-1.0)) < 1e-9 * scale);
      CHECK(std::abs(numerator(2.0 * task.t + 1.0)) < 1e-9 * scale);
    }
  }
}

TEST_CASE("fpc: the closed curve of five regular points") {
  const CubicChain chain = chain_of(five_points());
  const std::array t{0.4340578300578996, 0.5, 0.5334828131703736, 0.5, 0.5327485830028734};
  for (std::size_t k = 0; k < 5; ++k) CHECK(chain.cubic[k].task.t == Approx(t[k]).epsilon(1e-15));
  const System system(chain);

  State first;
  REQUIRE(system.solve_joints(std::vector<double>(5, 0.0), first));
  const std::array<Vec2, 5> start{Vec2(-0.8666740376134697, 1.401455732544191),
                                  {2.098192669842461, -1.073668480975621},
                                  {4.995068042572301, 0.7269977725684636},
                                  {3.796408652242923, 4.361237182260807},
                                  {0.2316423812619181, 4.401333085457941}};
  for (std::size_t k = 0; k < 5; ++k)
    CHECK((five_points().points[k] + chain.unit * first.x[k] - start[k]).norm() < 1e-14);

  const Fit result = fit("fpc", five_points());
  REQUIRE(result.report.outcome == Outcome::converged);
  CHECK(result.report.residual < 1e-12);
  const std::array<Vec2, 5> joints{Vec2(-0.8012464647372274, 1.292357918031037),
                                   {1.787840658631086, -0.9829846043748101},
                                   {5.085581089326858, 0.8365344698222421},
                                   {3.718078365391263, 4.380887938004607},
                                   {0.2720241361439181, 4.442007317169164}};
  const std::array lambda{0.7112000288186719, 1.155995867096324, 1.103732869783994, 0.9394582067358264,
                          1.169086756480461};
  for (int k = 0; k < 5; ++k) {
    const auto here = static_cast<std::size_t>(k);
    CHECK((result.curve->segment(k).jet(0.0, 0).position() - joints[here]).norm() < 1e-14);
    const double ratio =
        speed(result.curve->segment(k).jet(1.0, 1)) / speed(result.curve->segment(result.curve->next(k)).jet(0.0, 1));
    CHECK(ratio == Approx(lambda[here]).epsilon(1e-13));
  }
}

TEST_CASE("fpc: an inflection with t = 0.618 and h = 1/2 is singular, and so are some joint systems") {
  CHECK(singular_h(0.6180339887498949) == Approx(0.5).epsilon(1e-15));
  for (const double t : {0.1, 0.3, 0.45, 0.55, 0.8}) CHECK(admissible_h(t, singular_h(t)));
  const PointTask near{.type = PointType::inflection, .t = 0.6180339887498949, .h = 0.5};
  CHECK(std::abs(joint_coefficients(near)[0]) > 1e12);

  // Three inflections with h = 1/2 on a triangle, at the lambdas that make the joints' system singular.
  const std::array edges{1.22014622, 1.12488513, 1.00859008};  // |v3 v1|, |v1 v2|, |v2 v3|
  const double x = (edges[0] * edges[0] + edges[1] * edges[1] - edges[2] * edges[2]) / (2.0 * edges[1]);
  Input input{.points = {{0, 0}, {edges[1], 0}, {x, std::sqrt(edges[0] * edges[0] - x * x)}},
              .closed = true,
              .options = {},
              .ids = {}};
  input.options.resize(3);
  for (PointOptions& options : input.options) options.type = PointType::inflection;
  const CubicChain as_given = chain_of(input, {.h_sign_by_rule = false}), by_rule = chain_of(input);
  const std::array t{0.52031126, 0.52725484, 0.45253899};
  for (std::size_t k = 0; k < 3; ++k) CHECK(as_given.cubic[k].task.t == Approx(t[k]).epsilon(1e-7));
  const std::array log_ratio{std::log(3.3569898250224233), std::log(1.25357562), std::log(9.15856176)};
  CHECK(joint_condition(as_given, log_ratio) > 1e8);
  CHECK(joint_condition(by_rule, log_ratio) < 1e3);
}
