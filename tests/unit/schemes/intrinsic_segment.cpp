// Curves from B-spline curvature, and the basis itself, against closed forms, autodiff and 34-digit quadrature.
#include "schemes/segments/intrinsic.hpp"

#include <algorithm>
#include <array>
#include <boost/math/differentiation/autodiff.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "schemes/curve/exact_curvature.hpp"
#include "schemes/segments/clothoid.hpp"
#include "tests/catch.hpp"

using namespace kappabench;

namespace {

using Real = boost::multiprecision::cpp_bin_float_quad;

double uniform(std::mt19937_64& generator, double low, double high) {
  return low + (high - low) * static_cast<double>(generator() >> 11) * 0x1p-53;
}

/// Curvatures up to `size`, knots anywhere, some repeated.
IntrinsicForm random_form(std::mt19937_64& generator, int degree, int controls, double size) {
  IntrinsicForm form{{uniform(generator, -1, 1), uniform(generator, -1, 1)},
                     uniform(generator, -3, 3),
                     uniform(generator, 0.5, 2),
                     degree,
                     std::vector<double>(static_cast<std::size_t>(degree), 0.0),
                     {}};
  std::vector<double> inner;
  for (int i = 0; i < controls - degree - 1; ++i)
    inner.push_back(i % 4 == 3 && degree > 1 ? inner.back() : uniform(generator, 0.01, 0.99));
  std::ranges::sort(inner);
  form.knots.insert(form.knots.end(), inner.begin(), inner.end());
  form.knots.insert(form.knots.end(), static_cast<std::size_t>(degree), 1.0);
  for (int i = 0; i < controls; ++i) form.control_curvatures.push_back(uniform(generator, -size, size));
  return form;
}

/// The angle by de Boor's algorithm on the integrated spline: degree + 1, coefficients summed with the widths of
/// their basis functions.
template <class T>
T angle_at(const IntrinsicForm& form, const T& t, double at) {
  const auto n = static_cast<std::size_t>(form.degree);
  std::vector<double> knots = form.knots;
  knots.insert(knots.begin(), 2, 0.0);
  knots.insert(knots.end(), 2, 1.0);
  // Now clamped for degree n + 1 in the usual notation with n + 2 end knots.
  std::vector<double> c{0.0};
  for (std::size_t i = 0; i < form.control_curvatures.size(); ++i)
    c.push_back(c.back() + form.control_curvatures[i] * (knots[i + n + 2] - knots[i + 1]) / static_cast<double>(n + 1));
  std::size_t span = n + 1;
  while (span + n + 3 < knots.size() && knots[span + 1] <= at) ++span;
  std::vector<T> d;
  for (std::size_t j = 0; j <= n + 1; ++j) d.push_back(T(c[span - n - 1 + j]));
  for (std::size_t r = 1; r <= n + 1; ++r)
    for (std::size_t j = n + 1; j >= r; --j) {
      const double low = knots[span - n - 1 + j], high = knots[span + 1 + j - r];
      const T share = (t - low) / (high - low);
      d[j] = (1.0 - share) * d[j - 1] + share * d[j];
    }
  return T(form.angle + form.length * d[n + 1]);
}

/// 20-point Gauss in 34 digits on parts of every knot span.
Vec2 reference_end(const IntrinsicForm& form, double t) {
  using Rule = boost::math::quadrature::gauss<Real, 20>;
  std::vector<double> ends = form.knots;
  ends.erase(std::remove_if(ends.begin(), ends.end(), [&](double k) { return k >= t; }), ends.end());
  ends.push_back(t);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  Real x = 0, y = 0;
  for (std::size_t j = 0; j + 1 < ends.size(); ++j)
    for (int part = 0; part < 8; ++part) {
      const Real half = (Real(ends[j + 1]) - Real(ends[j])) / 16, middle = Real(ends[j]) + half * (2 * part + 1);
      for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
        for (const int side : {-1, 1}) {
          const Real at = middle + side * half * Rule::abscissa()[i];
          const Real angle = angle_at(form, at, static_cast<double>(at));
          x += half * Rule::weights()[i] * cos(angle);
          y += half * Rule::weights()[i] * sin(angle);
        }
    }
  return form.start + form.length * Vec2(static_cast<double>(x), static_cast<double>(y));
}

}  // namespace

