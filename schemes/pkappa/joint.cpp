#include "schemes/pkappa/joint.hpp"

namespace kappabench::pkappa {

template <Continuity K>
Joint joint_at_start(const ControlPolygon<Layout<K>::degree>& right) {
  Joint joint{.position = right.col(0), .edge = right.col(1) - right.col(0)};
  if constexpr (Layout<K>::second_order) joint.second = right.col(2) - 2.0 * right.col(1) + right.col(0);
  return joint;
}

template <Continuity K>
Joint joint_at_end(const ControlPolygon<Layout<K>::degree>& left) {
  constexpr int k = Layout<K>::degree;
  Joint joint{.position = left.col(k), .edge = left.col(k) - left.col(k - 1)};
  if constexpr (Layout<K>::second_order) joint.second = left.col(k) - 2.0 * left.col(k - 1) + left.col(k - 2);
  return joint;
}

template <Continuity K>
Joint joint_between(const ControlPolygon<Layout<K>::degree>& left, const ControlPolygon<Layout<K>::degree>& right) {
  const Joint before = joint_at_end<K>(left), after = joint_at_start<K>(right);
  Joint joint{.position = 0.5 * (before.position + after.position),
              .edge = 0.5 * (before.edge + after.edge),
              .second = 0.5 * (before.second + after.second)};
  if constexpr (Layout<K>::geometric) {
    const double a = before.edge.norm(), b = after.edge.norm();
    if (a > 0.0 && b > 0.0) {
      joint.ratio = std::log(b / a);
      const double l = std::sqrt(b / a);
      joint.edge = 0.5 * (before.edge * l + after.edge / l);
      joint.second = (before.second + after.second) / (l * l + 1.0 / (l * l));
      const double squared = joint.edge.squaredNorm();
      if (Layout<K>::second_order && squared > 0.0)
        joint.shift = 2.0 * (after.second - l * l * joint.second).dot(joint.edge) / squared;
    }
  }
  return joint;
}

template Joint joint_at_start<Continuity::c1>(const ControlPolygon<4>&);
template Joint joint_at_start<Continuity::g1>(const ControlPolygon<4>&);
template Joint joint_at_start<Continuity::c2>(const ControlPolygon<5>&);
template Joint joint_at_start<Continuity::g2>(const ControlPolygon<5>&);
template Joint joint_at_end<Continuity::c1>(const ControlPolygon<4>&);
template Joint joint_at_end<Continuity::g1>(const ControlPolygon<4>&);
template Joint joint_at_end<Continuity::c2>(const ControlPolygon<5>&);
template Joint joint_at_end<Continuity::g2>(const ControlPolygon<5>&);
template Joint joint_between<Continuity::c1>(const ControlPolygon<4>&, const ControlPolygon<4>&);
template Joint joint_between<Continuity::g1>(const ControlPolygon<4>&, const ControlPolygon<4>&);
template Joint joint_between<Continuity::c2>(const ControlPolygon<5>&, const ControlPolygon<5>&);
template Joint joint_between<Continuity::g2>(const ControlPolygon<5>&, const ControlPolygon<5>&);

}  // namespace kappabench::pkappa
