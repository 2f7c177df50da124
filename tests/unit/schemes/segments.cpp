// Jets of the segments and curvature of a jet, against automatic differentiation of the defining formulas.
#include <array>
#include <boost/math/differentiation/autodiff.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "schemes/curve/arc_length.hpp"
#include "schemes/curve/curve.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/trigonometric.hpp"
#include "tests/catch.hpp"

using namespace kappabench;
namespace autodiff = boost::math::differentiation;

namespace {

std::vector<Vec2> random_points(std::mt19937_64& generator, std::size_t count) {
  std::vector<Vec2> points(count);
  for (Vec2& p : points)
    for (double& x : p) x = static_cast<double>(generator() >> 11) * 0x1p-53 * 4.0 - 2.0;
  return points;
}

/// sum of basis_j(t) * coordinate_j with the basis in closed form.
template <class T>
T bernstein_sum(T t, std::span<const double> coordinates) {
  const int degree = static_cast<int>(coordinates.size()) - 1;
  T sum = 0.0 * t;
  double binomial = 1.0;
  for (int j = 0; j <= degree; ++j) {
    T term = t * 0.0 + binomial * coordinates[static_cast<std::size_t>(j)];
    for (int i = 0; i < j; ++i) term *= t;
    for (int i = j; i < degree; ++i) term *= 1.0 - t;
    sum += term;
    binomial = binomial * (degree - j) / (j + 1);
  }
  return sum;
}

template <class T>
T trigonometric_sum(T t, std::span<const double> c) {
  const T angle = t * (std::numbers::pi / 2.0);
  const T u = 1.0 - sin(angle), w = 1.0 - cos(angle), v = sin(angle) + cos(angle) - 1.0;
  return u * u * c[0] + 2.0 * u * v * c[1] + 4.0 * u * w * c[2] + 2.0 * v * w * c[3] + w * w * c[4];
}

/// The four derivatives of `sum` in both coordinates, against the segment's jet at several t.
template <class Sum>
void check_jets(const Segment& segment, const std::vector<Vec2>& control, Sum sum) {
  for (const double t : {0.0, 0.1, 0.37, 0.5, 0.92, 1.0}) {
    const auto variable = autodiff::make_fvar<double, max_jet_order>(t);
    const Jet jet = segment.jet(t, max_jet_order);
    for (int axis = 0; axis < 2; ++axis) {
      std::vector<double> coordinates;
      for (const Vec2& p : control) coordinates.push_back(p[axis]);
      const auto expected = sum(variable, std::span<const double>(coordinates));
      for (std::size_t r = 0; r <= max_jet_order; ++r) {
        INFO("t = " << t << ", derivative " << r);
        CHECK(jet.d[r][axis] == Approx(expected.derivative(r)).epsilon(1e-11).margin(1e-11));
      }
    }
  }
}

}  // namespace

TEST_CASE("polynomial jets of degree 1 to 5 agree with autodiff") {
  std::mt19937_64 generator(1);
  for (std::size_t count = 2; count <= 6; ++count) {
    const auto control = random_points(generator, count);
    check_jets(PolynomialSegment(control), control, [](const auto& t, auto c) { return bernstein_sum(t, c); });
  }
}

TEST_CASE("trigonometric jets agree with autodiff") {
  std::mt19937_64 generator(2);
  const auto control = random_points(generator, 5);
  const TrigonometricSegment segment({control[0], control[1], control[2], control[3], control[4]});
  check_jets(segment, control, [](const auto& t, auto c) { return trigonometric_sum(t, c); });
}

