#include "schemes/kappa/peak_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "schemes/kappa/stationary_point.hpp"
#include "schemes/numerics/arc_length_path.hpp"

namespace kappabench::kappa {
namespace {

using Block5 = BlockTridiagonal<5>;
using Right5 = BlockRight<5, 1>;

constexpr double longest_step = 4.0;  ///< of x, and of e in units of the point's size
constexpr double nearest = 0.1;       ///< part of its distance from an end that a step leaves to t
constexpr int halvings = 12;
constexpr int corrector_steps = 15;
constexpr double least_softness = 1e-13;
constexpr double try_exact_at = 1e-3;
constexpr double shortest_factor = 0.97;
constexpr int pin_rounds = 12;
constexpr double difference = 1e-4;  ///< step of the numerical derivative by log softness
constexpr PathLimits limits{
    .least_softness = 1e-13, .most_softness = 1e4, .longest_in_log = 2.0, .shortest_length = 1e-5};
constexpr long most_steps = 1500, most_path_steps = 3000;

/// A state with the parameter of each peak, in the basis's own units.
struct PeakState {
  State state;
  std::vector<double> t;
};

/// The peak equation over |r|^2 + |s|^2, r and s the legs, and its derivatives.
struct Peak {
  double value, by_t;
  Vec2 by_r, by_s;
};

template <class Basis>
Peak peak_of(const Basis& basis, double t, const Vec2& r, const Vec2& s, double softness) {
  const StationaryEquation<Basis, Velocity::of_legs> equation(basis, r, s, softness);
  const ValueAndSlope k = equation(t);
  const auto g = equation.gradient(t, r, s);
  const double scale = r.squaredNorm() + s.squaredNorm(), value = k.value / scale;
  return {value, k.slope / scale, (g.a - 2.0 * value * r) / scale, (g.b - 2.0 * value * s) / scale};
}

class PeakNewton {
 public:
  explicit PeakNewton(const ChordChain& chain)
      : chain_(chain),
        system_(chain),
        last_(last_parameter(chain.basis)),
        easy_(uniform_setting(chain, Form::at_start)),
        path_(uniform_setting(chain, Form::divided)) {}

  // What ArcLengthPath needs: the equations of a softness, all points free.
  using State = PeakState;
  using Step = std::vector<Right5>;

  double evaluate(const PeakState& at, double softness) {
    path_.softness = softness;
    evaluate(at, path_, values_);
    return values_.residual;
  }

  [[nodiscard]] bool solve(const PeakState& at, double softness, Step& newton, Step& response) {
    ++steps_;
    path_.softness = softness;
    linearise(at, path_, values_);
    newton = right_;
    path_.softness *= std::exp(difference);
    evaluate(at, path_, trial_values_);
    const std::size_t m = chain_.segments();
    both_.resize(m);
    response.resize(m);
    for (std::size_t i = 1; i <= m; ++i) {
      const Ends q = ends(chain_, at.state, values_.ratios, i);
      const Vec2 r = at.state.e[i] - q.x, s = q.y - at.state.e[i];
      const double more = peak(i, at.t[i], r, s, path_.softness).value, now = peak(i, at.t[i], r, s, softness).value;
      both_[i - 1].col(0) = newton[i - 1];
      both_[i - 1].col(1) << 0.0, 0.0, -(trial_values_.jump[i] - values_.jump[i]) / difference, 0.0,
          -(more - now) / difference;
    }
    if (!both_solver_.solve(matrix_, both_)) return false;
    for (std::size_t k = 0; k < m; ++k) {
      newton[k] = both_[k].col(0);
      response[k] = both_[k].col(1);
    }
    return true;
  }

  [[nodiscard]] double dot(const Step& a, const Step& b, double start) const {
    double sum = start;
    for (std::size_t k = 0; k < a.size(); ++k)
      sum += a[k].head<2>().dot(b[k].head<2>()) / (chain_.size[k + 1] * chain_.size[k + 1]) + a[k](2) * b[k](2) +
             a[k](4) * b[k](4);
    return sum;
  }

