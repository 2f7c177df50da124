#include "schemes/pkappa/near_cusp.hpp"

#include <algorithm>
#include <array>

#include "schemes/curve/hodograph_forms.hpp"

namespace kappabench::pkappa {
namespace {

using Form = BinaryForm<double>;

/// f' = f_t - f_s over [0, 1], s = 1 - t.
Form slope(const Form& form) { return difference(partial_t(form), partial_s(form)); }

bool positive(const Form& form) {
  return std::ranges::all_of(form, [](double c) { return c > 0.0; });
}

constexpr double resolution = 1e-9;  ///< of the parameter

/// Of one sign, that is, without a root, at the ends neither. Next to a root the coefficients fall with the interval,
/// down to `resolution` of what they were, and rounding does not: it must not hide one.
bool keeps_sign(const Form& form) {
  double least = form.front(), most = form.front();
  for (const double c : form) {
    least = std::min(least, c);
    most = std::max(most, c);
  }
  constexpr double rounding = 1e-15 / resolution;
  return least > rounding * most || most < rounding * least;
}

/// A point in [from, to] where `margin` is not positive and `along` has a root.
std::optional<double> search(const Form& margin, const Form& along, double from, double to) {
  if (positive(margin) || keeps_sign(along)) return std::nullopt;
  const double middle = 0.5 * (from + to);
  if (to - from < resolution) return middle;
  const auto [margin_left, margin_right] = halves(margin);
  const auto [along_left, along_right] = halves(along);
  if (const auto found = search(margin_left, along_left, from, middle)) return found;
  return search(margin_right, along_right, middle, to);
}

}  // namespace

template <int Degree>
std::optional<double> near_cusp(const ControlPolygon<Degree>& control, double width, double rest) {
  std::array<double, Degree + 1> px, py;
  for (int i = 0; i <= Degree; ++i) {
    px[static_cast<std::size_t>(i)] = control(0, i);
    py[static_cast<std::size_t>(i)] = control(1, i);
  }
  // c' and c'' up to one factor, the degree.
  const auto velocity = polynomial_hodograph<double>(px, py);
  const Form &x1 = velocity.x, &y1 = velocity.y, x2 = slope(x1), y2 = slope(y1);
  const Form one_squared{1.0, 2.0, 1.0};  // (s + t)^2 raises the degree of |c''|^2 to that of |c'|^2
  Form second = product(sum(product(x2, x2), product(y2, y2)), one_squared);
  for (double& coefficient : second) coefficient *= width * width;
  Form at_rest{1.0};
  for (int raised = 1; raised < Degree; ++raised) at_rest = product(at_rest, one_squared);
  for (double& coefficient : at_rest) coefficient *= rest * rest / (Degree * Degree);
  const Form margin = difference(velocity.speed_squared(), sum(second, at_rest));
  const Form along = sum(product(x1, x2), product(y1, y2));  // c' . c'', half the slope of |c'|^2
  return search(margin, along, 0.0, 1.0);
}

template std::optional<double> near_cusp<4>(const ControlPolygon<4>&, double, double);
template std::optional<double> near_cusp<5>(const ControlPolygon<5>&, double, double);

}  // namespace kappabench::pkappa
