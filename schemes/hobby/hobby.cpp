#include "schemes/hobby/hobby.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "schemes/numerics/block_tridiagonal.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/spans.hpp"

namespace kappabench {

SchemeInfo Hobby::describe() {
  return {
      .id = "hobby",
      .title = "Hobby's spline, the path of METAPOST",
      .citation =
          "Hobby, Smooth, easy to compute interpolating splines, Discrete and Computational Geometry 1, 1986; Knuth, "
          "METAFONT: The Program, 1986",
      .parameters = {{.name = "tension",
                      .default_value = 1.0,
                      .help = "of all pieces: larger is closer to the polygon",
                      .least = 0.75,
                      .most = 1e3},
                     {.name = "curl",
                      .default_value = 1.0,
                      .help = "mock curvature at an open end over that at the next point",
                      .least = 0.0,
                      .most = 1e3}},
      .traits = {.fewest_open_points = 2,
                 .continuity = Continuity::g1,
                 .continuity_exceptions = "points where the speed vanishes"},
      .version = 2};
}

Hobby::Hobby(Parameters parameters) : Scheme(describe(), std::move(parameters)) {}

namespace {

using std::numbers::pi;
using std::numbers::sqrt2;

double half_turn(double angle) { return std::remainder(angle, 2.0 * pi); }

/// The polygon: chord k leads from point k to the next one.
struct Polygon {
  std::vector<double> length, direction;  ///< of the chords
  std::vector<double> turning;            ///< psi_k, from chord k - 1 to chord k; 0 at open ends
  bool closed;
};

Polygon polygon_of(const Input& input) {
  const std::size_t n = input.points.size(), chords = input.closed ? n : n - 1;
  Polygon polygon{{}, {}, std::vector<double>(n, 0.0), input.closed};
  for (std::size_t k = 0; k < chords; ++k) {
    const Vec2 chord = input.points[(k + 1) % n] - input.points[k];
    polygon.length.push_back(chord.norm());
    polygon.direction.push_back(std::atan2(chord.y(), chord.x()));
  }
  for (std::size_t k = input.closed ? 0 : 1; k < chords; ++k)
    polygon.turning[k] = half_turn(polygon.direction[k] - polygon.direction[(k + chords - 1) % chords]);
  return polygon;
}

/// A direction that the user gave at point k, as theta_k from the chord after it and phi_k to the chord before it.
struct Given {
  std::optional<double> theta, phi;
};

Given given_at(const Input& input, const Polygon& polygon, std::size_t k) {
  const auto& tangent = input.options_of(static_cast<int>(k)).tangent;
  if (!tangent) return {};
  Given given;
  if (k < polygon.direction.size()) given.theta = half_turn(*tangent - polygon.direction[k]);
  if (k > 0) given.phi = half_turn(polygon.direction[k - 1] - *tangent);
  if (k == 0 && polygon.closed) given.phi = half_turn(polygon.direction.back() - *tangent);
  return given;
}

/// theta_k from chord k to the tangent at its start and phi_k from the tangent at its end to chord k - 1, with
/// theta_k + phi_k + psi_k = 0.
struct Offsets {
  std::vector<double> theta, phi;
  double residual;  ///< of the linear system, over its right-hand side
};

/// Mock curvature, the part of curvature that is linear in the angles, is 2 tension^2 / d times
/// (theta_k + phi_{k+1}) / tension - 3 theta_k after point k and ... - 3 phi_{k+1} before point k + 1. With g = 3 - 1 /
/// tension and s = 1 / tension, its continuity at point k is
///   s theta_{k-1} / d_{k-1} + g (1 / d_{k-1} + 1 / d_k) theta_k + s theta_{k+1} / d_k
///     = -g psi_k / d_{k-1} - s psi_{k+1} / d_k.
/// At an open end it is `curl` times that at the next point: (g + curl s) theta_0 = (s + curl g) phi_1.
std::optional<Offsets> solve_offsets(const Input& input, Polygon polygon, double tension, double curl) {
  const std::size_t n = input.points.size(), chords = polygon.length.size();
  const double s = 1.0 / tension, g = 3.0 - s, end = g + curl * s, next = s + curl * g;
  std::vector<Given> given(n);
  for (std::size_t k = 0; k < n; ++k) {
    given[k] = given_at(input, polygon, k);
    // The two angles may differ from -psi_k by a turn.
    if (given[k].theta && given[k].phi) polygon.turning[k] = -*given[k].theta - *given[k].phi;
    if (!given[k].theta && given[k].phi) given[k].theta = -*given[k].phi;  // the last point, where psi = 0
  }
  const std::vector<double>& psi = polygon.turning;

  BlockTridiagonal<1> matrix;
  matrix.resize(n);
  matrix.cyclic = polygon.closed;
  std::vector<BlockRight<1, 1>> x(n);
  const auto row = [&](std::size_t k, double lower, double diagonal, double upper, double right) {
    matrix.lower[k](0) = lower;
    matrix.diagonal[k](0) = diagonal;
    matrix.upper[k](0) = upper;
    x[k](0) = right;
  };
  for (std::size_t k = 0; k < n; ++k) {
    if (given[k].theta) {
      row(k, 0.0, 1.0, 0.0, *given[k].theta);
    } else if (!polygon.closed && k == 0) {
      row(k, 0.0, end, next, -next * psi[1]);  // phi_1 = -psi_1 - theta_1
    } else if (!polygon.closed && k == n - 1) {
      row(k, next, end, 0.0, 0.0);  // phi = -theta
    } else {
      // Times the shorter chord: without unit, as the other rows are.
      const double d0 = polygon.length[(k + chords - 1) % chords], d1 = polygon.length[k], shorter = std::min(d0, d1);
      const double before = shorter / d0, after = shorter / d1;
      row(k, s * before, g * (before + after), s * after, -g * psi[k] * before - s * psi[(k + 1) % n] * after);
    }
  }
  std::vector<double> right(n);
  for (std::size_t k = 0; k < n; ++k) right[k] = x[k](0);
  // Curl 1 at both ends of one chord leaves its shape open: METAPOST makes it straight.
  const bool one_free_chord = n == 2 && !given[0].theta && !given[1].theta;
  if (one_free_chord) x[0](0) = x[1](0) = 0.0;
  if (BlockTridiagonalSolver<1> solver; !one_free_chord && !solver.solve(matrix, std::span(x))) return std::nullopt;

  Offsets offsets{std::vector<double>(n), std::vector<double>(n), 0.0};
  double error = 0.0, scale = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    offsets.theta[k] = x[k](0);
    offsets.phi[k] = -psi[k] - x[k](0);
    const double product = matrix.lower[k](0) * x[(k + n - 1) % n](0) + matrix.diagonal[k](0) * x[k](0) +
                           matrix.upper[k](0) * x[(k + 1) % n](0);
    error = std::max(error, std::abs(product - right[k]));
    scale = std::max(scale, std::abs(right[k]));
  }
  offsets.residual = scale > 0.0 ? error / scale : 0.0;
  return offsets;
}

/// Hobby's velocity: the length of the first leg of a piece over its chord, for tension 1. Bounded by 4 as in METAPOST.
double velocity(double theta, double phi) {
  const double st = std::sin(theta), ct = std::cos(theta), sf = std::sin(phi), cf = std::cos(phi);
  const double sqrt5 = std::sqrt(5.0);
  const double top = 2.0 + sqrt2 * (st - sf / 16.0) * (sf - st / 16.0) * (ct - cf);
  const double bottom = 3.0 * (1.0 + 0.5 * (sqrt5 - 1.0) * ct + 0.5 * (3.0 - sqrt5) * cf);
  return top < 4.0 * bottom ? top / bottom : 4.0;
}

SegmentPtr piece(const Vec2& p0, const Vec2& p1, double theta, double phi, double tension) {
  const auto turned = [](const Vec2& v, double angle) -> Vec2 {
    return v * std::cos(angle) + left_normal(v) * std::sin(angle);
  };
  const Vec2 chord = p1 - p0;
  const Vec2 first = p0 + turned(chord, theta) * (velocity(theta, phi) / tension);
  const Vec2 second = p1 - turned(chord, -phi) * (velocity(phi, theta) / tension);
  return std::make_shared<PolynomialSegment>(std::array<Vec2, 4>{p0, first, second, p1});
}

}  // namespace

Fit Hobby::solve(const Input& input) const {
  const double tension = parameters().real("tension");
  const auto offsets = solve_offsets(input, polygon_of(input), tension, parameters().real("curl"));
  if (!offsets)
    return {
        .input = input,
        .curve = std::nullopt,
        .report = {.outcome = Outcome::failed, .message = "the linear system for the tangents could not be solved"}};
  const std::size_t n = input.points.size();
  std::vector<SpanPieces> spans;
  for (std::size_t k = 0; k < (input.closed ? n : n - 1); ++k) {
    const std::size_t next = (k + 1) % n;
    spans.push_back(
        {.segments = {piece(input.points[k], input.points[next], offsets->theta[k], offsets->phi[next], tension)},
         .inside = Continuity::g1,
         .at_end = Continuity::g1});
  }
  return {.input = input,
          .curve = curve_of_spans(std::move(spans), input.closed),
          .report = {.outcome = Outcome::converged, .residual = offsets->residual}};
}

void register_hobby(Registry& registry) { registry.add<Hobby>(); }

}  // namespace kappabench
