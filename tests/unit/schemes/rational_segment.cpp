// Rational segments: jets against autodiff, conics against what is known of them.
#include "schemes/segments/rational.hpp"

#include <boost/math/differentiation/autodiff.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "schemes/curve/exact_curvature.hpp"
#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"

using namespace kappabench;

namespace {

/// A quarter of the ellipse with half axes a and b, from its vertex on the x axis.
RationalForm quarter(double a, double b) { return {{{a, 0}, {a, b}, {0, b}}, {1.0, std::sqrt(0.5), 1.0}}; }

/// Degree raised by one: weighted points are averaged.
RationalForm elevated(const RationalForm& form) {
  const auto n = static_cast<double>(form.weights.size());
  RationalForm higher;
  for (std::size_t i = 0; i <= form.weights.size(); ++i) {
    const double part = static_cast<double>(i) / n;
    const double before = i > 0 ? part * form.weights[i - 1] : 0.0;
    const double here = i < form.weights.size() ? (1.0 - part) * form.weights[i] : 0.0;
    Vec2 sum = Vec2::Zero();
    if (i > 0) sum += before * form.control_points[i - 1];
    if (i < form.weights.size()) sum += here * form.control_points[i];
    higher.weights.push_back(before + here);
    higher.control_points.emplace_back(sum / (before + here));
  }
  return higher;
}

template <class T>
T coordinate(const RationalForm& form, int axis, const T& t) {
  const std::size_t n = form.weights.size() - 1;
  T sum = 0.0 * t, weight = 0.0 * t;
  double binomial = 1.0;
  for (std::size_t i = 0; i <= n; ++i) {
    T basis = 0.0 * t + binomial * form.weights[i];
    for (std::size_t k = 0; k < n; ++k) basis *= k < i ? t : 1.0 - t;
    sum += form.control_points[i][axis] * basis;
    weight += basis;
    binomial = binomial * static_cast<double>(n - i) / static_cast<double>(i + 1);
  }
  return sum / weight;
}

}  // namespace

TEST_CASE("rational jets agree with autodiff, and both ends are control points to the last bit") {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> place(-2.0, 2.0), weight(0.2, 5.0);
  for (std::size_t degree = 1; degree <= 5; ++degree) {
    RationalForm form;
    for (std::size_t i = 0; i <= degree; ++i) {
      form.control_points.emplace_back(place(generator), place(generator));
      form.weights.push_back(weight(generator));
    }
    const RationalSegment segment(form);
    CHECK(segment.jet(0.0, 0).position() == form.control_points.front());
    CHECK(segment.jet(1.0, 0).position() == form.control_points.back());
    for (const double t : {0.0, 0.2, 0.71, 1.0}) {
      const Jet jet = segment.jet(t, max_jet_order);
      for (const int axis : {0, 1}) {
        const auto expected = coordinate(form, axis, boost::math::differentiation::make_fvar<double, max_jet_order>(t));
        for (std::size_t r = 0; r <= max_jet_order; ++r) {
          INFO("degree " << degree << ", t = " << t << ", derivative " << r);
          const double size = std::abs(expected.derivative(r)) + jet.d[r].norm() + 1.0;
          CHECK(std::abs(jet.d[r][axis] - expected.derivative(r)) <= 1e-12 * size);
        }
      }
    }
  }
}

TEST_CASE("equal weights are the polynomial; placing is placing the control points") {
  const std::vector<Vec2> points{{0, 0}, {1, 3}, {4, -1}, {5, 2}};
  const RationalSegment same({points, {2, 2, 2, 2}});
  const PolynomialSegment polynomial(points);
  const Placement placement{.scale = 3.0, .shift = {1.0, -2.0}};
  const SegmentPtr placed = same.placed(placement);
  for (const double t : {0.0, 0.3, 0.8}) {
    const Jet a = same.jet(t, 4), b = polynomial.jet(t, 4);
    for (std::size_t r = 0; r <= 4; ++r) CHECK((a.d[r] - b.d[r]).norm() <= 1e-13 * (1.0 + b.d[r].norm()));
    CHECK((placed->jet(t, 0).position() - placement(a.position())).norm() <= 1e-14);
  }
  CHECK(curvature_extrema(same).at.size() == curvature_extrema(polynomial).at.size());
}

