// The segments of trigonometric blending: jets against automatic differentiation of the defining formulas.
#include <array>
#include <boost/math/differentiation/autodiff.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "schemes/curve/exact_curvature.hpp"
#include "schemes/segments/blend.hpp"
#include "schemes/segments/elliptic_arc.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/reparametrized.hpp"
#include "schemes/segments/three_point_arcs.hpp"
#include "tests/catch.hpp"

using namespace kappabench;
namespace autodiff = boost::math::differentiation;

namespace {

using std::numbers::pi;

const EllipticArcForm arc{Vec2(0.3, -0.2), Vec2(1.5, 0.4), Vec2(-0.5, 0.9), -0.7, 1.9};
const std::array<Vec2, 3> parabola{Vec2(0, 0), Vec2(1, 2), Vec2(3, 0.5)};

template <class T>
T on_arc(const T& t, int axis) {
  const T w = arc.from + (arc.to - arc.from) * t;
  return arc.centre[axis] + arc.axis_a[axis] * cos(w) + arc.axis_b[axis] * sin(w);
}
template <class T>
T on_parabola(const T& t, int axis) {
  const T u = 1.0 - t;
  return u * u * parabola[0][axis] + 2.0 * u * t * parabola[1][axis] + t * t * parabola[2][axis];
}

template <class Formula>
void check_jets(const Segment& segment, const Formula& formula) {
  for (const double t : {0.0, 0.13, 0.5, 0.81, 1.0}) {
    const Jet jet = segment.jet(t, max_jet_order);
    for (const int axis : {0, 1}) {
      const auto expected = formula(autodiff::make_fvar<double, max_jet_order>(t), axis);
      for (std::size_t r = 0; r <= max_jet_order; ++r) {
        INFO("t = " << t << ", derivative " << r);
        CHECK(jet.d[r][axis] == Approx(expected.derivative(r)).epsilon(1e-12).margin(1e-12));
      }
    }
    CHECK(segment.jet(t, 1).d[1] == jet.d[1]);
  }
}

double uniform(std::mt19937_64& generator) { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0; }

}  // namespace

TEST_CASE("jets of an elliptical arc agree with autodiff") {
  check_jets(EllipticArcSegment(arc), [](const auto& t, int axis) { return on_arc(t, axis); });
}

TEST_CASE("jets of a reparametrised segment agree with autodiff") {
  for (const double m : {0.2, 1.0, 3.5})
    check_jets(ReparametrizedSegment(std::make_shared<EllipticArcSegment>(arc), m),
               [m](const auto& t, int axis) { return on_arc(m * t / (1.0 + (m - 1.0) * t), axis); });
  CHECK_THROWS_AS(ReparametrizedSegment(std::make_shared<EllipticArcSegment>(arc), 0.0), std::invalid_argument);
}

TEST_CASE("jets of a blend agree with autodiff") {
  const BlendSegment blend(std::make_shared<PolynomialSegment>(parabola), std::make_shared<EllipticArcSegment>(arc));
  check_jets(blend, [](const auto& t, int axis) {
    const auto c = cos(0.5 * pi * t), s = sin(0.5 * pi * t);
    const auto v = c * c, w = s * s;
    const double g = on_parabola(0.0, axis) - on_arc(0.0, axis), h = on_arc(1.0, axis) - on_parabola(1.0, axis);
    return v * on_parabola(t, axis) + w * on_arc(t, axis) + v * w * (v * g + w * h);
  });
  const auto form = std::get<BlendForm>(blend.exact());
  CHECK(std::holds_alternative<PolynomialForm>(form.from->exact()));
  CHECK(std::holds_alternative<EllipticArcForm>(form.to->exact()));
}

TEST_CASE("curvature extrema of an elliptical arc are where its speed is extreme") {
  const auto slope = [](const Segment& s, double t) { return curvature_derivative(s.jet(t, 3)); };
  std::mt19937_64 generator(3);
  for (int i = 0; i < 50; ++i) {
    const double from = 3.0 * uniform(generator), to = from + 3.0 * uniform(generator);
    const EllipticArcSegment segment({Vec2::Zero(), Vec2(uniform(generator), uniform(generator)),
                                      Vec2(uniform(generator), uniform(generator)), from, to});
    const SignChanges extrema = curvature_extrema(segment);
    CHECK(extrema.certification == Certification::exact);
    CHECK(inflections(segment).at.empty());
    double before = 0.0;
    int changes = 0;
    for (int k = 0; k <= 200; ++k) {
      const double at = slope(segment, k / 200.0);
      if (before * at < 0.0) ++changes;
      before = at;
    }
    CHECK(static_cast<int>(extrema.at.size()) == changes);
    for (const RootBracket& root : extrema.at)
      CHECK(slope(segment, root.mid() - 1e-4) * slope(segment, root.mid() + 1e-4) < 0.0);
    const auto same = std::make_shared<EllipticArcSegment>(segment);
    const SignChanges moved = curvature_extrema(ReparametrizedSegment(same, 2.5));
    REQUIRE(moved.at.size() == extrema.at.size());
    for (std::size_t k = 0; k < moved.at.size(); ++k) {
      const double t = moved.at[k].mid();
      CHECK(2.5 * t / (1.0 + 1.5 * t) == Approx(extrema.at[k].mid()).epsilon(1e-12));
    }
  }
  CHECK(curvature_extrema(EllipticArcSegment({Vec2::Zero(), Vec2(2, 1), Vec2(-1, 2), 0.0, 2.0})).vanishes);  // a circle
}