TEST_CASE("B-spline basis: Greville abscissae and integrals") {
  // Fixture: knots [0, 0, 0, 1/3, 2/3, 1, 1, 1].
  const BSplineBasis basis = uniform_basis(3, 6);
  CHECK(basis.knots == std::vector<double>{0, 0, 0, 1.0 / 3, 2.0 / 3, 1, 1, 1});
  const std::vector<double> integrals = basis_integrals(basis);
  const std::array expected{1.0 / 12, 1.0 / 6, 0.25, 0.25, 1.0 / 6, 1.0 / 12};
  for (std::size_t i = 0; i < 6; ++i) CHECK(integrals[i] == Approx(expected[i]).epsilon(1e-15));
  const std::vector<double> greville = greville_abscissae(basis);
  const std::array abscissae{0.0, 1.0 / 9, 1.0 / 3, 2.0 / 3, 8.0 / 9, 1.0};
  for (std::size_t i = 0; i < 6; ++i) CHECK(greville[i] == Approx(abscissae[i]).epsilon(1e-15));
  CHECK(uniform_basis(1, 2).knots == std::vector<double>{0, 1});
}

TEST_CASE("B-spline basis: what is ill-formed is said in one line") {
  using Catch::Matchers::Contains;
  CHECK(reason_ill_formed(uniform_basis(3, 8)).empty());
  CHECK(reason_ill_formed({2, {0, 0, 0.5, 0.5, 1, 1}}).empty());
  CHECK_THAT(reason_ill_formed({0, {}}), Contains("degree"));
  CHECK_THAT(reason_ill_formed({3, {0, 0, 0, 1, 1}}), Contains("too few"));
  CHECK_THAT(reason_ill_formed({1, {0, 0.5, 0.25, 1}}), Contains("smaller"));
  CHECK_THAT(reason_ill_formed({2, {0, 0.1, 0.5, 1, 1}}), Contains("must be 0 and 1"));
  CHECK_THAT(reason_ill_formed({1, {0, 0.5, 0.5, 1}}), Contains("repeated"));
  CHECK_THAT(reason_ill_formed({1, {0, std::nan(""), 1}}), Contains("knot 2"));
}

TEST_CASE("intrinsic segment: the fixture") {
  const IntrinsicSegment segment({{0, 0}, 0, 0.5, 3, {0, 0, 0, 1.0 / 3, 2.0 / 3, 1, 1, 1}, {0.3, 0.7, 1.1, 2, 2.5, 4}});
  const Jet end = segment.jet(1.0, 2);
  CHECK(end.position().x() == Approx(0.4655339354168183).epsilon(1e-15));
  CHECK(end.position().y() == Approx(0.140098949466284).epsilon(1e-14));
  CHECK(tangent_angle(end) == Approx(0.8333333333333333).epsilon(1e-15));
  CHECK(curvature(end) == Approx(4.0).epsilon(1e-14));
}

TEST_CASE("intrinsic segment: position to 1e-14 of 34-digit quadrature") {
  std::mt19937_64 generator(5);
  for (const double size : {0.1, 2.0, 8.0})
    for (int degree = 1; degree <= 7; ++degree) {
      const IntrinsicForm form = random_form(generator, degree, degree + 1 + static_cast<int>(generator() % 5), size);
      INFO("degree " << degree << ", " << form.control_curvatures.size() << " controls to " << size);
      const IntrinsicSegment segment(form);
      for (const double t : {0.0, 0.3, 0.77, 1.0})
        CHECK((segment.jet(t, 0).position() - reference_end(form, t)).norm() <= 1e-14 * form.length);
    }
}

