#pragma once

#include <span>
#include <vector>

#include "schemes/pkappa/joint.hpp"

namespace kappabench::pkappa {

/// What may change at a joint.
enum class Freedom {
  all,        ///< an inner joint
  end_point,  ///< the position of an end of the curve is given, its edge and second difference are free
  none        ///< the neighbour beyond is not to change
};

/// Consecutive segments that are solved for together: the whole curve or a window of it. Segment i goes from joint i
/// to joint i + 1, with wrap-around if cyclic, and passes `points[i]` at `t[i]`.
struct JointChain {
  std::vector<Joint> joints;  ///< one more than segments; as many if cyclic
  std::vector<Freedom> freedom;
  std::vector<Vec2> middles;  ///< the middle control points of quartic segments
  std::vector<double> t;
  std::vector<double> t_least, t_most;  ///< Wang 2024, Section 4.2: [t^/2, (t^+1)/2]
  std::vector<Vec2> points;
  std::vector<double> units;  ///< of length in the energy of each segment; empty where all are 1
  bool cyclic = false;

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] std::size_t end_joint(std::size_t segment) const {
    return cyclic && segment + 1 == size() ? 0 : segment + 1;
  }
  [[nodiscard]] double unit(std::size_t segment) const { return units.empty() ? 1.0 : units[segment]; }
  /// The smaller one of the segments that meet there: how far a joint may go without spoiling either.
  [[nodiscard]] double joint_unit(std::size_t joint) const;
};

/// Sets the boxes of t from initial values.
void set_boxes(JointChain& chain, std::span<const double> initial_t);

template <Continuity K>
[[nodiscard]] ControlPolygon<Layout<K>::degree> polygon(const JointChain& chain, std::size_t segment);

/// Moves joints and middle points as little as possible (in the least-squares sense, over their units) so that every
/// segment passes its point at its t. False if that is impossible. Linear in the number of segments.
template <Continuity K>
[[nodiscard]] bool restore_interpolation(JointChain& chain);

/// The chain through given control polygons: joints between them, fixed or end points at the two ends.
template <Continuity K>
[[nodiscard]] JointChain chain_of(std::span<const ControlPolygon<Layout<K>::degree>> polygons,
                                  std::span<const double> t, std::span<const Vec2> points, Freedom first, Freedom last);

}  // namespace kappabench::pkappa
