#include "schemes/pkappa/joint_chain.hpp"

#include <algorithm>
#include <array>

#include "schemes/numerics/bernstein.hpp"
#include "schemes/numerics/block_tridiagonal.hpp"

namespace kappabench::pkappa {

double JointChain::joint_unit(std::size_t joint) const {
  if (units.empty()) return 1.0;
  const std::size_t n = size();
  if (!cyclic && joint == 0) return units.front();
  if (!cyclic && joint == n) return units.back();
  return std::min(units[(joint + n - 1) % n], units[joint]);
}

void set_boxes(JointChain& chain, std::span<const double> initial_t) {
  chain.t.assign(initial_t.begin(), initial_t.end());
  chain.t_least.clear();
  chain.t_most.clear();
  for (const double t : initial_t) {
    chain.t_least.push_back(0.5 * t);
    chain.t_most.push_back(0.5 * (t + 1.0));
  }
}

template <Continuity K>
ControlPolygon<Layout<K>::degree> polygon(const JointChain& chain, std::size_t segment) {
  using L = Layout<K>;
  ControlPolygon<L::degree> control;
  control.template leftCols<L::side>() = side_points<K>(chain.joints[segment], Side::right);
  if constexpr (L::middle > 0) control.col(L::side) = chain.middles[segment];
  control.template rightCols<L::side>() =
      side_points<K>(chain.joints[chain.end_joint(segment)], Side::left).rowwise().reverse();
  return control;
}

namespace {

/// How the point at t_i of a segment depends on what may move: the vectors of its two joints and its middle point.
template <Continuity K>
struct PointCoefficients {
  Eigen::Matrix<double, Layout<K>::vectors, 1> start, end;
  double middle = 0.0;
};

template <Continuity K>
void keep_free(Eigen::Matrix<double, Layout<K>::vectors, 1>& coefficients, Freedom freedom) {
  if (freedom == Freedom::none) coefficients.setZero();
  if (freedom == Freedom::end_point) coefficients[0] = 0.0;
}

template <Continuity K>
PointCoefficients<K> point_coefficients(const JointChain& chain, std::size_t i) {
  using L = Layout<K>;
  const auto basis = bernstein<L::degree>(chain.t[i]);
  const std::size_t next = chain.end_joint(i);
  PointCoefficients<K> c;
  c.start = coefficients<K>(chain.joints[i], Side::right).transpose() * basis.template head<L::side>();
  c.end = coefficients<K>(chain.joints[next], Side::left).transpose() * basis.template tail<L::side>().reverse();
  if constexpr (L::middle > 0) c.middle = basis[L::side];
  keep_free<K>(c.start, chain.freedom[i]);
  keep_free<K>(c.end, chain.freedom[next]);
  return c;
}

template <Continuity K>
void move(Joint& joint, const Eigen::Matrix<double, Layout<K>::vectors, 1>& coefficients, const Vec2& by) {
  joint.position += coefficients[0] * by;
  joint.edge += coefficients[1] * by;
  if constexpr (Layout<K>::second_order) joint.second += coefficients[2] * by;
}

}  // namespace

template <Continuity K>
bool restore_interpolation(JointChain& chain) {
  using L = Layout<K>;
  const std::size_t n = chain.size();
  std::vector<PointCoefficients<K>> a;
  a.reserve(n);
  for (std::size_t i = 0; i < n; ++i) a.push_back(point_coefficients<K>(chain, i));

  // The least change is D A^T y with A D A^T y = miss, D the squared units; neighbours share a joint, so A D A^T is
  // tridiagonal.
  std::vector<double> joint_weights;
  for (std::size_t k = 0; k < chain.joints.size(); ++k)
    joint_weights.push_back(chain.joint_unit(k) * chain.joint_unit(k));
  const auto middle_weight = [&](std::size_t i) { return chain.unit(i) * chain.unit(i); };
  BlockTridiagonal<1> gram;
  gram.resize(n);
  gram.cyclic = chain.cyclic;
  std::vector<BlockRight<1, 2>> y(n);
  for (std::size_t i = 0; i < n; ++i) {
    gram.diagonal[i](0, 0) = joint_weights[i] * a[i].start.squaredNorm() +
                             joint_weights[chain.end_joint(i)] * a[i].end.squaredNorm() +
                             middle_weight(i) * a[i].middle * a[i].middle;
    const std::size_t next = chain.cyclic && i + 1 == n ? 0 : i + 1;
    if (next < n) gram.upper[i](0, 0) = gram.lower[next](0, 0) = joint_weights[next] * a[i].end.dot(a[next].start);
    y[i] = (chain.points[i] - polygon<K>(chain, i) * bernstein<L::degree>(chain.t[i])).transpose();
  }
  BlockTridiagonalSolver<1, 2> solver;
  if (!solver.solve(gram, y)) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 by = y[i].transpose();
    const std::size_t j = chain.end_joint(i);
    move<K>(chain.joints[i], a[i].start, joint_weights[i] * by);
    move<K>(chain.joints[j], a[i].end, joint_weights[j] * by);
    if constexpr (L::middle > 0) chain.middles[i] += middle_weight(i) * a[i].middle * by;
  }
  return true;
}

template <Continuity K>
JointChain chain_of(std::span<const ControlPolygon<Layout<K>::degree>> polygons, std::span<const double> t,
                    std::span<const Vec2> points, Freedom first, Freedom last) {
  JointChain chain;
  chain.points.assign(points.begin(), points.end());
  set_boxes(chain, t);
  chain.joints.push_back(joint_at_start<K>(polygons.front()));
  chain.freedom.push_back(first);
  for (std::size_t i = 0; i + 1 < polygons.size(); ++i) {
    chain.joints.push_back(joint_between<K>(polygons[i], polygons[i + 1]));
    chain.freedom.push_back(Freedom::all);
  }
  chain.joints.push_back(joint_at_end<K>(polygons.back()));
  chain.freedom.push_back(last);
  if constexpr (Layout<K>::middle > 0)
    for (const auto& control : polygons) chain.middles.push_back(control.col(Layout<K>::side));
  return chain;
}

template ControlPolygon<4> polygon<Continuity::c1>(const JointChain&, std::size_t);
template ControlPolygon<4> polygon<Continuity::g1>(const JointChain&, std::size_t);
template ControlPolygon<5> polygon<Continuity::c2>(const JointChain&, std::size_t);
template ControlPolygon<5> polygon<Continuity::g2>(const JointChain&, std::size_t);
template bool restore_interpolation<Continuity::c1>(JointChain&);
template bool restore_interpolation<Continuity::g1>(JointChain&);
template bool restore_interpolation<Continuity::c2>(JointChain&);
template bool restore_interpolation<Continuity::g2>(JointChain&);
template JointChain chain_of<Continuity::c1>(std::span<const ControlPolygon<4>>, std::span<const double>,
                                             std::span<const Vec2>, Freedom, Freedom);
template JointChain chain_of<Continuity::g1>(std::span<const ControlPolygon<4>>, std::span<const double>,
                                             std::span<const Vec2>, Freedom, Freedom);
template JointChain chain_of<Continuity::c2>(std::span<const ControlPolygon<5>>, std::span<const double>,
                                             std::span<const Vec2>, Freedom, Freedom);
template JointChain chain_of<Continuity::g2>(std::span<const ControlPolygon<5>>, std::span<const double>,
                                             std::span<const Vec2>, Freedom, Freedom);

}  // namespace kappabench::pkappa