TEST_CASE("circles have one curvature, ellipses its extrema at their vertices, of any degree") {
  for (RationalForm form : {quarter(2, 2), elevated(quarter(2, 2)), elevated(elevated(quarter(2, 2)))}) {
    const RationalSegment circle(form);
    for (const double t : {0.0, 0.25, 0.5, 1.0}) CHECK(curvature(circle.jet(t, 2)) == Approx(0.5).epsilon(1e-14));
    CHECK(curvature_extrema(circle).vanishes);
    CHECK(inflections(circle).at.empty());
  }
  // From (3, -4) over the vertex (5, 0) on: by symmetry the extremum is in the middle.
  const RationalForm vertex{{{3, -4}, {25.0 / 3.0, 0}, {3, 4}}, {1.0, 0.6, 1.0}};
  RationalForm ellipse = vertex;
  for (Vec2& p : ellipse.control_points) p.x() *= 2.0;  // half axes 10 and 5
  for (const RationalForm& form : {ellipse, elevated(ellipse), elevated(elevated(ellipse))}) {
    const RationalSegment segment(form);
    CHECK((segment.jet(0.5, 0).position() - Vec2(10, 0)).norm() <= 1e-14 * 10.0);
    CHECK(curvature(segment.jet(0.5, 2)) == Approx(10.0 / 25.0).epsilon(1e-13));
    const SignChanges extrema = curvature_extrema(segment);
    CHECK(extrema.certification == Certification::exact);
    REQUIRE(extrema.at.size() == 1);
    CHECK(extrema.at[0].mid() == Approx(0.5).margin(1e-14));
  }
}

TEST_CASE("a rational cusp is found, and a lopsided weight alone makes none") {
  // A cuspidal cubic seen through a projective map: any positive weights keep the cusp of the control polygon's X.
  const RationalForm cusp{{{0, 0}, {1, 1}, {0, 1}, {1, 0}}, {1.0, 1.0, 1.0, 1.0}};
  REQUIRE(cusps(RationalSegment(cusp)).size() == 1);
  CHECK(cusps(RationalSegment(cusp)).front() == Approx(0.5).margin(1e-9));
  RationalForm mapped = cusp;  // (x, y) / (1 + x + y): points over their weights
  for (std::size_t i = 0; i < mapped.weights.size(); ++i) {
    mapped.weights[i] = 1.0 + mapped.control_points[i].sum();
    mapped.control_points[i] /= mapped.weights[i];
  }
  REQUIRE(cusps(RationalSegment(mapped)).size() == 1);
  CHECK(cusps(RationalSegment(mapped)).front() == Approx(0.5).margin(1e-7));
  CHECK(cusps(RationalSegment({{{0, 0}, {1, 2}, {3, 0}}, {1.0, 1e4, 1.0}})).empty());
}

TEST_CASE("rational segments refuse what they are not") {
  const std::vector<Vec2> points{{0, 0}, {1, 1}, {2, 0}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(RationalSegment({{{0, 0}}, {1}}), std::invalid_argument);
  CHECK_THROWS_AS(RationalSegment({std::vector<Vec2>(7, Vec2(0, 0)), std::vector<double>(7, 1.0)}),
                  std::invalid_argument);
  for (const std::vector<double>& weights : {std::vector<double>{1, 1}, std::vector<double>{1, 0, 1},
                                             std::vector<double>{1, -1, 1}, std::vector<double>{1, nan, 1}})
    CHECK_THROWS_AS(RationalSegment({points, weights}), std::invalid_argument);
}
