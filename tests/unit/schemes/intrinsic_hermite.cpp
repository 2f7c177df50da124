// Hermite interpolation by B-spline curvature: fixtures, derivatives, random data, the viable region.
#include <algorithm>
#include <array>
#include <boost/math/differentiation/autodiff.hpp>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "schemes/intrinsic/edit.hpp"
#include "schemes/intrinsic/fixed_knots.hpp"
#include "schemes/intrinsic/monotone_family.hpp"
#include "schemes/intrinsic/sampling.hpp"
#include "schemes/intrinsic/simplex.hpp"
#include "schemes/intrinsic/solve.hpp"
#include "schemes/intrinsic/viable_region.hpp"
#include "schemes/segments/intrinsic.hpp"
#include "tests/catch.hpp"
#include "tests/sanitized.hpp"

using namespace kappabench;
using namespace kappabench::intrinsic;
using std::numbers::pi;

namespace {

class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : generator_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 generator_;
};

/// How many random data a test takes: a few, or as many as KAPPABENCH_INTRINSIC_SEEDS says.
int random_count(int few) {
  const char* const wish = std::getenv("KAPPABENCH_INTRINSIC_SEEDS");
  return wish ? std::atoi(wish) : test::cases(few);
}

FixedKnots g1_knots(int degree, int controls, double p = 0.0) {
  const BSplineBasis basis = uniform_basis(degree, controls);
  return {basis, interpolated(basis, 0, controls - 1, p)};
}

constexpr double theta_e = pi / 9, theta_d = pi / 3;  ///< of Yoshida 2022, Figs. 6 to 8

}  // namespace

TEST_CASE("intrinsic: G1 fixtures, S-shaped ones too") {
  struct Fixture {
    double chord_angle, turning, first, last, length;
  };
  for (const Fixture& f : {Fixture{theta_e, theta_d, 0.01865202158062864, 1.975653886983914, 1.050187482972808},
                           Fixture{0.4, 0.0, 2.358321172971322, -2.358321172971322, 1.01611592013541},
                           Fixture{0.4, 0.2, 1.976110898453501, -1.580345384954768, 1.010699483297147},
                           Fixture{-0.3, 0.9, -3.220806834840579, 4.870202990040898, 1.091308473300879}})
    for (const auto& [degree, controls] : {std::pair{1, 2}, {3, 4}, {3, 6}}) {
      const StandardData data{f.chord_angle, f.turning, {}, {}};
      const HermiteFit fit = solve(data, {.basis = uniform_basis(degree, controls)});
      REQUIRE(fit.outcome == Outcome::converged);
      CHECK(fit.curve->controls.front() == Approx(f.first).epsilon(1e-13));
      CHECK(fit.curve->controls.back() == Approx(f.last).epsilon(1e-14));
      CHECK(fit.curve->length == Approx(f.length).epsilon(1e-14));
      CHECK(fit.residual <= 1e-14);
      CHECK(verdict_of(*fit.curve).trend == (f.last > f.first ? Trend::rising : Trend::falling));
    }
}

