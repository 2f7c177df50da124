#include "schemes/pkappa/starts.hpp"

#include "schemes/numerics/bernstein.hpp"
#include "schemes/numerics/block_tridiagonal.hpp"

namespace kappabench::pkappa {

namespace {

/// Chord-length values of t: the share of its part of the polygon that a segment has before its point. Joints are taken
/// to lie halfway between points; where a joint is fixed or an end point, its position is used.
std::vector<double> chord_parameters(const JointChain& chain) {
  const std::size_t n = chain.size();
  std::vector<double> t(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto reach = [&](std::size_t joint, std::size_t neighbour) {
      return chain.freedom[joint] == Freedom::all ? 0.5 * (chain.points[neighbour] - chain.points[i]).norm()
                                                  : (chain.joints[joint].position - chain.points[i]).norm();
    };
    const double before = reach(i, (i + n - 1) % n), after = reach(chain.end_joint(i), (i + 1) % n);
    t[i] = before + after > 0.0 ? before / (before + after) : 0.5;
  }
  return t;
}

/// Unknowns of a block: position and edge of a joint, its second difference or the segment's middle point, and the
/// multiplier of the segment's interpolation; the same for x and y.
constexpr int unknowns = 3, multiplier = 3, block = 4;

template <Continuity K>
using ByUnknowns = Eigen::Matrix<double, Layout<K>::degree + 1, unknowns>;

/// The control points of a segment from the block at its start and the joint in the block at its end.
template <Continuity K>
struct PolygonMap {
  ByUnknowns<K> start = ByUnknowns<K>::Zero(), end = ByUnknowns<K>::Zero();

  PolygonMap() {
    using L = Layout<K>;
    start.template topLeftCorner<L::side, L::vectors>() = coefficients<K>(Joint{}, Side::right);
    if constexpr (L::middle > 0) start(L::side, 2) = 1.0;
    end.template bottomLeftCorner<L::side, L::vectors>() = coefficients<K>(Joint{}, Side::left).colwise().reverse();
  }
};

template <int Degree>
Eigen::Matrix<double, Degree + 1, Degree + 1> bending_matrix() {
  Eigen::Matrix<double, Degree - 1, Degree + 1> d = Eigen::Matrix<double, Degree - 1, Degree + 1>::Zero();
  for (int j = 0; j + 1 < Degree; ++j) d.template block<1, 3>(j, j) << 1.0, -2.0, 1.0;
  return d.transpose() * d;
}

using System = BlockTridiagonal<block>;
using Right = BlockRight<block, 2>;

/// Gives unknown v of block k a value: its row becomes the identity, its column goes to the right-hand sides.
void fix(System& system, std::span<Right> right, std::size_t k, int v, const Vec2& value) {
  const std::size_t blocks = system.size();
  const Eigen::RowVector2d given = value.transpose();
  right[k] -= system.diagonal[k].col(v) * given;
  if (k > 0 || system.cyclic) {
    const std::size_t before = k > 0 ? k - 1 : blocks - 1;
    right[before] -= system.upper[before].col(v) * given;
    system.upper[before].col(v).setZero();
  }
  if (k + 1 < blocks || system.cyclic) {
    const std::size_t after = k + 1 < blocks ? k + 1 : 0;
    right[after] -= system.lower[after].col(v) * given;
    system.lower[after].col(v).setZero();
  }
  system.diagonal[k].row(v).setZero();
  system.diagonal[k].col(v).setZero();
  system.upper[k].row(v).setZero();
  system.lower[k].row(v).setZero();
  system.diagonal[k](v, v) = 1.0;
  right[k].row(v) = given;
}

template <Continuity K>
void fix_joint(const JointChain& chain, std::size_t k, System& system, std::span<Right> right) {
  if (chain.freedom[k] == Freedom::all) return;
  const Joint& joint = chain.joints[k];
  fix(system, right, k, 0, joint.position);
  if (chain.freedom[k] == Freedom::end_point) return;
  fix(system, right, k, 1, joint.edge);
  if constexpr (Layout<K>::second_order) fix(system, right, k, 2, joint.second);
}

}  // namespace

template <Continuity K>
std::optional<JointChain> fair_start(const JointChain& given) {
  JointChain chain = given;
  set_boxes(chain, chord_parameters(chain));
  using L = Layout<K>;
  const std::size_t n = chain.size(), blocks = chain.joints.size();
  const PolygonMap<K> map;
  const auto bending = bending_matrix<L::degree>();
  const Eigen::Matrix3d start_start = map.start.transpose() * bending * map.start,
                        start_end = map.start.transpose() * bending * map.end,
                        end_end = map.end.transpose() * bending * map.end;
  System system;
  system.resize(blocks);
  system.cyclic = chain.cyclic;
  for (std::size_t k = 0; k < blocks; ++k) {
    system.lower[k].setZero();
    system.diagonal[k].setZero();
    system.upper[k].setZero();
  }
  std::vector<Right> right(blocks, Right::Zero());
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = chain.end_joint(i);
    const auto basis = bernstein<L::degree>(chain.t[i]);
    const Eigen::RowVector3d from_start = basis.transpose() * map.start, from_end = basis.transpose() * map.end;
    const double weight = 1.0 / (chain.unit(i) * chain.unit(i));
    system.diagonal[i].topLeftCorner<unknowns, unknowns>() += weight * start_start;
    system.diagonal[j].topLeftCorner<unknowns, unknowns>() += weight * end_end;
    system.upper[i].topLeftCorner<unknowns, unknowns>() += weight * start_end;
    system.lower[j].topLeftCorner<unknowns, unknowns>() += weight * start_end.transpose();
    system.diagonal[i].block<1, unknowns>(multiplier, 0) += from_start;
    system.diagonal[i].block<unknowns, 1>(0, multiplier) += from_start.transpose();
    system.upper[i].block<1, unknowns>(multiplier, 0) += from_end;
    system.lower[j].block<unknowns, 1>(0, multiplier) += from_end.transpose();
    right[i].row(multiplier) += chain.points[i].transpose();
  }
  for (std::size_t k = 0; k < blocks; ++k) fix_joint<K>(chain, k, system, right);
  if (!chain.cyclic) {
    // The last block has no segment.
    fix(system, right, n, multiplier, Vec2::Zero());
    if constexpr (L::middle > 0) fix(system, right, n, 2, Vec2::Zero());
  }
  BlockTridiagonalSolver<block, 2> solver;
  if (!solver.solve(system, right)) return std::nullopt;
  for (std::size_t k = 0; k < blocks; ++k) {
    Joint& joint = chain.joints[k];
    if (chain.freedom[k] == Freedom::none) continue;
    joint = {.position = right[k].row(0), .edge = right[k].row(1)};
    if constexpr (L::second_order) joint.second = right[k].row(2);
  }
  if constexpr (L::middle > 0) {
    chain.middles.resize(n);
    for (std::size_t i = 0; i < n; ++i) chain.middles[i] = right[i].row(2);
  }
  if (!restore_interpolation<K>(chain)) return std::nullopt;
  return chain;
}

