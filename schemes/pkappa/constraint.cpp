#include "schemes/pkappa/constraint.hpp"

#include "schemes/numerics/bernstein.hpp"

namespace kappabench::pkappa {

template <Continuity K>
void add_constraint(const JointChain& chain, std::size_t i, QuadraticModel<K>& model) {
  using L = Layout<K>;
  constexpr int side = 2 * L::side;
  const std::size_t j = chain.end_joint(i);
  const auto basis = bernstein<L::degree>(chain.t[i]);
  Eigen::Matrix<double, 2, side> from_start = Eigen::Matrix<double, 2, side>::Zero(), from_end = from_start;
  for (int c = 0; c < L::side; ++c) {
    from_start.template middleCols<2>(2 * c).diagonal().setConstant(basis[c]);
    from_end.template middleCols<2>(2 * c).diagonal().setConstant(basis[L::degree - c]);
  }
  Eigen::Matrix<double, 2, L::block> row = Eigen::Matrix<double, 2, L::block>::Zero();
  row.template leftCols<L::joint>() = from_start * side_derivatives<K>(chain.joints[i], Side::right);
  if constexpr (L::middle > 0) row.template middleCols<2>(L::middle_at).diagonal().setConstant(basis[L::side]);
  row.col(L::parameter_at) = polygon<K>(chain, i) * bernstein_derivatives<L::degree>(chain.t[i], 1);
  const Eigen::Matrix<double, 2, L::joint> next = from_end * side_derivatives<K>(chain.joints[j], Side::left);

  constexpr int m = L::multiplier_at;
  model.matrix.diagonal[i].template middleRows<2>(m) += row;
  model.matrix.diagonal[i].template middleCols<2>(m) += row.transpose();
  model.matrix.upper[i].template block<2, L::joint>(m, 0) += next;
  model.matrix.lower[j].template block<L::joint, 2>(0, m) += next.transpose();
}

template <Continuity K>
void add_curvature(const JointChain& chain, std::size_t i, const SegmentGradient<K>& gradient, const Vec2& multiplier,
                   QuadraticModel<K>& model) {
  using L = Layout<K>;
  const std::size_t j = chain.end_joint(i);
  const auto basis = bernstein<L::degree>(chain.t[i]);
  const auto slope = bernstein_derivatives<L::degree>(chain.t[i], 1);
  if constexpr (L::geometric) {
    Eigen::Matrix<double, 2, L::side> at_start, at_end;
    for (int c = 0; c < L::side; ++c) {
      at_start.col(c) = gradient.template segment<2>(2 * c) + basis[c] * multiplier;
      at_end.col(c) = gradient.template segment<2>(2 * (L::degree - c)) + basis[L::degree - c] * multiplier;
    }
    model.matrix.diagonal[i].template topLeftCorner<L::joint, L::joint>() +=
        side_curvature<K>(chain.joints[i], Side::right, at_start);
    model.matrix.diagonal[j].template topLeftCorner<L::joint, L::joint>() +=
        side_curvature<K>(chain.joints[j], Side::left, at_end);
  }

  constexpr int t = L::parameter_at, side = 2 * L::side;
  Eigen::Matrix<double, 1, side> from_start, from_end;
  for (int c = 0; c < L::side; ++c) {
    from_start.template segment<2>(2 * c) = slope[c] * multiplier.transpose();
    from_end.template segment<2>(2 * c) = slope[L::degree - c] * multiplier.transpose();
  }
  Eigen::Matrix<double, 1, L::block> row = Eigen::Matrix<double, 1, L::block>::Zero();
  row.template head<L::joint>() = from_start * side_derivatives<K>(chain.joints[i], Side::right);
  if constexpr (L::middle > 0) row.template segment<2>(L::middle_at) = slope[L::side] * multiplier.transpose();
  model.matrix.diagonal[i].row(t) += row;
  model.matrix.diagonal[i].col(t) += row.transpose();
  model.matrix.diagonal[i](t, t) +=
      multiplier.dot(polygon<K>(chain, i) * bernstein_derivatives<L::degree>(chain.t[i], 2));
  const Eigen::Matrix<double, 1, L::joint> next = from_end * side_derivatives<K>(chain.joints[j], Side::left);
  model.matrix.upper[i].template block<1, L::joint>(t, 0) += next;
  model.matrix.lower[j].template block<L::joint, 1>(0, t) += next.transpose();
}

template void add_constraint<Continuity::c1>(const JointChain&, std::size_t, QuadraticModel<Continuity::c1>&);
template void add_curvature<Continuity::c1>(const JointChain&, std::size_t, const SegmentGradient<Continuity::c1>&,
                                            const Vec2&, QuadraticModel<Continuity::c1>&);
template void add_constraint<Continuity::g1>(const JointChain&, std::size_t, QuadraticModel<Continuity::g1>&);
template void add_curvature<Continuity::g1>(const JointChain&, std::size_t, const SegmentGradient<Continuity::g1>&,
                                            const Vec2&, QuadraticModel<Continuity::g1>&);
template void add_constraint<Continuity::c2>(const JointChain&, std::size_t, QuadraticModel<Continuity::c2>&);
template void add_curvature<Continuity::c2>(const JointChain&, std::size_t, const SegmentGradient<Continuity::c2>&,
                                            const Vec2&, QuadraticModel<Continuity::c2>&);
template void add_constraint<Continuity::g2>(const JointChain&, std::size_t, QuadraticModel<Continuity::g2>&);
template void add_curvature<Continuity::g2>(const JointChain&, std::size_t, const SegmentGradient<Continuity::g2>&,
                                            const Vec2&, QuadraticModel<Continuity::g2>&);

}  // namespace kappabench::pkappa