TEST_CASE("intrinsic: G2 fixture on fixed knots is not monotone, the automatic one is") {
  const StandardData data{theta_e, theta_d, 0.3, 2.2};
  const HermiteFit fixed = solve(data, {.automatic = false});
  REQUIRE(fixed.outcome == Outcome::converged);
  const std::array expected{0.3, 0.1674920640780612, 0.6146620426473796, 1.285417010501357, 1.732586989070676, 2.2};
  for (std::size_t i = 0; i < 6; ++i) CHECK(fixed.curve->controls[i] == Approx(expected[i]).epsilon(1e-12));
  CHECK(fixed.curve->length == Approx(1.047163058889495).epsilon(1e-14));
  CHECK(verdict_of(*fixed.curve).trend == Trend::not_monotone);
  CHECK(verdict_of(*fixed.curve).extrema == 1);

  const HermiteFit automatic = solve(data);
  REQUIRE(automatic.outcome == Outcome::converged);
  CHECK(automatic.residual <= 1e-14);
  CHECK(automatic.curve->length == Approx(1.0447610569786732).epsilon(1e-14));
  const std::array knots{0.33452596300686327, 0.54178711316258199, 0.68879293528929708, 0.83886490783987666};
  for (std::size_t i = 0; i < 4; ++i) CHECK(automatic.curve->basis.knots[3 + i] == Approx(knots[i]).epsilon(1e-13));
  const std::array controls{0.3,
                            0.34943204917024939,
                            0.49867488794507444,
                            0.83227425386864351,
                            1.3073865844578383,
                            1.7597570948059311,
                            2.0794227229741651,
                            2.2};
  for (std::size_t i = 0; i < 8; ++i) CHECK(automatic.curve->controls[i] == Approx(controls[i]).epsilon(1e-12));
  CHECK(verdict_of(*automatic.curve).trend == Trend::rising);
}

TEST_CASE("intrinsic: infeasible data are recognised and explained") {
  CHECK(least_end_curvature(theta_e, theta_d, 0.3) == Approx(1.599643202916917).epsilon(1e-15));
  const auto refused = [](double start, double end, const char* why) {
    const HermiteFit fit = solve({theta_e, theta_d, start, end});
    CHECK(fit.outcome == Outcome::unsupported_input);
    CHECK_FALSE(fit.curve);
    CHECK_THAT(fit.message, Catch::Matchers::Contains(why));
  };
  refused(0.3, 1.55, "do not nest: xi = ");
  refused(0.9, 2.2, "starts below");
  refused(0.3, 1.0, "ends above");
  const double arc = 2.0 * std::sin(0.4);
  CHECK(solve({0.4, 0.8, arc, arc}).outcome == Outcome::converged);
  CHECK(solve({0.4, 0.8, arc, arc + 0.1}).outcome == Outcome::unsupported_input);
  CHECK_THAT(solve({0.4, 0.8, arc, arc + 0.1}).message, Catch::Matchers::Contains("circular arc"));
  // The viable side of the border, closer and closer: the curvature becomes a step, and stays a solution.
  for (const double above : {1e-2, 1e-5, 1e-8}) {
    const HermiteFit fit = solve({theta_e, theta_d, 0.3, 1.599643202916917 * (1.0 + above)});
    INFO(above << ": " << fit.message);
    CHECK(fit.outcome == Outcome::converged);
    CHECK(verdict_of(*fit.curve).trend == Trend::rising);
  }
}

TEST_CASE("intrinsic: derivatives of the fixed-knot equations agree with autodiff") {
  using boost::math::differentiation::make_ftuple;
  const BSplineBasis basis = uniform_basis(3, 6);
  ControlRule rule = interpolated(basis, 1, 4, 0.3);
  fix(rule, 0, 0.4);
  fix(rule, 5, 2.5);
  const RuleTable table(angle_table(basis, 1), rule);
  const StandardData data{0.3, 1.1, 0.4, 2.5};
  for (const Eigen::Vector3d& u : {Eigen::Vector3d(0.5, 2.0, 0.1), Eigen::Vector3d(-2.0, 3.0, 0.4)}) {
    const auto variables = make_ftuple<double, 1, 1, 1>(u[0], u[1], u[2]);
    const auto& x = std::get<0>(variables);
    const auto& y = std::get<1>(variables);
    const auto length = exp(std::get<2>(variables));
    auto across = 0.0 * x * y * length, along = across;
    for (Eigen::Index i = 0; i < table.weights.size(); ++i) {
      const auto angle =
          length * (x * table.first[i] + y * table.last[i] + 0.7 * table.fixed[i]) - 0.7 * data.chord_angle;
      across += table.weights[i] * sin(angle);
      along += table.weights[i] * cos(angle);
    }
    const auto turning = length * (x * table.first_total + y * table.last_total + 0.7 * table.fixed_total);
    const ThreeEquations e = fixed_equations(table, data, 0.7, u);
    const auto check = [&](int row, const auto& expected, double offset) {
      CHECK(e.value[row] == Approx(static_cast<double>(expected) - offset).margin(1e-15));
      CHECK(e.jacobian(row, 0) == Approx(expected.derivative(1, 0, 0)).margin(1e-14));
      CHECK(e.jacobian(row, 1) == Approx(expected.derivative(0, 1, 0)).margin(1e-14));
      CHECK(e.jacobian(row, 2) == Approx(expected.derivative(0, 0, 1)).margin(1e-14));
    };
    check(0, turning, 0.7 * data.turning);
    check(1, length * across, 0.0);
    check(2, length * along, 1.0);
  }
}