  void advance(const PeakState& from, const Step& step, double factor, PeakState& to) const {
    const std::size_t m = chain_.segments();
    to = from;
    for (std::size_t i = 1; i <= m; ++i) {
      const Right5& s = step[i - 1];
      to.state.e[i] += factor * s.head<2>();
      if (chain_.closed || i < m) to.state.x[i] += factor * s(2);
      to.t[i] = inside(from.t[i], from.t[i] + factor * s(4));
    }
    to.state.close(chain_);
  }

  /// Forms: at_start and at_end fix t, all others leave it free.
  bool run(PeakState& at, const Setting& setting, int steps, double tolerance) {
    evaluate(at, setting, values_);
    for (int i = 0; i < steps; ++i) {
      if (values_.residual <= tolerance) return true;
      ++steps_;
      if (!step(at, setting)) return false;
    }
    return values_.residual <= tolerance;
  }

  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] double residual() const { return values_.residual; }

  /// K at t, over its scale.
  [[nodiscard]] double slope_at(const PeakState& at, std::size_t i, double t) const {
    const Ends q = ends(chain_, at.state, values_.ratios, i);
    return peak(i, t, at.state.e[i] - q.x, q.y - at.state.e[i], 0.0).value;
  }

 private:
  [[nodiscard]] Peak peak(std::size_t i, double t, const Vec2& r, const Vec2& s, double softness) const {
    return chain_.basis == BasisKind::cubic ? peak_of(CubicBasis(chain_.a[i]), t, r, s, softness)
                                            : peak_of(TrigonometricBasis(chain_.a[i]), t, r, s, softness);
  }
  [[nodiscard]] Blend blend(std::size_t i, double t) const {
    return chain_.basis == BasisKind::cubic ? CubicBasis(chain_.a[i]).blend(t)
                                            : TrigonometricBasis(chain_.a[i]).blend(t);
  }
  [[nodiscard]] Pair legs(std::size_t i, double t) const {
    return chain_.basis == BasisKind::cubic ? CubicBasis(chain_.a[i]).legs(t) : TrigonometricBasis(chain_.a[i]).legs(t);
  }

  void evaluate(const PeakState& at, const Setting& setting, Values& v) const {
    const std::size_t m = chain_.segments();
    v.ratios = ratios_of(at.state);
    system_.evaluate_jumps(at.state, setting.area_share * setting.softness, v);
    v.t = at.t;
    v.miss.resize(m + 2);
    v.merit = v.residual = 0.0;
    const auto count = [&v](double value, double weight) {
      v.merit += value * value;
      const double size = std::isfinite(value) ? weight * std::abs(value) : std::numeric_limits<double>::infinity();
      v.residual = std::max(v.residual, size);
    };
    for (std::size_t i = 1; i <= m; ++i) {
      const Ends q = ends(chain_, at.state, v.ratios, i);
      const Vec2& e = at.state.e[i];
      const Blend b = blend(i, at.t[i]);
      v.miss[i] = (b.b0 * q.x + b.b1 * e + b.b2 * q.y) / chain_.size[i];
      count(v.miss[i].norm(), 1.0);
      count(v.jump[i], v.weight[i]);
      if (!is_pinned(setting.form[i])) count(peak(i, at.t[i], e - q.x, q.y - e, setting.softness).value, 1.0);
    }
  }

  /// `t`, kept from an end by part of the distance that it had.
  [[nodiscard]] double inside(double before, double t) const {
    return std::clamp(t, nearest * before, last_ - nearest * (last_ - before));
  }

