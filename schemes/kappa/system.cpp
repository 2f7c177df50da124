#include "schemes/kappa/system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "schemes/kappa/stationary_point.hpp"
#include "schemes/numerics/logistic.hpp"

namespace kappabench::kappa {
namespace {

using Mat2 = Eigen::Matrix2d;

/// One segment's interpolation equation, in the units of the drawing.
struct Interpolation {
  double t;
  Vec2 value;
};
/// Its derivatives by e, X and Y taken as independent.
struct InterpolationDerivatives {
  Mat2 by_e, by_x, by_y;
};

template <class Basis>
class SegmentRow {
 public:
  SegmentRow(double a, Form form, double softness) : basis_(a), form_(form), softness_(softness) {}

  [[nodiscard]] Interpolation value(const Vec2& e, const Ends& q) const {
    switch (form_) {
      case Form::at_start:
        return {0.0, q.x};
      case Form::at_end:
        return {Basis::last, q.y};
      case Form::direct: {
        const double t = Direct(basis_, e - q.x, q.y - e, softness_).peak();
        const Blend b = basis_.blend(t);
        return {t, b.b0 * q.x + b.b1 * e + b.b2 * q.y};
      }
      default: {
        const double t = Eliminated(basis_, q.x, q.y, softness_).inner_root();
        const Blend b = basis_.blend(t);
        if (form_ == Form::undivided) return {t, b.b0 * q.x + b.b1 * e + b.b2 * q.y};
        return {t, e + (b.b0 / b.b1) * q.x + (b.b2 / b.b1) * q.y};
      }
    }
  }

  [[nodiscard]] InterpolationDerivatives derivatives(const Vec2& e, const Ends& q, double t) const {
    const Mat2 one = Mat2::Identity(), zero = Mat2::Zero();
    if (form_ == Form::at_start) return {zero, one, zero};
    if (form_ == Form::at_end) return {zero, zero, one};
    const Blend b = basis_.blend(t);
    if (form_ == Form::direct) {
      InterpolationDerivatives d{b.b1 * one, b.b0 * one, b.b2 * one};
      if (t <= 0.0 || t >= Basis::last) return d;
      const Vec2 r = e - q.x, s = q.y - e;
      const Direct equation(basis_, r, s, softness_);
      const Pair l = basis_.legs(t);
      const Vec2 velocity = l.first * r + l.second * s;
      const auto g = equation.gradient(t, r, s);
      const double slope = equation(t).slope;
      d.by_x += velocity * (g.a / slope).transpose();  // r = e - X
      d.by_y -= velocity * (g.b / slope).transpose();  // s = Y - e
      d.by_e -= velocity * ((g.a - g.b) / slope).transpose();
      return d;
    }
    const Eliminated equation(basis_, q.x, q.y, softness_);
    const auto g = equation.gradient(t, q.x, q.y);
    const double slope = equation(t).slope, w = b.bubble;
    if (form_ == Form::divided) {
      // d/dt of (b_0 X + b_2 Y) / b_1 is V / (k w^2).
      const Pair p = basis_.pencil(t);
      const Vec2 turn = (p.first * q.x + p.second * q.y) / (basis_.bubble_factor() * w * w);
      return {one, (b.b0 / b.b1) * one - turn * (g.a / slope).transpose(),
              (b.b2 / b.b1) * one - turn * (g.b / slope).transpose()};
    }
    const Pair l = basis_.legs(t);
    const Vec2 velocity = l.first * (e - q.x) + l.second * (q.y - e);
    return {b.b1 * one, b.b0 * one - velocity * (g.a / slope).transpose(),
            b.b2 * one - velocity * (g.b / slope).transpose()};
  }

