#include "schemes/pkappa/system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "schemes/numerics/bernstein.hpp"

namespace kappabench::pkappa {
namespace {

constexpr double not_held = std::numeric_limits<double>::quiet_NaN();

}  // namespace

template <Continuity K>
double ChainSystem<K>::value(const Chain& chain) {
  double sum = 0.0;
  for (std::size_t i = 0; i < chain.size(); ++i)
    sum += energy_.terms(polygon<K>(chain, i), chain.t[i]).weighted(weights_);
  return sum;
}

template <Continuity K>
double ChainSystem<K>::linearise(const Chain& chain, const Step& last) {
  const std::size_t n = chain.size(), blocks = chain.joints.size();
  matrix_.resize(blocks);
  matrix_.cyclic = chain.cyclic;
  gradient_.assign(blocks, Vector::Zero());
  for (std::size_t k = 0; k < blocks; ++k) {
    matrix_.lower[k].setZero();
    matrix_.diagonal[k].setZero();
    matrix_.upper[k].setZero();
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    energy_.normal(polygon<K>(chain, i), chain.t[i], weights_, normal_);
    sum += normal_.terms.weighted(weights_);
    add_segment(chain, i);
    add_constraint(chain, i);
    if (exact_)
      add_curvature(chain, i,
                    last.empty() ? Vec2::Zero() : Vec2(last[i].template segment<2>(Layout<K>::multiplier_at)));
  }
  scale_damping();
  return sum;
}

/// The energy of segment i, from its control points to the unknowns.
template <Continuity K>
void ChainSystem<K>::add_segment(const Chain& chain, std::size_t i) {
  using L = Layout<K>;
  constexpr int side = 2 * L::side, own = L::middle + 1, size = SegmentNormal<L::degree>::size;
  const std::size_t j = chain.end_joint(i);
  const auto start = side_derivatives<K>(chain.joints[i], Side::right);
  auto mirrored = side_derivatives<K>(chain.joints[j], Side::left);
  Eigen::Matrix<double, side, L::joint> end;
  for (int c = 0; c < L::side; ++c)
    end.template middleRows<2>(2 * c) = mirrored.template middleRows<2>(2 * (L::side - 1 - c));

  // Control points in order: those of the start, the middle, those of the end, then t.
  constexpr int end_at = side + L::middle, t_at = size - 1;
  const auto& h = normal_.hessian;
  const auto& g = normal_.gradient;
  Eigen::Matrix<double, own, own> h_own;
  Eigen::Matrix<double, own, side> h_own_start, h_own_end;
  Eigen::Matrix<double, own, 1> g_own;
  const auto own_row = [](int r) { return r < L::middle ? side + r : t_at; };
  for (int r = 0; r < own; ++r) {
    g_own[r] = g[own_row(r)];
    h_own_start.row(r) = h.template block<1, side>(own_row(r), 0);
    h_own_end.row(r) = h.template block<1, side>(own_row(r), end_at);
    for (int c = 0; c < own; ++c) h_own(r, c) = h(own_row(r), own_row(c));
  }

  auto& at_i = matrix_.diagonal[i];
  auto& at_j = matrix_.diagonal[j];
  const Eigen::Matrix<double, side, L::joint> hs = h.template topLeftCorner<side, side>().lazyProduct(start);
  at_i.template topLeftCorner<L::joint, L::joint>().noalias() += start.transpose().lazyProduct(hs);
  const Eigen::Matrix<double, own, L::joint> mixed = h_own_start.lazyProduct(start);
  at_i.template block<own, L::joint>(L::middle_at, 0) += mixed;
  at_i.template block<L::joint, own>(0, L::middle_at) += mixed.transpose();
  at_i.template block<own, own>(L::middle_at, L::middle_at) += h_own;

  const Eigen::Matrix<double, side, L::joint> he = h.template block<side, side>(end_at, end_at).lazyProduct(end);
  at_j.template topLeftCorner<L::joint, L::joint>().noalias() += end.transpose().lazyProduct(he);

  Eigen::Matrix<double, L::joint + own, L::joint> across;
  const Eigen::Matrix<double, side, L::joint> hse = h.template block<side, side>(0, end_at).lazyProduct(end);
  across.template topRows<L::joint>().noalias() = start.transpose().lazyProduct(hse);
  across.template bottomRows<own>() = h_own_end.lazyProduct(end);
  matrix_.upper[i].template topLeftCorner<L::joint + own, L::joint>() += across;
  matrix_.lower[j].template topLeftCorner<L::joint, L::joint + own>() += across.transpose();

  gradient_[i].template head<L::joint>() += start.transpose() * g.template head<side>();
  gradient_[i].template segment<own>(L::middle_at) += g_own;
  gradient_[j].template head<L::joint>() += end.transpose() * g.template segment<side>(end_at);
}

/// P_i(t_i) = p_i to first order; the chain satisfies it, so the right-hand side is zero.
template <Continuity K>
void ChainSystem<K>::add_constraint(const Chain& chain, std::size_t i) {
  using L = Layout<K>;
  constexpr int side = 2 * L::side;
  const std::size_t j = chain.end_joint(i);
  const auto basis = bernstein<L::degree>(chain.t[i]);
  Eigen::Matrix<double, 2, side> from_start = Eigen::Matrix<double, 2, side>::Zero(), from_end = from_start;
  for (int c = 0; c < L::side; ++c) {
    from_start.template middleCols<2>(2 * c).diagonal().setConstant(basis[c]);
    from_end.template middleCols<2>(2 * c).diagonal().setConstant(basis[L::degree - c]);
  }
  Eigen::Matrix<double, 2, block> row = Eigen::Matrix<double, 2, block>::Zero();
  row.template leftCols<L::joint>() = from_start * side_derivatives<K>(chain.joints[i], Side::right);
  if constexpr (L::middle > 0) row.template middleCols<2>(L::middle_at).diagonal().setConstant(basis[L::side]);
  row.col(L::parameter_at) = polygon<K>(chain, i) * bernstein_derivatives<L::degree>(chain.t[i], 1);
  const Eigen::Matrix<double, 2, L::joint> next = from_end * side_derivatives<K>(chain.joints[j], Side::left);

  constexpr int m = L::multiplier_at;
  matrix_.diagonal[i].template middleRows<2>(m) += row;
  matrix_.diagonal[i].template middleCols<2>(m) += row.transpose();
  matrix_.upper[i].template block<2, L::joint>(m, 0) += next;
  matrix_.lower[j].template block<L::joint, 2>(0, m) += next.transpose();
}

/// How the control points bend with the joints' numbers, pulled by the energy and the multiplier, and how the
/// interpolated point bends with t.
template <Continuity K>
void ChainSystem<K>::add_curvature(const Chain& chain, std::size_t i, const Vec2& multiplier) {
  using L = Layout<K>;
  const std::size_t j = chain.end_joint(i);
  const auto basis = bernstein<L::degree>(chain.t[i]);
  const auto slope = bernstein_derivatives<L::degree>(chain.t[i], 1);
  if constexpr (L::geometric) {
    Eigen::Matrix<double, 2, L::side> at_start, at_end;
    for (int c = 0; c < L::side; ++c) {
      at_start.col(c) = normal_.gradient.template segment<2>(2 * c) + basis[c] * multiplier;
      at_end.col(c) = normal_.gradient.template segment<2>(2 * (L::degree - c)) + basis[L::degree - c] * multiplier;
    }
    matrix_.diagonal[i].template topLeftCorner<L::joint, L::joint>() +=
        side_curvature<K>(chain.joints[i], Side::right, at_start);
    matrix_.diagonal[j].template topLeftCorner<L::joint, L::joint>() +=
        side_curvature<K>(chain.joints[j], Side::left, at_end);
  }

  constexpr int t = L::parameter_at, side = 2 * L::side;
  Eigen::Matrix<double, 1, side> from_start, from_end;
  for (int c = 0; c < L::side; ++c) {
    from_start.template segment<2>(2 * c) = slope[c] * multiplier.transpose();
    from_end.template segment<2>(2 * c) = slope[L::degree - c] * multiplier.transpose();
  }
  Eigen::Matrix<double, 1, block> row = Eigen::Matrix<double, 1, block>::Zero();
  row.template head<L::joint>() = from_start * side_derivatives<K>(chain.joints[i], Side::right);
  if constexpr (L::middle > 0) row.template segment<2>(L::middle_at) = slope[L::side] * multiplier.transpose();
  matrix_.diagonal[i].row(t) += row;
  matrix_.diagonal[i].col(t) += row.transpose();
  matrix_.diagonal[i](t, t) += multiplier.dot(polygon<K>(chain, i) * bernstein_derivatives<L::degree>(chain.t[i], 2));
  const Eigen::Matrix<double, 1, L::joint> next = from_end * side_derivatives<K>(chain.joints[j], Side::left);
  matrix_.upper[i].template block<1, L::joint>(t, 0) += next;
  matrix_.lower[j].template block<L::joint, 1>(0, t) += next.transpose();
}

/// Marquardt's diagonal, the same for both coordinates of a vector so that turning the input turns the result.
template <Continuity K>
void ChainSystem<K>::scale_damping() {
  using L = Layout<K>;
  constexpr double least = 1e-2;
  scale_.assign(matrix_.size(), Vector::Zero());
  for (std::size_t k = 0; k < matrix_.size(); ++k) {
    const auto diagonal = matrix_.diagonal[k].diagonal();
    for (int v = 0; v < L::multiplier_at; ++v) scale_[k][v] = std::abs(diagonal[v]);
    const auto average = [&](int at) {
      scale_[k].template segment<2>(at).setConstant(0.5 * std::abs(diagonal[at] + diagonal[at + 1]));
    };
    for (int v = 0; v < L::vectors; ++v) average(2 * v);
    if constexpr (L::middle > 0) average(L::middle_at);
    for (int v = 0; v < L::multiplier_at; ++v) scale_[k][v] = std::max(scale_[k][v], least);
  }
}

template <Continuity K>
bool ChainSystem<K>::solve(const Chain& chain, double damping, Step& out) {
  using L = Layout<K>;
  const std::size_t n = chain.size(), blocks = matrix_.size();
  damped_ = matrix_;
  out.resize(blocks);
  for (std::size_t k = 0; k < blocks; ++k) {
    damped_.diagonal[k].diagonal() += damping * scale_[k];
    out[k] = -gradient_[k];
  }
  // A t that is held moves its column to the right-hand side; then its row and those of what may not move become
  // identities.
  for (std::size_t i = 0; i < n; ++i) {
    if (std::isnan(held_[i])) continue;
    out[i] -= held_[i] * damped_.diagonal[i].col(L::parameter_at);
    const std::size_t j = chain.end_joint(i);
    out[j] -= held_[i] * damped_.lower[j].col(L::parameter_at);
  }
  for (std::size_t k = 0; k < blocks; ++k) {
    for (int v = 0; v < block; ++v) {
      const bool held_here = v == L::parameter_at && k < n && !std::isnan(held_[k]);
      if (is_free<K>(v, chain.freedom[k], k < n) && !held_here) continue;
      damped_.diagonal[k].row(v).setZero();
      damped_.diagonal[k].col(v).setZero();
      damped_.diagonal[k](v, v) = 1.0;
      damped_.upper[k].row(v).setZero();
      damped_.lower[k].row(v).setZero();
      if (k > 0 || chain.cyclic) damped_.upper[k > 0 ? k - 1 : blocks - 1].col(v).setZero();
      if (k + 1 < blocks || chain.cyclic) damped_.lower[k + 1 < blocks ? k + 1 : 0].col(v).setZero();
      out[k][v] = held_here ? held_[k] : 0.0;
    }
  }
  return solver_.solve(damped_, out);
}

/// The derivative of the damped model by a t that is held, at the end of `step`.
template <Continuity K>
double ChainSystem<K>::slope_of_held(const Chain& chain, std::size_t i, double damping, const Step& step) const {
  constexpr int t = Layout<K>::parameter_at;
  const std::size_t j = chain.end_joint(i);
  return matrix_.diagonal[i].row(t).dot(step[i]) + matrix_.upper[i].row(t).dot(step[j]) +
         damping * scale_[i][t] * step[i][t] + gradient_[i][t];
}

/// The quadratic program in the boxes of t by a primal-dual active set (Hintermueller, Ito, Kunisch 2002): hold every t
/// that would leave, release every one that would rather come back, until nothing changes.
template <Continuity K>
bool ChainSystem<K>::step(const Chain& chain, double damping, Step& out) {
  constexpr int t_at = Layout<K>::parameter_at, most_rounds = 8;
  const std::size_t n = chain.size();
  held_.resize(n, not_held);
  for (std::size_t i = 0; i < n; ++i)
    if (!std::isnan(held_[i]))
      held_[i] = std::clamp(chain.t[i] + held_[i], chain.t_least[i], chain.t_most[i]) - chain.t[i];
  for (int round = 0; round < most_rounds; ++round) {
    if (!solve(chain, damping, out)) return false;
    bool settled = true;
    for (std::size_t i = 0; i < n; ++i) {
      const double t = chain.t[i] + out[i][t_at];
      if (std::isnan(held_[i])) {
        if (t >= chain.t_least[i] && t <= chain.t_most[i]) continue;
        held_[i] = std::clamp(t, chain.t_least[i], chain.t_most[i]) - chain.t[i];
        settled = false;
      } else {
        const bool low = 2.0 * t < chain.t_least[i] + chain.t_most[i];
        const double slope = slope_of_held(chain, i, damping, out);
        if (low ? slope >= 0.0 : slope <= 0.0) continue;
        held_[i] = not_held;
        settled = false;
      }
    }
    if (settled) return true;
  }
  return true;
}

template <Continuity K>
double ChainSystem<K>::predicted_decrease(const Step& step, double damping, std::size_t block_row) const {
  // |r|^2 - |r + J dx|^2 with (J^T J + mu D) dx + A^T y = -J^T r and A dx = 0.
  constexpr int unknowns = Layout<K>::multiplier_at;
  const auto dx = step[block_row].template head<unknowns>();
  return damping * dx.cwiseAbs2().dot(scale_[block_row].template head<unknowns>()) -
         dx.dot(gradient_[block_row].template head<unknowns>());
}

template <Continuity K>
double ChainSystem<K>::predicted_decrease(const Step& step, double damping) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < step.size(); ++k) sum += predicted_decrease(step, damping, k);
  return sum;
}