TEST_CASE("intrinsic: the family's derivatives agree with differences, and its members are what the segment is") {
  const StandardData data{0.3, 1.2, 0.1, 4.0};
  for (const FamilyMember& at : {FamilyMember{0.1, 0.0, 0.0}, {0.05, 1.3, 0.7}, {0.2, -2.0, -0.4}, {0.0, 3.0, 2.0}}) {
    INFO("y = " << at.y << ", z = " << at.z);
    const ThreeEquations e = member_equations(at, data);
    constexpr double h = 1e-6;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(k);
      const auto moved = [&](double sign) {
        return member_equations({at.log_length + sign * step[0], at.y + sign * step[1], at.z + sign * step[2]}, data);
      };
      const Eigen::Vector3d slope = (moved(1.0).value - moved(-1.0).value) / (2.0 * h);
      CHECK((slope - e.jacobian.col(k)).norm() <= 1e-8 * (1.0 + slope.norm()));
    }
    const StandardCurve curve = member_curve(at, 0.1, 4.0);
    CHECK(std::ranges::is_sorted(curve.controls));
    const Jet end = IntrinsicSegment(placed(curve, {{{0, 0}, -data.chord_angle, {}}, {{1, 0}, 0.0, {}}})).jet(1.0, 1);
    CHECK(e.value[1] == Approx(end.position().y()).margin(1e-14));
    CHECK(e.value[2] == Approx(end.position().x() - 1.0).margin(1e-14));
    CHECK(std::abs(std::remainder(tangent_angle(end) - data.end_angle() - e.value[0], 2.0 * pi)) <= 1e-13);
  }
  // a = 1, z = 0: linear curvature.
  const StandardCurve clothoid = member_curve({0.0, 0.0, 0.0}, -1.0, 3.0);
  const std::vector<double> x = greville_abscissae(clothoid.basis);
  for (std::size_t i = 0; i < x.size(); ++i) CHECK(clothoid.controls[i] == Approx(-1.0 + 4.0 * x[i]).margin(1e-14));
}

TEST_CASE("intrinsic: G1 data of any angles are solved, and p keeps them monotone") {
  Uniform uniform(11);
  const int count = random_count(2000);
  struct Family {
    int degree, controls;
    double p;
  };
  for (const Family& f :
       {Family{1, 2, 0}, {2, 3, 0}, {3, 4, 0}, {3, 6, 0}, {3, 6, -1}, {3, 6, 0.5}, {3, 6, 1}, {3, 8, 0}}) {
    const FixedKnots knots = g1_knots(f.degree, f.controls, f.p);
    int missed = 0, bent = 0;
    double worst = 0.0;
    for (int i = 0; i < count; ++i) {
      // Alternately the region of Yoshida 2022, Eq. (12), and angles to .95 pi on either side.
      const double a = uniform(-0.95 * pi, 0.95 * pi), b = uniform(-0.95 * pi, 0.95 * pi);
      const double e = uniform(0.0, 0.5 * pi), inner = uniform(e, 0.5 * pi);
      const StandardData data = i % 2 == 0 ? StandardData{e, e + inner, {}, {}} : StandardData{a, a + b, {}, {}};
      const Solved solved = knots.solve(data);
      if (!solved.converged) {
        ++missed;
        UNSCOPED_INFO("chord angle " << data.chord_angle << ", turning " << data.turning);
        continue;
      }
      const StandardCurve curve = knots.curve(solved);
      worst = std::max(worst, gap(curve, data));
      const auto& k = curve.controls;
      bent += std::ranges::is_sorted(k) || std::ranges::is_sorted(k, std::greater<>()) ? 0 : 1;
    }
    INFO("degree " << f.degree << ", " << f.controls << " controls, p = " << f.p);
    CHECK(missed == 0);
    CHECK(bent == 0);
    CHECK(worst <= 1e-13);
  }
}

