#include "schemes/fpc/system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kappabench::fpc {
namespace {

/// Areas below this share of |X||Y| are rounding: they are taken as this large.
constexpr double least_area = 1e-15;
/// Joints nearer to a point than this share of the point's size are treated as this far from it.
constexpr double least_stride = 1e-14;
/// From here on a segment's curvature is better known than a residual of 1e-12 asks for.
constexpr double clearly_curved = 1e-3;

/// lambda / (1 + lambda); of -log lambda 1 / (1 + lambda), which a difference would give without digits.
double share_of(double log_ratio) { return 1.0 / (1.0 + std::exp(-log_ratio)); }

}  // namespace

System::System(const CubicChain& chain) : chain_(&chain), log_numerators_(chain.joints()), scale_(chain.joints()) {
  for (std::size_t k = 0; k < chain.joints(); ++k) {
    const LocalCubic& before = chain.cubic[k];
    const LocalCubic& behind = chain.cubic[chain.next(k)];
    log_numerators_[k] = std::log(std::abs(before.end_numerator / behind.start_numerator)) / 3.0;
    scale_[k] = 2.0 / ((std::abs(before.end_y) + std::abs(behind.start_x)) * chain.chord[k].norm());
  }
}

double System::soft_square(std::size_t k, double softness) const {
  const double area = softness * chain_->size[k] * chain_->size[k];
  return area * area;
}

void System::evaluate(const State& state, double softness, Values& values) const {
  const std::size_t m = chain_->segments();
  values.segment.resize(m);
  values.merit = values.worst = 0.0;
  const auto add = [&values](double equation) {
    values.merit += equation * equation;
    values.worst = std::max(values.worst, std::abs(equation));
  };
  for (std::size_t k = 0; k < m; ++k) {
    Values::Segment& s = values.segment[k];
    const LocalCubic& cubic = chain_->cubic[k];
    s.x = state.x[k];
    s.y = state.y[k];
    s.start_velocity = cubic.start_velocity(s.x, s.y);
    s.end_velocity = cubic.end_velocity(s.x, s.y);
    s.area = cross(s.x, s.y);
    s.stride = chain_->size[k];
    const double least = least_area * s.x.norm() * s.y.norm();
    s.weight_gap =
        3.0 * state.log_weight[k] - 0.5 * std::log(std::max(s.area * s.area, least * least) + soft_square(k, softness));
    add(s.weight_gap);
  }
  for (std::size_t k = 0; k < chain_->joints(); ++k) {
    Values::Segment& s = values.segment[k];
    const std::size_t next = chain_->next(k);
    const double log_ratio = state.log_weight[k] - state.log_weight[next] + log_numerators_[k];
    s.share = share_of(log_ratio);
    s.rest = share_of(-log_ratio);
    s.stride = std::max(std::min(s.y.norm(), values.segment[next].x.norm()), least_stride * chain_->size[k]);
    s.gap = scale_[k] * (s.rest * s.end_velocity - s.share * values.segment[next].start_velocity);
    add(s.gap.norm());
  }
  if (!std::isfinite(values.merit)) values.worst = values.merit;
}

void System::linearise(const Values& values, double softness, Block3& matrix, std::vector<Right3>& right) const {
  const std::size_t m = chain_->segments();
  matrix.resize(m);
  matrix.cyclic = chain_->closed;
  right.resize(m);
  for (std::size_t k = 0; k < m; ++k) {
    auto &lower = matrix.lower[k], &diagonal = matrix.diagonal[k], &upper = matrix.upper[k];
    lower.setZero();
    diagonal.setZero();
    upper.setZero();
    const Values::Segment& s = values.segment[k];
    const LocalCubic& cubic = chain_->cubic[k];
    const double stride_before = values.segment[chain_->before(k)].stride, stride_here = s.stride;
    const double stride_next = values.segment[chain_->next(k)].stride;
    if (k < chain_->joints()) {
      const std::size_t next = chain_->next(k);
      const LocalCubic& behind = chain_->cubic[next];
      const double row = chain_->size[k] / stride_here;  // where joints move by small strides, gaps are as small
      const double before = scale_[k] * s.rest, after = scale_[k] * s.share;
      const Vec2 by_ratio = before * s.share * -(s.end_velocity + values.segment[next].start_velocity);
      for (int c = 0; c < 2; ++c) {
        lower(c, c) = row * stride_before * before * cubic.end_x;
        diagonal(c, c) = row * stride_here * (before * cubic.end_y - after * behind.start_x);
        upper(c, c) = -row * stride_next * after * behind.start_y;
        diagonal(c, 2) = row * by_ratio(c);
        upper(c, 2) = -row * by_ratio(c);
        right[k](c) = -row * s.gap(c);
      }
    } else {  // the fixed end
      diagonal(0, 0) = diagonal(1, 1) = 1.0;
      right[k].head<2>().setZero();
    }
    const double least = least_area * s.x.norm() * s.y.norm();
    const double by_area = s.area / (std::max(s.area * s.area, least * least) + soft_square(k, softness));
    lower(2, 0) = -by_area * s.y.y() * stride_before;
    lower(2, 1) = by_area * s.y.x() * stride_before;
    diagonal(2, 0) = by_area * s.x.y() * stride_here;
    diagonal(2, 1) = -by_area * s.x.x() * stride_here;
    diagonal(2, 2) = 3.0;
    right[k](2) = -s.weight_gap;
  }
}

