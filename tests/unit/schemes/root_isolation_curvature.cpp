#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "schemes/curve/exact_curvature.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/trigonometric.hpp"
#include "tests/catch.hpp"
#include "tests/sanitized.hpp"

using namespace kappabench;

namespace {

PolynomialSegment polynomial(std::vector<Vec2> points) { return PolynomialSegment(points); }

TrigonometricSegment trigonometric_blend(const Vec2& c0, const Vec2& c1, const Vec2& c2, double a) {
  // Miura 2022, Eq. (17): inner points at the ratio a along the legs.
  const Vec2 middle = 0.5 * ((1 - a) * c0 + 2 * a * c1 + (1 - a) * c2);
  return TrigonometricSegment({c0, (1 - a) * c0 + a * c1, middle, (1 - a) * c2 + a * c1, c2});
}

int sampled_count(const Segment& segment, bool of_slope, int samples) {
  int count = 0;
  int before = 0;
  for (int i = 0; i <= samples; ++i) {
    const Jet jet = segment.jet(static_cast<double>(i) / samples, 3);
    const double value = of_slope ? curvature_derivative(jet) : curvature(jet);
    const int sign = value > 0 ? 1 : value < 0 ? -1 : 0;
    if (sign == 0) continue;
    if (before != 0 && sign != before) ++count;
    before = sign;
  }
  return count;
}

/// A segment of which only `exact` is used.
class FormOnly final : public Segment {
 public:
  explicit FormOnly(ExactForm form) : form_(std::move(form)) {}
  [[nodiscard]] Jet jet(double, int) const override { return {}; }
  [[nodiscard]] ExactForm exact() const override { return form_; }

 private:
  ExactForm form_;
};

}  // namespace

TEST_CASE("curvature extremum of the reference quintic", "[roots][curvature]") {
  const auto segment = polynomial({{0, 0}, {1, 2}, {3, 3}, {5, 2.5}, {6, 1}, {6.5, -1}});
  const SignChanges extrema = curvature_extrema(segment);
  REQUIRE(extrema.at.size() == 1);
  CHECK(extrema.certification == Certification::exact);
  CHECK(extrema.at[0].lo <= 0.53827490207464975);
  CHECK(extrema.at[0].hi >= 0.53827490207464965);
  CHECK(extrema.at[0].hi - extrema.at[0].lo < 1e-12);
  CHECK(inflections(segment).at.empty());
}

TEST_CASE("a parabola has its vertex as the only extremum", "[roots][curvature]") {
  // y = x^2 over [-1, 2]: vertex at t = 1/3.
  const auto segment = polynomial({{-1, 1}, {0.5, -2}, {2, 4}});
  const SignChanges extrema = curvature_extrema(segment);
  REQUIRE(extrema.at.size() == 1);
  CHECK(extrema.at[0].lo <= 1.0 / 3.0);
  CHECK(extrema.at[0].hi >= 1.0 / 3.0);
  CHECK(extrema.at[0].hi - extrema.at[0].lo < 1e-14);
}

TEST_CASE("straight lines and circular arcs have constant curvature", "[roots][curvature]") {
  CHECK(curvature_extrema(polynomial({{0, 0}, {1, 0.3}, {2, 0.6}, {3, 0.9}})).vanishes);
  CHECK(inflections(polynomial({{0, 0}, {1, 0.3}, {2, 0.6}, {3, 0.9}})).vanishes);
  CHECK(curvature_extrema(polynomial({{0, 0}, {1, 1}})).vanishes);
  const auto arc = trigonometric_blend({1, 0}, {1, 1}, {0, 1}, 0.5);
  CHECK(curvature_extrema(arc).vanishes);
  CHECK(inflections(arc).at.empty());
  // A circular arc far from the origin and turned: its control points are rounded.
  const Eigen::Rotation2Dd turn(0.3);
  const Vec2 far(1e3, -7e2);
  const auto turned =
      trigonometric_blend(far + turn * Vec2(1, 0), far + turn * Vec2(1, 1), far + turn * Vec2(0, 1), 0.5);
  CHECK(curvature_extrema(turned).vanishes);
}

TEST_CASE("an S-shaped cubic has one inflection, a looped one none, an arch none", "[roots][curvature]") {
  const SignChanges s = inflections(polynomial({{0, 0}, {1, 1}, {2, -1}, {3, 0}}));
  REQUIRE(s.at.size() == 1);
  CHECK(s.at[0].mid() == Approx(0.5).epsilon(1e-15));
  CHECK(inflections(polynomial({{0, 0}, {3, 2}, {-2, 2}, {1, 0}})).at.empty());
  CHECK(inflections(polynomial({{0, 0}, {1, 1}, {2, 1}, {3, 0}})).at.empty());
}

TEST_CASE("a cusp of a cubic is found; a near cusp is not one", "[roots][curvature]") {
  const auto cusp = polynomial({{0, 0}, {1, 1}, {0, 1}, {1, 0}});
  const auto found = cusps(cusp);
  REQUIRE(found.size() == 1);
  CHECK(found[0] == Approx(0.5));
  CHECK(inflections(cusp).at.empty());
  CHECK(cusps(polynomial({{0, 0}, {1.001, 1}, {0, 1}, {1, 0}})).empty());
}