template <Continuity K>
double ChainSystem<K>::entry(std::size_t block_row, int row, std::size_t block_column, int column) const {
  if (block_row == block_column) return matrix_.diagonal[block_row](row, column);
  if (block_row + 1 == block_column) return matrix_.upper[block_row](row, column);
  return block_column + 1 == block_row ? matrix_.lower[block_row](row, column) : 0.0;
}

template <Continuity K>
bool advance(const Chain& from, const typename ChainSystem<K>::Step& step, Chain& to) {
  using L = Layout<K>;
  to = from;
  for (std::size_t k = 0; k < from.joints.size(); ++k) {
    const auto& dx = step[k];
    Joint& joint = to.joints[k];
    joint.position += dx.template segment<2>(0);
    joint.edge += dx.template segment<2>(2);
    if constexpr (L::second_order) joint.second += dx.template segment<2>(4);
    if constexpr (L::geometric) joint.ratio += dx[2 * L::vectors];
    if constexpr (L::geometric && L::second_order) joint.shift += dx[2 * L::vectors + 1];
    if (k >= from.size()) continue;
    if constexpr (L::middle > 0) to.middles[k] += dx.template segment<2>(L::middle_at);
    to.t[k] = std::clamp(to.t[k] + dx[L::parameter_at], to.t_least[k], to.t_most[k]);
  }
  return restore_interpolation<K>(to);
}

template class ChainSystem<Continuity::c1>;
template class ChainSystem<Continuity::g1>;
template class ChainSystem<Continuity::c2>;
template class ChainSystem<Continuity::g2>;
template bool advance<Continuity::c1>(const Chain&, const ChainSystem<Continuity::c1>::Step&, Chain&);
template bool advance<Continuity::g1>(const Chain&, const ChainSystem<Continuity::g1>::Step&, Chain&);
template bool advance<Continuity::c2>(const Chain&, const ChainSystem<Continuity::c2>::Step&, Chain&);
template bool advance<Continuity::g2>(const Chain&, const ChainSystem<Continuity::g2>::Step&, Chain&);

}  // namespace kappabench::pkappa
