#include "schemes/pkappa/system.hpp"

#include <algorithm>
#include <cmath>

#include "schemes/pkappa/constraint.hpp"

namespace kappabench::pkappa {

template <Continuity K>
double ChainSystem<K>::value(const JointChain& chain) {
  double sum = 0.0;
  for (std::size_t i = 0; i < chain.size(); ++i)
    sum += energy_.terms(polygon<K>(chain, i), chain.t[i]).weighted(weights_.in(chain.unit(i)));
  return sum;
}

template <Continuity K>
double ChainSystem<K>::linearise(const JointChain& chain, const Step& last) {
  const std::size_t n = chain.size(), blocks = chain.joints.size();
  model_.matrix.resize(blocks);
  model_.matrix.cyclic = chain.cyclic;
  model_.gradient.assign(blocks, Vector::Zero());
  for (std::size_t k = 0; k < blocks; ++k) {
    model_.matrix.lower[k].setZero();
    model_.matrix.diagonal[k].setZero();
    model_.matrix.upper[k].setZero();
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Weights weights = weights_.in(chain.unit(i));
    energy_.normal(polygon<K>(chain, i), chain.t[i], weights, normal_);
    sum += normal_.terms.weighted(weights);
    add_segment(chain, i);
    add_constraint<K>(chain, i, model_);
    if (!exact_) continue;
    const Vec2 multiplier = last.empty() ? Vec2::Zero() : Vec2(last[i].template segment<2>(Layout<K>::multiplier_at));
    add_curvature<K>(chain, i, normal_.gradient, multiplier, model_);
  }
  scale_damping(chain);
  return sum;
}

/// The energy of segment i, from its control points to the unknowns.
template <Continuity K>
void ChainSystem<K>::add_segment(const JointChain& chain, std::size_t i) {
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

  auto& at_i = model_.matrix.diagonal[i];
  auto& at_j = model_.matrix.diagonal[j];
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
  model_.matrix.upper[i].template topLeftCorner<L::joint + own, L::joint>() += across;
  model_.matrix.lower[j].template topLeftCorner<L::joint, L::joint + own>() += across.transpose();

  model_.gradient[i].template head<L::joint>() += start.transpose() * g.template head<side>();
  model_.gradient[i].template segment<own>(L::middle_at) += g_own;
  model_.gradient[j].template head<L::joint>() += end.transpose() * g.template segment<side>(end_at);
}

/// Marquardt's diagonal, the same for both coordinates of a vector so that turning the input turns the result.
template <Continuity K>
void ChainSystem<K>::scale_damping(const JointChain& chain) {
  using L = Layout<K>;
  constexpr double least = 1e-2;
  model_.scale.assign(model_.matrix.size(), Vector::Zero());
  for (std::size_t k = 0; k < model_.matrix.size(); ++k) {
    const auto diagonal = model_.matrix.diagonal[k].diagonal();
    for (int v = 0; v < L::multiplier_at; ++v) model_.scale[k][v] = std::abs(diagonal[v]);
    const auto average = [&](int at) {
      model_.scale[k].template segment<2>(at).setConstant(0.5 * std::abs(diagonal[at] + diagonal[at + 1]));
    };
    for (int v = 0; v < L::vectors; ++v) average(2 * v);
    if constexpr (L::middle > 0) average(L::middle_at);
    const double joint_unit = chain.joint_unit(k), own_unit = k < chain.size() ? chain.unit(k) : 1.0;
    for (int v = 0; v < L::multiplier_at; ++v) {
      const bool of_joint = v < 2 * L::vectors, of_middle = v >= L::middle_at && v < L::parameter_at;
      const double unit = of_joint ? joint_unit : of_middle ? own_unit : 1.0;
      model_.scale[k][v] = std::max(model_.scale[k][v], least / (unit * unit));
    }
  }
}

template <Continuity K>
double ChainSystem<K>::predicted_decrease(const Step& step, double damping, std::size_t block_row) const {
  // |r|^2 - |r + J dx|^2 with (J^T J + mu D) dx + A^T y = -J^T r and A dx = 0.
  constexpr int unknowns = Layout<K>::multiplier_at;
  const auto dx = step[block_row].template head<unknowns>();
  return damping * dx.cwiseAbs2().dot(model_.scale[block_row].template head<unknowns>()) -
         dx.dot(model_.gradient[block_row].template head<unknowns>());
}

template <Continuity K>
double ChainSystem<K>::predicted_decrease(const Step& step, double damping) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < step.size(); ++k) sum += predicted_decrease(step, damping, k);
  return sum;
}

template <Continuity K>
double ChainSystem<K>::entry(std::size_t block_row, int row, std::size_t block_column, int column) const {
  if (block_row == block_column) return model_.matrix.diagonal[block_row](row, column);
  if (block_row + 1 == block_column) return model_.matrix.upper[block_row](row, column);
  return block_column + 1 == block_row ? model_.matrix.lower[block_row](row, column) : 0.0;
}

template class ChainSystem<Continuity::c1>;
template class ChainSystem<Continuity::g1>;
template class ChainSystem<Continuity::c2>;
template class ChainSystem<Continuity::g2>;

}  // namespace kappabench::pkappa
