#pragma once

#include <Eigen/Core>
#include <cmath>

#include "schemes/curve/curve.hpp"
#include "schemes/pkappa/segment_energy.hpp"

namespace kappabench::pkappa {

/// What two segments share where they meet: with l = exp(ratio / 2),
///   last edge of the left segment    L / l,   its last second difference   W / l^2 - (shift / 2) L,
///   first edge of the right segment  L l,     its first second difference  W l^2 + (shift / 2) L.
/// That is all of G2 (Wang 2024, Section 3.3, with alpha = l^2); ratio = shift = 0 is C2; without W it is G1 and C1.
/// Written so that reversing the curve only changes signs.
struct Joint {
  Vec2 position = Vec2::Zero();
  Vec2 edge = Vec2::Zero();    ///< L
  Vec2 second = Vec2::Zero();  ///< W
  double ratio = 0.0;
  double shift = 0.0;
};

/// How a continuity is built: the degree of its segments and the numbers of its joints. Quartic segments have one
/// control point more than their two joints give, the middle one.
template <Continuity K>
struct Layout {
  static_assert(K == Continuity::c1 || K == Continuity::g1 || K == Continuity::c2 || K == Continuity::g2);
  static constexpr bool second_order = K == Continuity::c2 || K == Continuity::g2;
  static constexpr bool geometric = K == Continuity::g1 || K == Continuity::g2;
  static constexpr int degree = second_order ? 5 : 4;
  static constexpr int side = second_order ? 3 : 2;  ///< control points that a joint gives to each side
  static constexpr int vectors = side;               ///< position, edge and perhaps second
  static constexpr int joint = 2 * vectors + (geometric ? (second_order ? 2 : 1) : 0);
  static constexpr int middle = second_order ? 0 : 2;
  /// A block of unknowns: the joint at the start of a segment, its middle point, t_i, and the two multipliers of
  /// P(t_i) = p_i.
  static constexpr int middle_at = joint;
  static constexpr int parameter_at = joint + middle;
  static constexpr int multiplier_at = parameter_at + 1;
  static constexpr int block = multiplier_at + 2;
};

/// The coefficients with which a joint's vectors enter the control points on one side: row i is the i-th control
/// point counted from the joint, columns are position, edge and second.
template <Continuity K>
using SideCoefficients = Eigen::Matrix<double, Layout<K>::side, Layout<K>::vectors>;

enum class Side { left, right };

template <Continuity K>
[[nodiscard]] SideCoefficients<K> coefficients(const Joint& joint, Side side) {
  const double sign = side == Side::right ? 1.0 : -1.0;
  const double l = std::exp(sign * 0.5 * joint.ratio);
  SideCoefficients<K> c = SideCoefficients<K>::Zero();
  c.col(0).setOnes();
  c(1, 1) = sign * l;
  if constexpr (Layout<K>::second_order) {
    c(2, 1) = sign * (2.0 * l + 0.5 * joint.shift);
    c(2, 2) = l * l;
  }
  return c;
}

/// The control points that a joint gives to one side, counted from the joint.
template <Continuity K>
[[nodiscard]] Eigen::Matrix<double, 2, Layout<K>::side> side_points(const Joint& joint, Side side) {
  Eigen::Matrix<double, 2, Layout<K>::vectors> vectors;
  vectors.col(0) = joint.position;
  vectors.col(1) = joint.edge;
  if constexpr (Layout<K>::second_order) vectors.col(2) = joint.second;
  return vectors * coefficients<K>(joint, side).transpose();
}

/// Derivatives of the same control points (x, y of each in turn) to the joint's numbers.
template <Continuity K>
[[nodiscard]] Eigen::Matrix<double, 2 * Layout<K>::side, Layout<K>::joint> side_derivatives(const Joint& joint,
                                                                                            Side side) {
  using L = Layout<K>;
  const SideCoefficients<K> c = coefficients<K>(joint, side);
  Eigen::Matrix<double, 2 * L::side, L::joint> d = Eigen::Matrix<double, 2 * L::side, L::joint>::Zero();
  for (int i = 0; i < L::side; ++i)
    for (int v = 0; v < L::vectors; ++v) d(2 * i, 2 * v) = d(2 * i + 1, 2 * v + 1) = c(i, v);
  if constexpr (L::geometric) {
    const double sign = side == Side::right ? 1.0 : -1.0;
    const double l = std::exp(sign * 0.5 * joint.ratio);
    constexpr int by_ratio = 2 * L::vectors;
    d.template block<2, 1>(2, by_ratio) = 0.5 * l * joint.edge;
    if constexpr (L::second_order) {
      d.template block<2, 1>(4, by_ratio) = l * joint.edge + sign * l * l * joint.second;
      d.template block<2, 1>(4, by_ratio + 1) = sign * 0.5 * joint.edge;
    }
  }
  return d;
}

/// The second derivatives of `pull . side points` to the joint's numbers, `pull` a vector for each control point.
template <Continuity K>
[[nodiscard]] Eigen::Matrix<double, Layout<K>::joint, Layout<K>::joint> side_curvature(
    const Joint& joint, Side side, const Eigen::Matrix<double, 2, Layout<K>::side>& pull) {
  using L = Layout<K>;
  Eigen::Matrix<double, L::joint, L::joint> h = Eigen::Matrix<double, L::joint, L::joint>::Zero();
  if constexpr (L::geometric) {
    const double sign = side == Side::right ? 1.0 : -1.0;
    const double l = std::exp(sign * 0.5 * joint.ratio);
    constexpr int edge = 2, second = 4, ratio = 2 * L::vectors;
    h(ratio, ratio) = 0.25 * sign * l * pull.col(1).dot(joint.edge);
    h.template block<2, 1>(edge, ratio) = 0.5 * l * pull.col(1);
    if constexpr (L::second_order) {
      h(ratio, ratio) += pull.col(2).dot(0.5 * sign * l * joint.edge + l * l * joint.second);
      h.template block<2, 1>(edge, ratio) += l * pull.col(2);
      h.template block<2, 1>(second, ratio) = sign * l * l * pull.col(2);
      h.template block<2, 1>(edge, ratio + 1) = 0.5 * sign * pull.col(2);
    }
    h.template bottomRows<L::joint - ratio>().template leftCols<ratio>() =
        h.template topRows<ratio>().template rightCols<L::joint - ratio>().transpose();
  }
  return h;
}

/// The joint of two control polygons that meet. Where they do not have the continuity K exactly, one between them.
template <Continuity K>
[[nodiscard]] Joint joint_between(const ControlPolygon<Layout<K>::degree>& left,
                                  const ControlPolygon<Layout<K>::degree>& right);

/// The joint that gives `right` its first control points, or `left` its last ones, and is free of ratio and shift:
/// for the ends of a chain.
template <Continuity K>
[[nodiscard]] Joint joint_at_start(const ControlPolygon<Layout<K>::degree>& right);
template <Continuity K>
[[nodiscard]] Joint joint_at_end(const ControlPolygon<Layout<K>::degree>& left);

}  // namespace kappabench::pkappa
