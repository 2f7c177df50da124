#include "schemes/curve/intrinsic_roots.hpp"

#include <algorithm>
#include <cmath>

namespace kappabench {
namespace {

using Rational = boost::multiprecision::cpp_rational;

/// Bernstein coefficients of the curvature on the knot span [knots[j], knots[j + 1]]: the polar form of the spline at
/// (a, ..., a, b, ..., b). In the reduced knots control i is the polar form at knots[i], ..., knots[i + degree - 1].
std::vector<Rational> bernstein_of_span(const IntrinsicForm& form, std::size_t j) {
  const auto n = static_cast<std::size_t>(form.degree);
  const std::size_t first = j + 1 - n;
  const Rational a(form.knots[j]);
  const Rational b(form.knots[j + 1]);
  std::vector<Rational> result;
  for (std::size_t count_b = 0; count_b <= n; ++count_b) {
    std::vector<Rational> p(form.control_curvatures.begin() + static_cast<std::ptrdiff_t>(first),
                            form.control_curvatures.begin() + static_cast<std::ptrdiff_t>(first + n + 1));
    for (std::size_t r = 1; r <= n; ++r) {
      const Rational& x = r <= count_b ? b : a;
      for (std::size_t i = 0; i + r <= n; ++i) {
        const Rational lower(form.knots[first + i + r - 1]);
        const Rational upper(form.knots[first + i + n]);
        p[i] = ((upper - x) * p[i] + (x - lower) * p[i + 1]) / (upper - lower);
      }
    }
    result.push_back(p[0]);
  }
  return result;
}

/// Rational Bernstein coefficients as an integer form: common denominator, times binomials.
BinaryForm<Integer> integer_form(const std::vector<Rational>& bernstein) {
  Integer common = 1;
  for (const Rational& c : bernstein) common = lcm(common, denominator(c));
  BinaryForm<Integer> form;
  Integer binomial = 1;
  const std::size_t d = bernstein.size() - 1;
  for (std::size_t i = 0; i <= d; ++i) {
    form.push_back(numerator(bernstein[i]) * (common / denominator(bernstein[i])) * binomial);
    binomial = binomial * (d - i) / (i + 1);
  }
  return form;
}

int sign_near_start(const BinaryForm<Integer>& form) {
  const auto nonzero = std::find_if(form.begin(), form.end(), [](const Integer& c) { return c != 0; });
  return nonzero == form.end() ? 0 : nonzero->sign();
}

int sign_near_end(const BinaryForm<Integer>& form) {
  const auto nonzero = std::find_if(form.rbegin(), form.rend(), [](const Integer& c) { return c != 0; });
  return nonzero == form.rend() ? 0 : nonzero->sign();
}

bool well_formed(const IntrinsicForm& form) {
  const auto finite = [](double v) { return std::isfinite(v); };
  return form.degree >= 1 && form.control_curvatures.size() > static_cast<std::size_t>(form.degree) &&
         form.knots.size() + 1 == form.control_curvatures.size() + static_cast<std::size_t>(form.degree) &&
         std::is_sorted(form.knots.begin(), form.knots.end()) &&
         std::all_of(form.knots.begin(), form.knots.end(), finite) &&
         std::all_of(form.control_curvatures.begin(), form.control_curvatures.end(), finite);
}

/// The spline's slope has the sign of the differences of its controls; the spline that of the controls.
bool one_sign(const IntrinsicForm& form, bool of_slope) {
  bool up = false;
  bool down = false;
  const std::vector<double>& k = form.control_curvatures;
  for (std::size_t i = of_slope ? 1 : 0; i < k.size(); ++i) {
    const double against = of_slope ? k[i - 1] : 0.0;
    up = up || k[i] > against;
    down = down || k[i] < against;
  }
  return !(up && down);
}

}  // namespace

SignChanges clothoid_sign_changes(const ClothoidForm& form, bool of_slope) {
  SignChanges result;
  if (of_slope) {
    result.vanishes = form.curvature_rate == 0.0;
    return result;
  }
  // Rounded once, so that its sign is that of the exact number.
  const double end = std::fma(form.curvature_rate, form.length, form.curvature);
  result.vanishes = form.curvature == 0.0 && end == 0.0;
  if ((form.curvature > 0.0 && end < 0.0) || (form.curvature < 0.0 && end > 0.0)) {
    constexpr double slack = 0x1p-51;  // of a product and a quotient
    const double t = std::min(1.0, -form.curvature / (form.curvature_rate * form.length));
    result.at.push_back({t * (1.0 - slack), std::min(1.0, t * (1.0 + slack))});
  }
  return result;
}

SignChanges intrinsic_sign_changes(const IntrinsicForm& form, bool of_slope) {
  SignChanges result;
  if (!well_formed(form)) return result;
  const std::vector<double>& k = form.control_curvatures;
  result.vanishes = std::all_of(k.begin(), k.end(), [&](double v) { return v == (of_slope ? k.front() : 0.0); });
  if (result.vanishes || one_sign(form, of_slope)) return result;

  int sign_before = 0;
  double end_before = 0.0;
  for (auto j = static_cast<std::size_t>(form.degree) - 1; j + 1 < k.size(); ++j) {
    const double a = form.knots[j];
    const double b = form.knots[j + 1];
    if (!(a < b)) continue;
    std::vector<Rational> bernstein = bernstein_of_span(form, j);
    if (of_slope) {
      for (std::size_t i = 0; i + 1 < bernstein.size(); ++i) bernstein[i] = bernstein[i + 1] - bernstein[i];
      bernstein.pop_back();
    }
    const BinaryForm<Integer> span = integer_form(bernstein);
    const int first = sign_near_start(span);
    if (first == 0) continue;
    if (sign_before != 0 && first != sign_before) result.at.push_back({end_before, a});
    for (const RootBracket& root : isolate_sign_changes(span)) {
      constexpr double slack = 0x1p-52;  // of a product and a sum that are at most 1
      result.at.push_back({std::max(a, a + root.lo * (b - a) - slack), std::min(b, a + root.hi * (b - a) + slack)});
    }
    sign_before = sign_near_end(span);
    end_before = b;
  }
  return result;
}

}  // namespace kappabench
