#include "schemes/segments/intrinsic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "schemes/numerics/gauss.hpp"

namespace kappabench {

namespace {

constexpr std::size_t most_coefficients = 11;  ///< of the angle, degree 10
using Coefficients = std::array<double, most_coefficients>;

/// Value at v of the polynomial with these Bernstein coefficients.
double value(std::span<const double> bernstein, double v) {
  Coefficients c;
  std::ranges::copy(bernstein, c.begin());
  for (std::size_t left = bernstein.size() - 1; left > 0; --left)
    for (std::size_t i = 0; i < left; ++i) c[i] += v * (c[i + 1] - c[i]);
  return c[0];
}

/// The first and second derivative by v of a polynomial.
double slope(std::span<const double> bernstein, double v) {
  if (bernstein.size() < 2) return 0.0;
  Coefficients d;
  const std::size_t degree = bernstein.size() - 1;
  for (std::size_t i = 0; i < degree; ++i) d[i] = static_cast<double>(degree) * (bernstein[i + 1] - bernstein[i]);
  return value({d.data(), degree}, v);
}

double second_derivative(std::span<const double> bernstein, double v) {
  if (bernstein.size() < 3) return 0.0;
  Coefficients d;
  const std::size_t degree = bernstein.size() - 1;
  const auto factor = static_cast<double>(degree * (degree - 1));
  for (std::size_t i = 0; i + 1 < degree; ++i)
    d[i] = factor * (bernstein[i + 2] - 2.0 * bernstein[i + 1] + bernstein[i]);
  return value({d.data(), degree - 1}, v);
}

/// A bound on what the angle changes by, in total, between v0 and v1: that of the control polygon there.
double variation(std::span<const double> angle, double v0, double v1) {
  double total = 0.0;
  const std::size_t degree = angle.size() - 1;
  if (v0 == 0.0 && v1 == 1.0) {
    for (std::size_t i = 0; i < degree; ++i) total += std::abs(angle[i + 1] - angle[i]);
    return total;
  }
  // Blossom at (v0, ..., v0, v1, ..., v1).
  double before = 0.0;
  for (std::size_t ends = 0; ends <= degree; ++ends) {
    Coefficients c;
    std::ranges::copy(angle, c.begin());
    for (std::size_t r = 1; r <= degree; ++r) {
      const double v = r <= ends ? v1 : v0;
      for (std::size_t i = 0; i + r <= degree; ++i) c[i] += v * (c[i + 1] - c[i]);
    }
    if (ends > 0) total += std::abs(c[0] - before);
    before = c[0];
  }
  return total;
}

void check(const IntrinsicForm& form) {
  const BSplineBasis basis{form.degree, form.knots};
  if (const std::string reason = reason_ill_formed(basis); !reason.empty())
    throw std::invalid_argument("intrinsic segment: " + reason);
  const std::size_t controls = form.control_curvatures.size();
  if (controls != static_cast<std::size_t>(basis.size()))
    throw std::invalid_argument(
        fmt::format("intrinsic segment: {} control curvatures for knots that need {}", controls, basis.size()));
  const auto finite = [](double k) { return std::isfinite(k); };
  if (!std::ranges::all_of(form.control_curvatures, finite) || !form.start.allFinite() || !std::isfinite(form.angle))
    throw std::invalid_argument("intrinsic segment: all numbers must be finite");
  if (!(form.length > 0.0 && std::isfinite(form.length)))
    throw std::invalid_argument(fmt::format("intrinsic segment: the length is {}, it must be positive", form.length));
}

}  // namespace

IntrinsicSegment::IntrinsicSegment(IntrinsicForm form) : form_(std::move(form)) {
  check(form_);
  const std::vector<double>& controls = form_.control_curvatures;
  double angle = form_.angle;
  Vec2 start = form_.start;
  for (const KnotSpan& span : spans_of({form_.degree, form_.knots})) {
    const Eigen::VectorXd curvature =
        span.to_bernstein * Eigen::Map<const Eigen::VectorXd>(controls.data() + span.first, form_.degree + 1);
    Piece piece{span.from, span.width(), {curvature.begin(), curvature.end()}, {angle}, start};
    // Integration of a Bernstein polynomial: running sums over degree + 1 (Yoshida 2022, Eq. (7)).
    for (const double k : piece.curvature)
      piece.angle.push_back(angle += form_.length * piece.width * k / (form_.degree + 1));
    start += displacement(piece, 0.0, 1.0);
    pieces_.push_back(std::move(piece));
  }
}

const IntrinsicSegment::Piece& IntrinsicSegment::piece_at(double t) const {
  const auto after =
      std::upper_bound(pieces_.begin() + 1, pieces_.end(), t, [](double x, const Piece& p) { return x < p.from; });
  return *(after - 1);
}

Vec2 IntrinsicSegment::displacement(const Piece& piece, double v0, double v1) const {
  Vec2 sum = Vec2::Zero();
  const auto add = [&](double v, double weight) {
    const double angle = value(piece.angle, v);
    sum += weight * Vec2(std::cos(angle), std::sin(angle));
  };
  // exp(i angle) is to rounding a polynomial of a degree that grows with the angle's own, n + 1, and with how much it
  // changes. The bounds keep both rules exact to 1e-15 even for angles that are Chebyshev polynomials, the worst case.
  const double turns = static_cast<double>(form_.degree + 1) * variation(piece.angle, v0, v1);
  if (turns <= 0.05 && form_.degree <= 3) {
    for_gauss_nodes<10>(v0, v1 - v0, add);
  } else {
    const int panels = 1 + static_cast<int>(std::min(0.5 * turns, 1e6));
    const double width = (v1 - v0) / panels;
    for (int k = 0; k < panels; ++k) for_gauss_nodes<20>(v0 + k * width, width, add);
  }
  return form_.length * piece.width * sum;
}

Jet IntrinsicSegment::jet_at(const Piece& piece, double v, const Vec2& position, int order) const {
  const double length = form_.length;
  Jet jet;
  jet.d[0] = position;
  if (order < 1) return jet;
  const double angle = value(piece.angle, v);
  const Vec2 tangent(std::cos(angle), std::sin(angle));
  const Vec2 normal = left_normal(tangent);
  jet.d[1] = length * tangent;
  if (order < 2) return jet;
  // Per unit of t: the angle's rate, and its derivatives.
  const double rate = length * value(piece.curvature, v);
  jet.d[2] = length * rate * normal;
  if (order < 3) return jet;
  const double rate1 = length * slope(piece.curvature, v) / piece.width;
  jet.d[3] = length * (rate1 * normal - rate * rate * tangent);
  if (order < 4) return jet;
  const double rate2 = length * second_derivative(piece.curvature, v) / (piece.width * piece.width);
  jet.d[4] = length * ((rate2 - rate * rate * rate) * normal - 3.0 * rate * rate1 * tangent);
  return jet;
}

Jet IntrinsicSegment::jet(double t, int order) const {
  const Piece& piece = piece_at(t);
  const double v = (t - piece.from) / piece.width;
  return jet_at(piece, v, piece.start + displacement(piece, 0.0, v), order);
}

void IntrinsicSegment::jets(std::span<const double> t, int order, std::span<Jet> out) const {
  const Piece* last = nullptr;
  double last_v = 0.0;
  Vec2 position;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const Piece& piece = piece_at(t[i]);
    const double v = (t[i] - piece.from) / piece.width;
    const bool onward = last == &piece && v >= last_v;
    position =
        onward ? Vec2(position + displacement(piece, last_v, v)) : Vec2(piece.start + displacement(piece, 0.0, v));
    out[i] = jet_at(piece, v, position, order);
    last = &piece;
    last_v = v;
  }
}

SegmentPtr IntrinsicSegment::placed(const Placement& placement) const {
  IntrinsicForm form = form_;
  form.start = placement(form.start);
  form.length *= placement.scale;
  for (double& curvature : form.control_curvatures) curvature /= placement.scale;
  return std::make_shared<IntrinsicSegment>(std::move(form));
}

}  // namespace kappabench