TEST_CASE("intrinsic: viable G2 data of nine classes have a monotone solution") {
  Uniform uniform(12);
  const int count = random_count(150);
  const auto angles = [&](int kind) -> std::array<double, 2> {
    const double near = uniform(0.0, 0.5 * pi);
    switch (kind) {
      case 0:
        return {uniform(0.0, 0.5 * pi), uniform(0.0, 0.5 * pi)};
      case 1:  // S-shapes
        return {uniform(-0.5 * pi, 0.0), uniform(0.0, 0.5 * pi)};
      case 2:  // mirrored
        return {uniform(-0.5 * pi, 0.0), uniform(-0.5 * pi, 0.0)};
      case 3:  // near-symmetric
        return {near, near + uniform(-1e-3, 1e-3)};
      case 4:
        return {uniform(-0.95 * pi, 0.95 * pi), uniform(-0.95 * pi, 0.95 * pi)};
      case 5:
        return {uniform(-0.3, 0.3), uniform(-0.3, 0.3)};
      case 6:
        return {uniform(0.0, 0.95 * pi), uniform(0.0, 0.95 * pi)};
      case 7:
        return {uniform(-0.95 * pi, 0.0), uniform(0.0, 0.95 * pi)};
      default:
        return {uniform(-1e-4, 1e-4), uniform(-1e-4, 1e-4)};
    }
  };
  for (int kind = 0; kind < 9; ++kind) {
    int missed = 0, bent = 0;
    for (int i = 0; i < count; ++i) {
      const auto [start, end] = angles(kind);
      // xi - 1 from 1e-6 to 1e3, X / Y from 0.02 to 50.
      const double half = std::sin(0.5 * (end - start)), way = end > start ? 1.0 : -1.0;
      const double slack = 2.0 * std::abs(half) * std::sqrt(1.0 + std::exp(uniform(std::log(1e-6), std::log(1e3))));
      const double balance = std::exp(uniform(-2.0, 2.0));
      const StandardData data{start, start + end, 2.0 * std::sin(start) - way * slack * balance,
                              2.0 * std::sin(end) + way * slack / balance};
      if (!viability(data).viable()) continue;  // a border case that rounding decided
      const HermiteFit fit = solve(data);
      if (fit.outcome != Outcome::converged) {
        ++missed;
        UNSCOPED_INFO("missed " << start << ", " << end << ", " << *data.start_curvature << ", "
                                << *data.end_curvature);
        continue;
      }
      const Trend trend = verdict_of(*fit.curve).trend;
      bent += trend == (end > start ? Trend::rising : Trend::falling) ? 0 : 1;
      CHECK(fit.curve->controls.front() == *data.start_curvature);
      CHECK(fit.curve->controls.back() == *data.end_curvature);
    }
    INFO("class " << kind);
    CHECK(missed == 0);
    CHECK(bent == 0);
  }
}