template <Continuity K>
std::optional<JointChain> polygonal_start(const JointChain& given) {
  JointChain chain = given;
  using L = Layout<K>;
  const std::size_t n = chain.size();
  // Edges from a joint to the point beside it: 2 of a quintic (c_2 is the point), 1 of a quartic (c_2 is the middle).
  constexpr double edges = L::second_order ? 2.0 : 1.5;
  set_boxes(chain, std::vector<double>(n, 0.5));
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    Joint& joint = chain.joints[k];
    if (chain.freedom[k] == Freedom::none) continue;
    if (chain.freedom[k] == Freedom::all) {
      const Vec2 &before = chain.points[(k + n - 1) % n], &after = chain.points[k];
      joint = {.position = 0.5 * (before + after), .edge = 0.5 * (after - before) / edges};
    } else {
      const Vec2 chord =
          k == 0 ? Vec2(chain.points.front() - joint.position) : Vec2(joint.position - chain.points.back());
      joint = {.position = joint.position, .edge = chord / edges};
    }
  }
  if constexpr (L::middle > 0) chain.middles = chain.points;
  if (!restore_interpolation<K>(chain)) return std::nullopt;
  return chain;
}

template std::optional<JointChain> polygonal_start<Continuity::c1>(const JointChain&);
template std::optional<JointChain> polygonal_start<Continuity::g1>(const JointChain&);
template std::optional<JointChain> polygonal_start<Continuity::c2>(const JointChain&);
template std::optional<JointChain> polygonal_start<Continuity::g2>(const JointChain&);
template std::optional<JointChain> fair_start<Continuity::c1>(const JointChain&);
template std::optional<JointChain> fair_start<Continuity::g1>(const JointChain&);
template std::optional<JointChain> fair_start<Continuity::c2>(const JointChain&);
template std::optional<JointChain> fair_start<Continuity::g2>(const JointChain&);

}  // namespace kappabench::pkappa