TEST_CASE("intrinsic segment: jets agree with autodiff") {
  std::mt19937_64 generator(6);
  for (int degree = 1; degree <= 6; ++degree) {
    const IntrinsicForm form = random_form(generator, degree, degree + 3, 3.0);
    const IntrinsicSegment segment(form);
    for (const double t : {0.0, 0.123, 0.5, 0.9}) {
      INFO("degree " << degree << ", t = " << t);
      const auto variable = boost::math::differentiation::make_fvar<double, 3>(t);
      const auto angle = angle_at(form, variable, t);
      const auto x = form.length * cos(angle), y = form.length * sin(angle);
      const Jet jet = segment.jet(t, max_jet_order);
      for (std::size_t order = 1; order <= 4; ++order) {
        const Vec2 expected(x.derivative(order - 1), y.derivative(order - 1));
        CHECK((jet.d[order] - expected).norm() <= 1e-12 * (1.0 + expected.norm()));
      }
    }
  }
}

TEST_CASE("intrinsic segment: linear curvature is a clothoid, batches are single jets") {
  const ClothoidSegment clothoid({{1, 2}, 0.4, -1.5, 3.0, 1.7});
  const IntrinsicSegment segment({{1, 2}, 0.4, 1.7, 1, {0, 1}, {-1.5, -1.5 + 3.0 * 1.7}});
  std::mt19937_64 generator(7);
  const IntrinsicSegment bent(random_form(generator, 3, 8, 6.0));
  std::vector<double> t;
  for (int i = 0; i <= 200; ++i) t.push_back(i / 200.0);
  std::vector<double> shuffled = t;
  std::ranges::reverse(shuffled);
  for (const auto& order : {t, shuffled}) {
    std::vector<Jet> jets(order.size());
    bent.jets(order, 4, jets);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Jet alone = bent.jet(order[i], 4);
      for (std::size_t k = 0; k <= 4; ++k) CHECK((jets[i].d[k] - alone.d[k]).norm() <= 1e-13 * (1 + alone.d[k].norm()));
      const Jet a = segment.jet(order[i], 4), b = clothoid.jet(order[i], 4);
      for (std::size_t k = 0; k <= 4; ++k) CHECK((a.d[k] - b.d[k]).norm() <= 1e-13 * (1.0 + b.d[k].norm()));
    }
  }
}

TEST_CASE("intrinsic segment: inflections and extrema are those of the spline") {
  // One cubic Bezier span: kappa = 1 - 6 t + 6 t^2 has its minimum at 1/2 and zeros at (3 -+ sqrt 3) / 6.
  const IntrinsicSegment segment({{0, 0}, 0, 2, 3, {0, 0, 0, 1, 1, 1}, {1, -1, -1, 1}});
  const auto extrema = curvature_extrema(segment);
  REQUIRE(extrema.at.size() == 1);
  CHECK(extrema.certification == Certification::exact);
  CHECK(extrema.at[0].lo <= 0.5);
  CHECK(extrema.at[0].hi >= 0.5);
  const auto zeros = inflections(segment);
  REQUIRE(zeros.at.size() == 2);
  CHECK(zeros.at[0].lo == Approx((3 - std::sqrt(3)) / 6).epsilon(1e-12));
  CHECK(zeros.at[1].lo == Approx((3 + std::sqrt(3)) / 6).epsilon(1e-12));
}

TEST_CASE("intrinsic segment: bad forms are refused") {
  const IntrinsicForm good{{0, 0}, 0, 1, 2, {0, 0, 0.5, 1, 1}, {1, 2, 3, 4}};
  CHECK_NOTHROW(IntrinsicSegment(good));
  const auto refused = [](IntrinsicForm form) {
    CHECK_THROWS_AS(IntrinsicSegment(std::move(form)), std::invalid_argument);
  };
  IntrinsicForm bad = good;
  bad.control_curvatures.pop_back();
  refused(bad);
  bad = good;
  bad.length = 0.0;
  refused(bad);
  bad = good;
  bad.control_curvatures[1] = std::nan("");
  refused(bad);
  bad = good;
  bad.knots[2] = 2.0;
  refused(bad);
}