  void linearise(const PeakState& at, const Setting& setting, const Values& values) {
    const std::size_t m = chain_.segments();
    // The rows of jumps and areas are those of System; those of misses are replaced.
    easy_.softness = setting.softness;
    easy_.area_share = setting.area_share;
    system_.linearise(at.state, easy_, values, block4_, right4_);
    matrix_.cyclic = chain_.closed;
    matrix_.resize(m);
    right_.resize(m);
    for (std::size_t i = 1; i <= m; ++i) {
      auto &lower = matrix_.lower[i - 1], &diagonal = matrix_.diagonal[i - 1], &upper = matrix_.upper[i - 1];
      lower.setZero();
      diagonal.setZero();
      upper.setZero();
      lower.template block<2, 4>(2, 0) = block4_.lower[i - 1].template block<2, 4>(2, 0);
      diagonal.template block<2, 4>(2, 0) = block4_.diagonal[i - 1].template block<2, 4>(2, 0);
      upper.template block<2, 4>(2, 0) = block4_.upper[i - 1].template block<2, 4>(2, 0);
      const double l0 = values.ratios.lambda[i - 1], r0 = values.ratios.rest[i - 1], l1 = values.ratios.lambda[i],
                   r1 = values.ratios.rest[i];
      const PolygonLegs polygon = polygon_legs(chain_, at.state, i);
      // One row with gradients by e, X and Y.
      const auto put = [&](Eigen::Index row, const Vec2& by_e, const Vec2& by_x, const Vec2& by_y) {
        lower.template block<1, 2>(row, 0) = r0 * by_x.transpose();
        lower(row, 2) = l0 * r0 * by_x.dot(polygon.before);
        diagonal.template block<1, 2>(row, 0) = (by_e + l0 * by_x + r1 * by_y).transpose();
        diagonal(row, 2) = l1 * r1 * by_y.dot(polygon.after);
        upper.template block<1, 2>(row, 0) = l1 * by_y.transpose();
      };
      const Ends q = ends(chain_, at.state, values.ratios, i);
      const Vec2 r = at.state.e[i] - q.x, s = q.y - at.state.e[i];
      const Blend b = blend(i, at.t[i]);
      const Pair l = legs(i, at.t[i]);
      const Vec2 velocity = (l.first * r + l.second * s) / chain_.size[i];
      for (Eigen::Index c = 0; c < 2; ++c) {
        const Vec2 unit = Vec2::Unit(c) / chain_.size[i];
        put(c, b.b1 * unit, b.b0 * unit, b.b2 * unit);
        diagonal(c, 4) = velocity(c);
      }
      right_[i - 1].template head<4>() = right4_[i - 1];
      right_[i - 1].template head<2>() = -values.miss[i];
      if (is_pinned(setting.form[i])) {
        diagonal(4, 4) = 1.0;
        right_[i - 1](4) = 0.0;
      } else {
        const Peak k = peak(i, at.t[i], r, s, setting.softness);
        put(4, k.by_r - k.by_s, -k.by_r, k.by_s);
        diagonal(4, 4) = k.by_t;
        right_[i - 1](4) = -k.value;
      }
    }
  }

  void advance(const PeakState& at, const Setting& setting, double fraction, PeakState& to) const {
    const std::size_t m = chain_.segments();
    to = at;
    for (std::size_t i = 1; i <= m; ++i) {
      const Right5& s = right_[i - 1];
      const Vec2 e = s.head<2>();
      to.state.e[i] += fraction * std::min(1.0, longest_step / (e.norm() / chain_.size[i])) * e;
      if (chain_.closed || i < m) to.state.x[i] += fraction * std::clamp(s(2), -longest_step, longest_step);
      if (!is_pinned(setting.form[i])) to.t[i] = inside(at.t[i], at.t[i] + fraction * s(4));
    }
    to.state.close(chain_);
  }

  bool step(PeakState& at, const Setting& setting) {
    linearise(at, setting, values_);
    if (!solver_.solve(matrix_, right_)) return false;
    double fraction = 1.0;
    for (int i = 0; i < halvings; ++i, fraction *= 0.5) {
      advance(at, setting, fraction, trial_);
      evaluate(trial_, setting, trial_values_);
      if (std::isfinite(trial_values_.residual) && trial_values_.merit < (1.0 - 1e-4 * fraction) * values_.merit) {
        std::swap(at, trial_);
        std::swap(values_, trial_values_);
        return true;
      }
    }
    return false;
  }