void System::by_softness(const Values& values, double softness, std::vector<Right3>& right) const {
  right.resize(chain_->segments());
  for (std::size_t k = 0; k < right.size(); ++k) {
    const double soft = soft_square(k, softness), area = values.segment[k].area;
    right[k] << 0.0, 0.0, soft / (area * area + soft);
  }
}

bool System::solve_joints(std::span<const double> log_ratio, State& state) const {
  const std::size_t m = chain_->segments();
  BlockTridiagonal<1> matrix;
  matrix.resize(m);
  matrix.cyclic = chain_->closed;
  std::vector<BlockRight<1, 2>> right(m);
  for (std::size_t k = 0; k < m; ++k) {
    double lower = 0.0, diagonal = 1.0, upper = 0.0;
    right[k] = chain_->end.transpose();
    if (k < chain_->joints()) {
      const std::size_t next = chain_->next(k);
      const LocalCubic &cubic = chain_->cubic[k], &behind = chain_->cubic[next];
      const double before = scale_[k] * share_of(-log_ratio[k]), after = scale_[k] * share_of(log_ratio[k]);
      lower = before * cubic.end_x;
      diagonal = before * cubic.end_y - after * behind.start_x;
      upper = -after * behind.start_y;
      const Vec2 known = k == 0 && !chain_->closed ? Vec2(-chain_->start) : chain_->chord[chain_->before(k)];
      right[k] = (lower * known - after * behind.start_x * chain_->chord[k]).transpose();
    }
    matrix.lower[k](0, 0) = lower;
    matrix.diagonal[k](0, 0) = diagonal;
    matrix.upper[k](0, 0) = upper;
  }
  BlockTridiagonalSolver<1, 2> solver;
  if (!solver.solve(matrix, right)) return false;
  state.x.resize(m);
  state.y.resize(m);
  for (std::size_t k = 0; k < m; ++k) state.y[k] = right[k].transpose();
  for (std::size_t k = 0; k < m; ++k)
    state.x[k] =
        k == 0 && !chain_->closed ? chain_->start : state.y[chain_->before(k)] - chain_->chord[chain_->before(k)];
  return true;
}

void System::solve_weights(State& state) const {
  state.log_weight.resize(chain_->segments());
  for (std::size_t k = 0; k < chain_->segments(); ++k) {
    // A segment without area keeps a weight that the next step can use.
    const double least = least_area * chain_->size[k] * chain_->size[k];
    state.log_weight[k] = std::log(std::max(std::abs(cross(state.x[k], state.y[k])), least)) / 3.0;
  }
}

std::vector<double> System::log_ratios(const State& state) const {
  std::vector<double> ratios(chain_->joints());
  for (std::size_t k = 0; k < ratios.size(); ++k)
    ratios[k] = state.log_weight[k] - state.log_weight[chain_->next(k)] + log_numerators_[k];
  return ratios;
}

double residual_of(const CubicChain& chain, const State& state, std::span<const double> log_ratio) {
  double worst = 0.0;
  const auto area = [&](std::size_t k) { return cross(state.x[k], state.y[k]); };
  const auto straightness = [&](std::size_t k) {
    const double most = state.x[k].norm() * state.y[k].norm();
    return most > 0.0 ? std::min(1.0, std::abs(area(k)) / (clearly_curved * most)) : 0.0;
  };
  for (std::size_t k = 0; k < chain.joints(); ++k) {
    const std::size_t next = chain.next(k);
    const double ratio = std::exp(log_ratio[k]);
    const Vec2 before = chain.cubic[k].end_velocity(state.x[k], state.y[k]);
    const Vec2 behind = ratio * chain.cubic[next].start_velocity(state.x[next], state.y[next]);
    const double gap = (before - behind).norm() / std::max(before.norm(), behind.norm());
    const double curvature_before = std::abs(chain.cubic[k].end_numerator * area(k)) / std::pow(before.norm(), 3);
    const double curvature_behind =
        std::abs(chain.cubic[next].start_numerator * area(next)) * std::pow(ratio / behind.norm(), 3);
    const double most = std::max(curvature_before, curvature_behind);
    const double mismatch = most > 0.0 ? std::abs(curvature_before - curvature_behind) / most : 0.0;
    const double counts = std::min(straightness(k), straightness(next));
    if (!std::isfinite(gap) || !std::isfinite(mismatch)) return std::numeric_limits<double>::infinity();
    worst = std::max({worst, gap, counts * mismatch});
  }
  return worst;
}

}  // namespace kappabench::fpc