TEST_CASE("arcs through three points pass them, smoothly and in order") {
  std::mt19937_64 generator(4);
  for (int i = 0; i < 2000; ++i) {
    const double flat = std::pow(10.0, 5.0 * uniform(generator) - 5.0);  // heights down to 1e-10
    const Vec2 p0(uniform(generator) - 1.5, flat * uniform(generator)), p1(0.0, 0.0);
    const Vec2 p2(uniform(generator) + (i % 3 == 0 ? -1.2 : 1.5), flat * uniform(generator));
    if (folds_back(p0, p1, p2)) continue;
    INFO("case " << i << ", height " << flat);
    for (const ArcPair& pair : {circle_through(p0, p1, p2), ellipse_through(p0, p1, p2)}) {
      double scale = 1.0;
      for (const Jet& jet : {pair.first->jet(0.5, 0), pair.second->jet(0.5, 0)})
        scale = std::max(scale, jet.position().norm());
      CHECK((pair.first->jet(0.0, 0).position() - p0).norm() < 1e-13 * scale);
      CHECK((pair.first->jet(1.0, 0).position() - p1).norm() < 1e-13 * scale);
      CHECK((pair.second->jet(0.0, 0).position() - p1).norm() < 1e-13 * scale);
      CHECK((pair.second->jet(1.0, 0).position() - p2).norm() < 1e-13 * scale);
      const Jet before = pair.first->jet(1.0, 2), after = pair.second->jet(0.0, 2);
      CHECK(std::abs(std::remainder(tangent_angle(before) - tangent_angle(after), 2.0 * pi)) < 3e-9);
      const Vec2 v0 = before.d[1] / pair.first_extent, v1 = after.d[1] / pair.second_extent;
      CHECK((v0 - v1).norm() < 1e-8 * v0.norm());
    }
  }
}

TEST_CASE("the circle's halves are arcs of one circle, also through nearly straight triples") {
  const ArcPair half = circle_through({1, 0}, {0, 1}, {-1, 0});
  for (const double t : {0.2, 0.7}) {
    CHECK(half.first->jet(t, 0).position().norm() == Approx(1.0).epsilon(1e-15));
    CHECK(half.second->jet(t, 0).position().norm() == Approx(1.0).epsilon(1e-15));
  }
  // Sagitta h over the half chord 1: curvature 2 h / (1 + h^2).
  for (const double h : {1e-3, 1e-7, 1e-12, 0.0}) {
    const ArcPair flat = circle_through({-1, 0}, {0, h}, {1, 0});
    CHECK(curvature(flat.second->jet(0.3, 2)) == Approx(-2.0 * h / (1.0 + h * h)).epsilon(1e-12));
  }
}

TEST_CASE("the ellipse has half axes at the middle point and at the farther neighbour") {
  for (const auto& [p0, p2] :
       {std::pair{Vec2(-2, -1), Vec2(0.7, -0.4)}, {Vec2(-0.5, -0.2), Vec2(1, 1.5)}, {Vec2(0.3, -1), Vec2(0.2, -1.1)}}) {
    const ArcPair pair = ellipse_through(p0, Vec2(0, 0), p2);
    const auto form = std::get<EllipticArcForm>(pair.first->exact());
    CHECK(std::abs(form.axis_a.dot(form.axis_b)) < 1e-15);
    CHECK((form.centre + form.axis_a).norm() < 1e-15);
    const bool after_is_far = p2.norm() > p0.norm();
    const Vec2& far = after_is_far ? p2 : p0;
    CHECK(std::min((form.centre + form.axis_b - far).norm(), (form.centre - form.axis_b - far).norm()) < 1e-15);
  }
  // A quarter circle's neighbours at equal distance: the ellipse is the circle.
  const ArcPair circle = ellipse_through({1, 0}, {0, 1}, {-1, 0});
  CHECK(circle.first->jet(0.37, 0).position().norm() == Approx(1.0).epsilon(1e-14));
}

TEST_CASE("only triples that turn straight back are refused") {
  CHECK(folds_back({0, 0}, {2, 0}, {1, 0}));
  CHECK(folds_back({0, 0}, {2, 0}, {-5, 1e-9}));
  CHECK_FALSE(folds_back({0, 0}, {2, 0}, {3, 0}));
  CHECK_FALSE(folds_back({0, 0}, {2, 0}, {1, 1e-6}));
}