TEST_CASE("curvature and its arc-length derivatives agree with autodiff") {
  std::mt19937_64 generator(3);
  const auto control = random_points(generator, 6);
  std::array<std::vector<double>, 2> coordinates;
  for (const Vec2& p : control)
    for (const int axis : {0, 1}) coordinates[static_cast<std::size_t>(axis)].push_back(p[axis]);
  const PolynomialSegment segment(control);
  for (const double t : {0.05, 0.3, 0.71}) {
    // Taylor coefficients of kappa(t) and the speed from those of x and y, differentiated by the library.
    const auto variable = autodiff::make_fvar<double, 4>(t);
    const auto x = bernstein_sum(variable, std::span<const double>(coordinates[0]));
    const auto y = bernstein_sum(variable, std::span<const double>(coordinates[1]));
    const auto shifted = [&](const auto& f, std::size_t order) {
      std::array<double, 3> taylor{};
      double factorial = 1.0;
      for (std::size_t r = 0; r < 3; ++r) {
        if (r > 0) factorial *= static_cast<double>(r);
        taylor[r] = f.derivative(r + order) / factorial;
      }
      const auto h = autodiff::make_fvar<double, 2>(0.0);
      return taylor[0] + taylor[1] * h + taylor[2] * h * h;
    };
    const auto x1 = shifted(x, 1), y1 = shifted(y, 1), x2 = shifted(x, 2), y2 = shifted(y, 2);
    const auto squared_speed = x1 * x1 + y1 * y1;
    const auto kappa = (x1 * y2 - y1 * x2) / pow(squared_speed, 1.5);
    const auto v = sqrt(squared_speed);
    const Jet jet = segment.jet(t, 4);
    const double dk = kappa.derivative(1) / v.derivative(0);
    CHECK(curvature(jet) == Approx(kappa.derivative(0)).epsilon(1e-12));
    CHECK(curvature_derivative(jet) == Approx(dk).epsilon(1e-11));
    const double ddk = (kappa.derivative(2) - dk * v.derivative(1)) / (v.derivative(0) * v.derivative(0));
    CHECK(curvature_second_derivative(jet) == Approx(ddk).epsilon(1e-10));
  }
}

TEST_CASE("curvature is positive where the curve turns left") {
  const std::array<Vec2, 3> control{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)};
  CHECK(curvature(PolynomialSegment(control).jet(0.5, 2)) > 0.0);
}

TEST_CASE("the linear trigonometric curve on perpendicular equal legs is a circular arc") {
  // Miura 2022, Sect. 4.1: a = 1/2, control points raised to the quadratic basis as in Eq. (17).
  const Vec2 q0(0, 0), q1(1, 0), q2(1, 1);
  const TrigonometricSegment arc({q0, 0.5 * (q0 + q1), 0.25 * (q0 + 2.0 * q1 + q2), 0.5 * (q1 + q2), q2});
  for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const Jet jet = arc.jet(t, 4);
    CHECK((jet.position() - Vec2(0, 1)).norm() == Approx(1.0).epsilon(1e-14));
    CHECK(curvature(jet) == Approx(1.0).epsilon(1e-13));
    CHECK(std::abs(curvature_derivative(jet)) < 1e-12);
  }
  CHECK(arc_length(arc, 0.0, 1.0) == Approx(std::numbers::pi / 2.0).epsilon(1e-13));
}

TEST_CASE("batches agree with single jets") {
  std::mt19937_64 generator(4);
  const PolynomialSegment segment(random_points(generator, 4));
  const std::vector<double> t{0.0, 0.25, 0.6, 1.0};
  std::vector<Jet> batch(t.size());
  segment.jets(t, 4, batch);
  for (std::size_t i = 0; i < t.size(); ++i)
    for (std::size_t r = 0; r <= 4; ++r) CHECK(batch[i].d[r] == segment.jet(t[i], 4).d[r]);
}

TEST_CASE("polynomial segments have degree 1 to 5") {
  CHECK_THROWS_AS(PolynomialSegment(std::vector<Vec2>(1, Vec2::Zero())), std::invalid_argument);
  CHECK_THROWS_AS(PolynomialSegment(std::vector<Vec2>(7, Vec2::Zero())), std::invalid_argument);
}

TEST_CASE("a curve puts the marks of its nodes in order and takes words only") {
  const auto with = [](std::vector<std::string> marks) {
    return Curve({std::make_shared<PolynomialSegment>(std::vector<Vec2>{{0, 0}, {1, 0}})}, {},
                 {{.point = 0, .segment = 0, .t = 0.0, .marks = std::move(marks)}}, false);
  };
  const Curve curve = with({"pinned", "flat", "pinned"});
  const Node& node = curve.nodes().front();
  CHECK(node.marks == std::vector<std::string>{"flat", "pinned"});
  CHECK(node.has("flat"));
  CHECK_FALSE(node.has("pin"));
  CHECK_THROWS_AS(with({"two words"}), std::invalid_argument);
  CHECK_THROWS_AS(with({""}), std::invalid_argument);
}