TEST_CASE("intrinsic: a grid over the viable region of Fig. 6 is covered") {
  const double most_start = 2.0 * std::sin(theta_e), least_end = 2.0 * std::sin(theta_d - theta_e);
  const int cells = std::getenv("KAPPABENCH_INTRINSIC_SEEDS") != nullptr ? 100 : 25;
  int viable = 0;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const StandardData data{theta_e, theta_d, most_start * (i + 0.5) / cells,
                              least_end + (20.0 - least_end) * (j + 0.5) / cells};
      if (!viability(data).viable()) continue;
      ++viable;
      const HermiteFit fit = solve(data);
      INFO(*data.start_curvature << ", " << *data.end_curvature);
      REQUIRE(fit.outcome == Outcome::converged);
      CHECK(fit.residual <= 1e-13);
      CHECK(std::ranges::is_sorted(fit.curve->controls));
    }
  CHECK(viable > cells * cells / 2);
}

TEST_CASE("intrinsic: the mirror image and the reverse of data have the mirrored and reversed solution") {
  const StandardData data{0.2, 1.3, -0.4, 5.0};
  const HermiteFit fit = solve(data);
  const HermiteFit other = solve(mirrored(data)), back = solve(reversed(data));
  REQUIRE(fit.outcome == Outcome::converged);
  CHECK(other.curve->controls == mirrored(*fit.curve).controls);
  CHECK(other.curve->basis.knots == fit.curve->basis.knots);
  for (std::size_t i = 0; i < 8; ++i)
    CHECK(back.curve->controls[i] == Approx(reversed(*fit.curve).controls[i]).epsilon(1e-13));
  CHECK(gap(mirrored(*fit.curve), mirrored(data)) <= 1e-14);
  CHECK(gap(reversed(*fit.curve), reversed(data)) <= 1e-14);
}

TEST_CASE("intrinsic: standard form and back") {
  const HermiteData data{{{3, -1}, 2.0, 0.2}, {{1, 4}, 1.5, 0.6}};
  const StandardData standard = standard_form(data);
  const double chord = std::sqrt(29.0);
  CHECK(*standard.start_curvature == Approx(0.2 * chord));
  CHECK(standard.turning == Approx(-0.5));
  const HermiteFit fit = solve(standard, {.automatic = false});
  REQUIRE(fit.outcome == Outcome::converged);
  const Jet end = IntrinsicSegment(placed(*fit.curve, data)).jet(1.0, 2);
  CHECK((end.position() - data.to.point).norm() <= 1e-13);
  CHECK(tangent_angle(end) == Approx(1.5).epsilon(1e-13));
  CHECK(curvature(end) == Approx(0.6).epsilon(1e-13));
}

TEST_CASE("intrinsic: the simplex finds what Newton finds, where Eq. (8) has a length") {
  Uniform uniform(13);
  for (int i = 0; i < 100; ++i) {
    const double e = uniform(0.05, 0.5 * pi), inner = uniform(e, 0.5 * pi);
    const StandardData data{e, e + inner, {}, {}};
    const FixedKnots knots = g1_knots(3, 6);
    const Solved newton = knots.solve(data), simplex = solve_by_simplex(knots, data);
    REQUIRE(newton.converged);
    REQUIRE(simplex.converged);
    CHECK(simplex.x == Approx(newton.x).margin(1e-9));
    CHECK(simplex.y == Approx(newton.y).margin(1e-9));
    CHECK(simplex.length == Approx(newton.length).margin(1e-9));
  }
  // S-shaped data that do not turn.
  const StandardData flat{0.4, 0.0, {}, {}};
  CHECK(solve(flat).outcome == Outcome::converged);
  CHECK(solve(flat, {.method = Method::simplex}).outcome != Outcome::converged);
}