 private:
  using Eliminated = StationaryEquation<Basis, Velocity::eliminated>;
  using Direct = StationaryEquation<Basis, Velocity::of_legs>;
  Basis basis_;
  Form form_;
  double softness_;
};

Interpolation interpolate(BasisKind kind, double a, Form form, double softness, const Vec2& e, const Ends& q) {
  return kind == BasisKind::cubic ? SegmentRow<CubicBasis>(a, form, softness).value(e, q)
                                  : SegmentRow<TrigonometricBasis>(a, form, softness).value(e, q);
}

InterpolationDerivatives interpolate_derivatives(BasisKind kind, double a, Form form, double softness, const Vec2& e,
                                                 const Ends& q, double t) {
  return kind == BasisKind::cubic ? SegmentRow<CubicBasis>(a, form, softness).derivatives(e, q, t)
                                  : SegmentRow<TrigonometricBasis>(a, form, softness).derivatives(e, q, t);
}

/// Turns of the control polygon below this are not known to the accuracy that is asked for.
constexpr double resolved_turn = 1e-3;

/// log |T| of an area with its derivative: smoothed to log sqrt(T^2 + soft^2), and continued below `least` by the
/// tangent in T^2, so that what is straight to rounding has a smooth equation too and what is not has the exact one.
struct LogArea {
  double value, slope;
};
LogArea log_area(const ChordChain& chain, double softness, std::size_t i, double area) {
  const double scale = chain.chord[i - 1].norm() * chain.chord[i].norm();
  const double soft = softness * scale, least = chain.least_area * scale;
  const double square = area * area + soft * soft, bounded = std::max(square, least * least);
  return {0.5 * (std::log(bounded) + square / bounded - 1.0), area / bounded};
}

}  // namespace

PolygonLegs polygon_legs(const ChordChain& chain, const State& state, std::size_t i) {
  return {chain.chord[i - 1] + state.e[i] - state.e[i - 1], chain.chord[i] + state.e[i + 1] - state.e[i]};
}

bool is_straight(const ChordChain& chain, const PolygonLegs& legs, std::size_t i) {
  const double area = cross(legs.before, legs.after);
  return std::abs(area) <= chain.least_area * chain.chord[i - 1].norm() * chain.chord[i].norm();
}

Setting uniform_setting(const ChordChain& chain, Form form) {
  return {.form = std::vector<Form>(chain.segments() + 2, form)};
}

Ratios ratios_of(const State& state) {
  Ratios r{std::vector<double>(state.x.size()), std::vector<double>(state.x.size())};
  for (std::size_t k = 0; k < state.x.size(); ++k) {
    r.lambda[k] = logistic(state.x[k]);
    r.rest[k] = logistic(-state.x[k]);
  }
  return r;
}

Ends ends(const ChordChain& chain, const State& state, const Ratios& r, std::size_t i) {
  return {r.rest[i - 1] * (state.e[i - 1] - chain.chord[i - 1]) + r.lambda[i - 1] * state.e[i],
          r.rest[i] * state.e[i] + r.lambda[i] * (state.e[i + 1] + chain.chord[i])};
}

double last_parameter(BasisKind basis) {
  return basis == BasisKind::cubic ? CubicBasis::last : TrigonometricBasis::last;
}

double peak_slope(const ChordChain& chain, std::size_t i, const Vec2& e, const Ends& q, double t) {
  const auto of = [&](const auto& basis) {
    using Basis = std::decay_t<decltype(basis)>;
    return StationaryEquation<Basis, Velocity::of_legs>(basis, e - q.x, q.y - e, 0.0)(t).value;
  };
  return chain.basis == BasisKind::cubic ? of(CubicBasis(chain.a[i])) : of(TrigonometricBasis(chain.a[i]));
}

namespace {

struct Nearest {
  Form form;
  double miss;
};

/// At t: how far the legs must move to bring K to zero, with the sign of K, and how far the segment passes its point
/// by, both over the point's size.
template <class Basis>
std::pair<double, double> slope_and_miss(const Basis& basis, const Vec2& e, const Ends& q, double size, double t) {
  const Vec2 r = e - q.x, s = q.y - e;
  const StationaryEquation<Basis, Velocity::of_legs> equation(basis, r, s, 0.0);
  const double k = equation(t).value;
  const auto g = equation.gradient(t, r, s);
  const Blend b = basis.blend(t);
  return {k == 0.0 ? 0.0 : k / ((g.a.norm() + g.b.norm()) * size), (b.b0 * q.x + b.b1 * e + b.b2 * q.y).norm() / size};
}

Nearest nearest(const ChordChain& chain, const State& state, const Values& values, std::size_t i) {
  const Ends q = ends(chain, state, values.ratios, i);
  const auto at = [&](double t) {
    return chain.basis == BasisKind::cubic
               ? slope_and_miss(CubicBasis(chain.a[i]), state.e[i], q, chain.size[i], t)
               : slope_and_miss(TrigonometricBasis(chain.a[i]), state.e[i], q, chain.size[i], t);
  };
  const auto [slope, miss] = at(values.t[i]);
  Nearest best{Form::divided, std::max(miss, std::abs(slope))};
  const auto consider = [&](Form form, double off) {
    if (!(best.miss <= off)) best = {form, off};
  };
  const auto [first_slope, first_miss] = at(0.0);
  consider(Form::at_start, std::max(first_miss, first_slope));
  const auto [last_slope, last_miss] = at(last_parameter(chain.basis));
  consider(Form::at_end, std::max(last_miss, -last_slope));
  return best;
}

}  // namespace

double residual_of(const System& system, const State& state, Values& values) {
  const ChordChain& chain = system.chain();
  system.evaluate(state, uniform_setting(chain, Form::divided), values);
  double largest = 0.0;
  for (std::size_t i = 1; i <= chain.segments(); ++i)
    largest = std::max(largest, residual_at(system, state, values, i));
  return largest;
}

double residual_of(const System& system, const State& state, const Setting& setting, Values& values) {
  system.evaluate(state, setting, values);
  return values.residual;
}

Form nearest_form(const System& system, const State& state, const Values& values, std::size_t i) {
  return nearest(system.chain(), state, values, i).form;
}

double residual_at(const System& system, const State& state, const Values& values, std::size_t i) {
  const double miss = nearest(system.chain(), state, values, i).miss,
               jump = values.weight[i] * std::abs(values.jump[i]);
  return std::isfinite(miss + jump) ? std::max(miss, jump) : std::numeric_limits<double>::infinity();
}

double stationary_parameter(const ChordChain& chain, std::size_t i, const Ends& q) {
  const auto of = [&](const auto& basis) {
    using Basis = std::decay_t<decltype(basis)>;
    return StationaryEquation<Basis, Velocity::eliminated>(basis, q.x, q.y, 0.0).inner_root();
  };
  return chain.basis == BasisKind::cubic ? of(CubicBasis(chain.a[i])) : of(TrigonometricBasis(chain.a[i]));
}

Blend stationary_blend(const ChordChain& chain, std::size_t i, const Ends& q) {
  const double t = stationary_parameter(chain, i, q);
  return chain.basis == BasisKind::cubic ? CubicBasis(chain.a[i]).blend(t) : TrigonometricBasis(chain.a[i]).blend(t);
}

void System::evaluate_jumps(const State& state, double softness, Values& values) const {
  const ChordChain& chain = *chain_;
  const std::size_t m = chain.segments();
  values.jump.assign(m + 2, 0.0);
  values.weight.assign(m + 2, 1.0);
  values.area.resize(m + 2);
  values.s.resize(m + 2);
  for (std::size_t i = 1; i <= m; ++i) {
    const PolygonLegs legs = polygon_legs(chain, state, i);
    values.area[i] = cross(legs.before, legs.after);
    const double turn = std::abs(values.area[i]) / std::sqrt(legs.before.squaredNorm() * legs.after.squaredNorm());
    values.weight[i] = std::fmin(1.0, turn / resolved_turn);
    values.s[i] = log_area(chain, softness, i, values.area[i]).value;
  }
  const double first_weight = values.weight[1];
  for (std::size_t i = 1; i <= (chain.closed ? m : m - 1); ++i) {
    const std::size_t j = chain.next(i);
    values.weight[i] = std::min(values.weight[i], j == 1 ? first_weight : values.weight[j]);
    // log of kappa_i(1) / kappa_{i+1}(0), Eq. (8) with Delta_i+ = (1 - lambda_{i-1}) T_i and
    // Delta_{i+1}- = lambda_{i+1} T_{i+1}.
    values.jump[i] = values.s[i] - values.s[j] + chain.end[i] - chain.end[j] - softplus(state.x[i - 1]) -
                     2.0 * state.x[i] + softplus(-state.x[j]);
  }
}

void System::evaluate(const State& state, const Setting& setting, Values& values) const {
  const ChordChain& chain = *chain_;
  const std::size_t m = chain.segments();
  values.ratios = ratios_of(state);
  evaluate_jumps(state, setting.area_share * setting.softness, values);
  values.t.resize(m + 2);
  values.miss.resize(m + 2);
  values.merit = values.residual = 0.0;
  const auto count = [&values](double value, double weight) {
    values.merit += value * value;
    const double size = std::isfinite(value) ? weight * std::abs(value) : std::numeric_limits<double>::infinity();
    values.residual = std::max(values.residual, size);
  };
  for (std::size_t i = 1; i <= m; ++i) {
    const Interpolation row = interpolate(chain.basis, chain.a[i], setting.form[i], setting.softness, state.e[i],
                                          ends(chain, state, values.ratios, i));
    values.t[i] = row.t;
    values.miss[i] = row.value / chain.size[i];
    count(values.miss[i].norm(), 1.0);
    count(values.jump[i], values.weight[i]);
  }
}

void System::linearise(const State& state, const Setting& setting, const Values& values, Block4& jacobian,
                       std::vector<Right4>& right) const {
  const ChordChain& chain = *chain_;
  const std::size_t m = chain.segments();
  jacobian.cyclic = chain.closed;
  jacobian.resize(m);
  right.resize(m);
  for (std::size_t i = 1; i <= m; ++i) {
    auto &lower = jacobian.lower[i - 1], &diagonal = jacobian.diagonal[i - 1], &upper = jacobian.upper[i - 1];
    lower.setZero();
    diagonal.setZero();
    upper.setZero();
    const PolygonLegs legs = polygon_legs(chain, state, i);
    const double size = chain.size[i];
    const double l0 = values.ratios.lambda[i - 1], r0 = values.ratios.rest[i - 1], l1 = values.ratios.lambda[i],
                 r1 = values.ratios.rest[i];

    const InterpolationDerivatives d =
        interpolate_derivatives(chain.basis, chain.a[i], setting.form[i], setting.softness, state.e[i],
                                ends(chain, state, values.ratios, i), values.t[i]);
    lower.topLeftCorner<2, 2>() = r0 / size * d.by_x;
    lower.block<2, 1>(0, 2) = l0 * r0 / size * (d.by_x * legs.before);
    diagonal.topLeftCorner<2, 2>() = (d.by_e + l0 * d.by_x + r1 * d.by_y) / size;
    diagonal.block<2, 1>(0, 2) = l1 * r1 / size * (d.by_y * legs.after);
    upper.topLeftCorner<2, 2>() = l1 / size * d.by_y;

    if (chain.closed || i < m) {
      lower(2, 2) = -l0;
      diagonal(2, 2) = -2.0;
      diagonal(2, 3) = 1.0;
      upper(2, 2) = -values.ratios.rest[chain.next(i)];
      upper(2, 3) = -1.0;
    } else {
      diagonal(2, 2) = 1.0;  // a fixed joint
    }

    const double weight = log_area(chain, setting.area_share * setting.softness, i, values.area[i]).slope;
    const Vec2 by_before = -left_normal(legs.after), by_after = left_normal(legs.before);  // of cross(before, after)
    lower.block<1, 2>(3, 0) = weight * by_before.transpose();
    diagonal.block<1, 2>(3, 0) = -weight * (by_before - by_after).transpose();
    upper.block<1, 2>(3, 0) = -weight * by_after.transpose();
    diagonal(3, 3) = 1.0;

    right[i - 1] << -values.miss[i].x(), -values.miss[i].y(), -values.jump[i], 0.0;
  }
}

}  // namespace kappabench::kappa
