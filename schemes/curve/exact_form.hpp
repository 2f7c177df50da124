#pragma once

#include <array>
#include <memory>
#include <variant>
#include <vector>

#include "schemes/curve/vec.hpp"

namespace kappabench {

class Segment;

/// The numbers that define a segment, for exact metrics and for output: nothing else is needed to
/// rebuild it. All are parametrised over t in [0, 1].

/// Bernstein control points, degree + 1 of them, degree 1 to 5.
struct PolynomialForm {
  std::vector<Vec2> control_points;
};

/// Bernstein control points, degree + 1 of them, degree 1 to 5, and as many positive weights:
/// sum w_i B_i(t) p_i / sum w_i B_i(t).
struct RationalForm {
  std::vector<Vec2> control_points;
  std::vector<double> weights;
};

/// Five control points for the quadratic trigonometric basis {u^2, 2uv, 4uw, 2vw, w^2},
/// u = 1 - sin(pi t / 2), v = sin + cos - 1, w = 1 - cos (Miura 2022, Eqs. (14) to (17)).
struct TrigonometricForm {
  std::array<Vec2, 5> control_points;
};

/// Curvature linear in arc length: kappa(s) = curvature + curvature_rate * s, 0 <= s <= length.
struct ClothoidForm {
  Vec2 start;
  double angle;  ///< direction at s = 0, radians
  double curvature;
  double curvature_rate;
  double length;
};

/// Curvature a clamped B-spline over arc length, s = length * t: knots without the outermost pair,
/// as in Yoshida 2022 (number of controls + degree - 1 of them).
struct IntrinsicForm {
  Vec2 start;
  double angle;  ///< direction at t = 0, radians
  double length;
  int degree;
  std::vector<double> knots;
  std::vector<double> control_curvatures;
};

/// cos^2(pi t / 2) * from(t) + sin^2(pi t / 2) * to(t) (Yuksel 2020).
struct BlendForm {
  std::shared_ptr<const Segment> from;
  std::shared_ptr<const Segment> to;
};

/// centre + axis_a cos w + axis_b sin w, w = from + (to - from) t; the half axes are conjugate.
struct EllipticArcForm {
  Vec2 centre;
  Vec2 axis_a;
  Vec2 axis_b;
  double from;  ///< radians
  double to;
};

/// of(x) with x = m t / (1 + (m - 1) t), m = start_speed > 0: the same shape at other speeds.
struct ReparametrizedForm {
  std::shared_ptr<const Segment> of;
  double start_speed;
};

/// Positions and their first two derivatives by t at ascending parameters from 0 to 1; between two of them the quintic
/// that agrees with both. What is measured on it is sampled: the curve that the samples came from is not known.
struct SampledForm {
  std::vector<double> t;
  std::vector<Vec2> position, first, second;
};

/// A segment that can only be evaluated: its metrics are sampled.
struct OpaqueForm {};

using ExactForm = std::variant<PolynomialForm, RationalForm, TrigonometricForm, ClothoidForm, IntrinsicForm, BlendForm,
                               EllipticArcForm, ReparametrizedForm, SampledForm, OpaqueForm>;

}  // namespace kappabench