TEST_CASE("intrinsic: interpolation of controls is Eqs. (10), (11) over Greville abscissae") {
  const BSplineBasis basis = uniform_basis(3, 6);
  // Weights of kappa_{i_m} for i_1 = 2, i_m = 5 counted from 1: 0, 2/7, 5/7, 1.
  const ControlRule linear = interpolated(basis, 1, 4, 0.0);
  const std::array expected{0.0, 0.0, 2.0 / 7, 5.0 / 7, 1.0, 0.0};
  for (int i = 0; i < 6; ++i) {
    CHECK(linear.last[i] == Approx(expected[static_cast<std::size_t>(i)]).margin(1e-15));
    CHECK(linear.first[i] == Approx(i == 0 || i == 5 ? 0.0 : 1.0 - linear.last[i]).margin(1e-15));
  }
  const ControlRule first = interpolated(basis, 0, 5, 1.0), last = interpolated(basis, 0, 5, -1.0);
  for (int i = 1; i < 5; ++i) {
    CHECK(first.last[i] == 0.0);
    CHECK(last.last[i] == 1.0);
  }
  ControlRule flat_ends = interpolated(uniform_basis(3, 4), 0, 3, 0.0);
  tie(flat_ends, 1, 0);
  tie(flat_ends, 2, 3);
  const FixedKnots knots(uniform_basis(3, 4), flat_ends);
  const StandardData data{theta_e, theta_d, {}, {}};
  const StandardCurve curve = knots.curve(knots.solve(data));
  CHECK(gap(curve, data) <= 1e-14);
  const IntrinsicSegment segment(placed(curve, {{{0, 0}, 0.0, {}}, {{1, 0}, 0.0, {}}}));
  for (const double t : {0.0, 1.0}) CHECK(std::abs(curvature_derivative(segment.jet(t, 3))) <= 1e-13);
}

TEST_CASE("intrinsic: a moved control curvature stays where it was put, the Hermite data too") {
  const StandardData data{theta_e, theta_d, {}, {}};
  const HermiteFit before = solve(data);
  const double moved_to = before.curve->controls[3] + 0.8;
  for (const Others others : {Others::kept, Others::interpolated}) {
    const std::array moved{MovedControl{3, moved_to}};
    const HermiteFit after = with_moved_controls(data, *before.curve, moved, others);
    REQUIRE(after.outcome == Outcome::converged);
    CHECK(after.curve->controls[3] == moved_to);
    CHECK(after.residual <= 1e-13);
    CHECK((after.curve->controls[2] == before.curve->controls[2]) == (others == Others::kept));
    CHECK(after.curve->controls[0] != before.curve->controls[0]);
  }
  const StandardData g2{theta_e, theta_d, 0.3, 2.2};
  const HermiteFit fixed = solve(g2, {.automatic = false});
  const std::array moved{MovedControl{2, 0.8}};
  const HermiteFit after = with_moved_controls(g2, *fixed.curve, moved, Others::kept);
  REQUIRE(after.outcome == Outcome::converged);
  CHECK(after.curve->controls[0] == 0.3);
  CHECK(after.curve->controls[5] == 2.2);
  CHECK(after.curve->controls[2] == 0.8);
  const std::array unknown{MovedControl{1, 0.8}};
  CHECK(with_moved_controls(g2, *fixed.curve, unknown, Others::kept).outcome == Outcome::unsupported_input);
}

TEST_CASE("intrinsic: sampled points are the segment's, and the error falls with the fourth power") {
  const StandardData data{0.6, 1.9, {}, {}};
  for (const auto& [degree, controls] : {std::pair{1, 2}, {3, 6}, {3, 8}}) {
    const StandardCurve curve = *solve(data, {.basis = uniform_basis(degree, controls)}).curve;
    const IntrinsicSegment segment(placed(curve, {{{0, 0}, -data.chord_angle, {}}, {{1, 0}, 0.0, {}}}));
    for (const Sines sines : {Sines::library, Sines::vectorised}) {
      const auto error = [&](int count) {
        const std::vector<Vec2> points = Sampler(curve.basis, count).points(curve, data.chord_angle, sines);
        REQUIRE(points.size() == static_cast<std::size_t>(count));
        double worst = 0.0;
        for (int k = 0; k < count; ++k)
          worst = std::max(worst, (points[static_cast<std::size_t>(k)] -
                                   segment.jet(static_cast<double>(k) / (count - 1), 0).position())
                                      .norm());
        return worst;
      };
      CHECK(error(500) <= 1e-11);
      CHECK(error(41) / error(81) > 12.0);
    }
  }
}
