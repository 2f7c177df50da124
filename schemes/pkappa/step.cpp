#include "schemes/pkappa/step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kappabench::pkappa {
namespace {

constexpr double not_held = std::numeric_limits<double>::quiet_NaN();

/// The derivative of the damped model by a t that is held, at the end of `step`.
template <Continuity K>
double slope_of_held(const QuadraticModel<K>& model, const JointChain& chain, std::size_t i, double damping,
                     const typename QuadraticModel<K>::Step& step) {
  constexpr int t = Layout<K>::parameter_at;
  const std::size_t j = chain.end_joint(i);
  return model.matrix.diagonal[i].row(t).dot(step[i]) + model.matrix.upper[i].row(t).dot(step[j]) +
         damping * model.scale[i][t] * step[i][t] + model.gradient[i][t];
}

}  // namespace

template <Continuity K>
bool BoxedStep<K>::solve(const QuadraticModel<K>& model, const JointChain& chain, double damping, Step& out) {
  using L = Layout<K>;
  const std::size_t n = chain.size(), blocks = model.matrix.size();
  damped_ = model.matrix;
  out.resize(blocks);
  for (std::size_t k = 0; k < blocks; ++k) {
    damped_.diagonal[k].diagonal() += damping * model.scale[k];
    out[k] = -model.gradient[k];
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

/// The quadratic program in the boxes of t by a primal-dual active set (Hintermueller, Ito, Kunisch 2002): hold every t
/// that would leave, release every one that would rather come back, until nothing changes.
template <Continuity K>
bool BoxedStep<K>::find(const QuadraticModel<K>& model, const JointChain& chain, double damping, Step& out) {
  constexpr int t_at = Layout<K>::parameter_at, most_rounds = 8;
  const std::size_t n = chain.size();
  held_.resize(n, not_held);
  for (std::size_t i = 0; i < n; ++i)
    if (!std::isnan(held_[i]))
      held_[i] = std::clamp(chain.t[i] + held_[i], chain.t_least[i], chain.t_most[i]) - chain.t[i];
  for (int round = 0; round < most_rounds; ++round) {
    if (!solve(model, chain, damping, out)) return false;
    bool settled = true;
    for (std::size_t i = 0; i < n; ++i) {
      const double t = chain.t[i] + out[i][t_at];
      if (std::isnan(held_[i])) {
        if (t >= chain.t_least[i] && t <= chain.t_most[i]) continue;
        held_[i] = std::clamp(t, chain.t_least[i], chain.t_most[i]) - chain.t[i];
        settled = false;
      } else {
        const bool low = 2.0 * t < chain.t_least[i] + chain.t_most[i];
        const double slope = slope_of_held<K>(model, chain, i, damping, out);
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
bool advance(const JointChain& from, const typename QuadraticModel<K>::Step& step, JointChain& to) {
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

template class BoxedStep<Continuity::c1>;
template class BoxedStep<Continuity::g1>;
template class BoxedStep<Continuity::c2>;
template class BoxedStep<Continuity::g2>;
template bool advance<Continuity::c1>(const JointChain&, const QuadraticModel<Continuity::c1>::Step&, JointChain&);
template bool advance<Continuity::g1>(const JointChain&, const QuadraticModel<Continuity::g1>::Step&, JointChain&);
template bool advance<Continuity::c2>(const JointChain&, const QuadraticModel<Continuity::c2>::Step&, JointChain&);
template bool advance<Continuity::g2>(const JointChain&, const QuadraticModel<Continuity::g2>::Step&, JointChain&);

}  // namespace kappabench::pkappa