  const ChordChain& chain_;
  System system_;
  double last_;
  Setting easy_;
  Values values_, trial_values_;
  PeakState trial_;
  Block4 block4_;
  std::vector<Right4> right4_;
  Block5 matrix_;
  std::vector<Right5> right_;
  BlockTridiagonalSolver<5> solver_;
  Setting path_;
  std::vector<BlockRight<5, 2>> both_;
  BlockTridiagonalSolver<5, 2> both_solver_;
  long steps_ = 0;
};

/// The exact problem from a point of the path, correcting the set of pinned points.
bool solve_exactly(const ChordChain& chain, PeakNewton& newton, PeakState& at, Setting& setting, double softness) {
  const std::size_t m = chain.segments();
  const double last = last_parameter(chain.basis);
  const double zone = std::sqrt(softness) * last;
  setting = uniform_setting(chain, Form::divided);
  const auto pin = [&](std::size_t i, bool start) {
    setting.form[i] = start ? Form::at_start : Form::at_end;
    at.t[i] = start ? 0.0 : last;
  };
  const auto may_start = [&](std::size_t i) { return !std::isinf(at.state.x[i - 1]); };
  const auto may_end = [&](std::size_t i) { return !std::isinf(at.state.x[i]); };
  for (std::size_t i = 1; i <= m; ++i) {
    if (at.t[i] < zone && may_start(i))
      pin(i, true);
    else if (at.t[i] > last - zone && may_end(i))
      pin(i, false);
  }
  for (int round = 0; round < pin_rounds; ++round) {
    const bool ok = newton.run(at, setting, corrector_steps, 0.1 * accuracy) || newton.residual() <= accuracy;
    int changed = 0;
    for (std::size_t i = 1; i <= m; ++i) {
      if (is_pinned(setting.form[i])) {
        const bool start = setting.form[i] == Form::at_start;
        const double k = newton.slope_at(at, i, at.t[i]);
        if (start ? k > accuracy : k < -accuracy) {
          setting.form[i] = Form::divided;
          at.t[i] = start ? 1e-3 * last : last - 1e-3 * last;
          ++changed;
        }
      } else if (at.t[i] < 1e-9 * last && may_start(i)) {
        pin(i, true), ++changed;
      } else if (at.t[i] > (1.0 - 1e-9) * last && may_end(i)) {
        pin(i, false), ++changed;
      }
    }
    if (changed == 0) return ok;
    if (!ok && round > 3) return false;
  }
  return false;
}

}  // namespace

Solution solve_by_peaks(const ChordChain& chain, const State& start, double softness, int sweeps) {
  const System system(chain);
  Solution solution{.state = start, .setting = uniform_setting(chain, Form::divided)};
  PublishedIteration published(system);
  solution.effort.sweeps = published.steps(solution.state, sweeps);
  PeakNewton newton(chain);
  PeakState good{solution.state, std::vector<double>(chain.segments() + 2, 0.5 * last_parameter(chain.basis))};
  Setting soft = uniform_setting(chain, Form::divided);
  Values values;
  const auto try_exact = [&](PeakState at, double reached) {
    Setting setting;
    if (!solve_exactly(chain, newton, at, setting, reached)) return false;
    solution.residual = residual_of(system, at.state, values);
    solution.converged = solution.residual <= accuracy;
    solution.state = std::move(at.state);
    solution.setting = std::move(setting);
    return solution.converged;
  };

  double reached = 0.0, next = softness, factor = 0.1, exact_at = try_exact_at;
  while (!solution.converged && factor < shortest_factor && next >= least_softness && newton.steps() < most_steps) {
    soft.softness = next;
    PeakState at = good;
    const long before = newton.steps();
    if (newton.run(at, soft, corrector_steps, std::max(0.1 * accuracy, 1e-2 * next))) {
      good = std::move(at);
      reached = next;
      if (newton.steps() - before <= 5) factor = std::max(0.1, factor * factor);
      next = reached * factor;
      if (reached > exact_at) continue;
      exact_at = 0.03 * reached;
      try_exact(good, reached);
    } else if (reached == 0.0) {
      next *= 4.0;
      if (next > 300.0) break;
    } else {
      factor = std::sqrt(factor);
      next = reached * factor;
    }
  }
  if (!solution.converged && reached > 1e-8) {
    exact_at = std::min(exact_at, 0.03 * reached);
    ArcLengthPath path(newton, limits);
    path.follow(good, reached, true, most_path_steps, [&](const PeakState& at, double now) {
      if (now > exact_at) return false;
      exact_at = 0.03 * now;
      return try_exact(at, now);
    });
  }
  solution.effort.newton = newton.steps();
  solution.iterations = static_cast<double>(solution.effort.iterations());
  if (!solution.converged) solution.residual = residual_of(system, solution.state, values);
  return solution;
}

}  // namespace kappabench::kappa