TEST_CASE("local minimum of curvature of a gentle trigonometric segment", "[roots][curvature]") {
  // a = 0.55, symmetric unit legs, turning 45 degrees: curvature has a local minimum at 1/2 between two maxima.
  const double h = std::sqrt(0.5);
  const auto segment = trigonometric_blend({0, 0}, {1, 0}, {1 + h, h}, 0.55);
  const SignChanges extrema = curvature_extrema(segment);
  CHECK(extrema.certification == Certification::exact);
  CHECK(static_cast<int>(extrema.at.size()) == sampled_count(segment, true, 100001));
  CHECK(std::any_of(extrema.at.begin(), extrema.at.end(),
                    [](const RootBracket& b) { return std::abs(b.mid() - 0.5) < 1e-12; }));
}

TEST_CASE("certified counts agree with dense sampling on random segments", "[roots][curvature]") {
  std::mt19937 random(20240607);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  const auto point = [&] { return Vec2(coordinate(random), coordinate(random)); };
  int disagreements = 0;
  for (int trial = 0; trial < test::cases(600); ++trial) {
    const int degree = 2 + trial % 5;
    std::unique_ptr<Segment> segment;
    if (degree <= 5) {
      std::vector<Vec2> points;
      for (int i = 0; i <= degree; ++i) points.push_back(point());
      segment = std::make_unique<PolynomialSegment>(points);
    } else {
      segment =
          std::make_unique<TrigonometricSegment>(std::array<Vec2, 5>{point(), point(), point(), point(), point()});
    }
    for (const bool of_slope : {true, false}) {
      const SignChanges changes = of_slope ? curvature_extrema(*segment) : inflections(*segment);
      REQUIRE(changes.certification == Certification::exact);
      const auto count = static_cast<int>(changes.at.size());
      const int sampled = sampled_count(*segment, of_slope, 20000);
      CHECK(count >= sampled);  // sampling can only miss sign changes
      if (count != sampled) ++disagreements;
      for (const RootBracket& b : changes.at) {
        CHECK(b.lo >= 0.0);
        CHECK(b.hi <= 1.0);
        CHECK(b.hi - b.lo <= 1e-9);
      }
    }
  }
  CHECK(disagreements <= 5);
}

TEST_CASE("clothoids and curvature B-splines", "[roots][curvature]") {
  CHECK(curvature_extrema(FormOnly(ClothoidForm{{0, 0}, 0.0, 1.0, -2.0, 1.0})).at.empty());
  const SignChanges zero = inflections(FormOnly(ClothoidForm{{0, 0}, 0.0, 1.0, -2.0, 1.0}));
  REQUIRE(zero.at.size() == 1);
  CHECK(zero.at[0].mid() == Approx(0.5));
  CHECK(curvature_extrema(FormOnly(ClothoidForm{{0, 0}, 0.0, 1.0, 0.0, 1.0})).vanishes);

  const std::vector<double> knots{0, 0, 0, 1.0 / 3, 2.0 / 3, 1, 1, 1};
  CHECK(curvature_extrema(FormOnly(IntrinsicForm{{0, 0}, 0, 1, 3, knots, {0.3, 0.7, 1.1, 2, 2.5, 4}})).at.empty());
  // A cubic Bernstein curvature with controls 0 3 3 0 is 9 t (1 - t): one maximum at 1/2.
  const SignChanges bump =
      curvature_extrema(FormOnly(IntrinsicForm{{0, 0}, 0, 1, 3, {0, 0, 0, 1, 1, 1}, {0, 3, 3, 0}}));
  REQUIRE(bump.at.size() == 1);
  CHECK(bump.at[0].mid() == Approx(0.5));
  // Linear splines have their extrema at knots, plateaus included.
  const SignChanges tent =
      curvature_extrema(FormOnly(IntrinsicForm{{0, 0}, 0, 1, 1, {0, 0.25, 0.5, 0.75, 1}, {0, 1, 1, 0, 2}}));
  REQUIRE(tent.at.size() == 2);
  CHECK(tent.at[0].lo == 0.25);
  CHECK(tent.at[0].hi == 0.5);
  CHECK(tent.at[1].mid() == Approx(0.75));
  // A quadratic spline of several spans against its own slope, sampled by de Boor's rule on the differences.
  const SignChanges wave =
      curvature_extrema(FormOnly(IntrinsicForm{{0, 0}, 0, 1, 2, {0, 0, 0.2, 0.5, 0.7, 1, 1}, {0, 1, -1, 2, -2, 1}}));
  // The slope is linear between the values 2 (k_{i+1} - k_i) / (u_{i+2} - u_i) at the knots 0, .2, .5, .7, 1.
  REQUIRE(wave.at.size() == 4);
  const double u[] = {0, 0, 0.2, 0.5, 0.7, 1, 1};
  const double k[] = {0, 1, -1, 2, -2, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    const double left = (k[i + 1] - k[i]) / (u[i + 2] - u[i]);
    const double right = (k[i + 2] - k[i + 1]) / (u[i + 3] - u[i + 1]);
    CHECK(wave.at[i].mid() == Approx(u[i + 1] + (u[i + 2] - u[i + 1]) * left / (left - right)).epsilon(1e-12));
  }
}

TEST_CASE("numbers that are not finite do no harm", "[roots][curvature]") {
  const double nan = std::nan("");
  CHECK(curvature_extrema(polynomial({{0, 0}, {1, nan}, {2, 0}})).at.empty());
  CHECK(cusps(polynomial({{0, 0}, {1, nan}, {2, 0}})).empty());
  CHECK(inflections(FormOnly(IntrinsicForm{{0, 0}, 0, 1, 1, {0, 1}, {nan, 1}})).at.empty());
}
