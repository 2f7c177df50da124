#include "schemes/pkappa/global.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "schemes/pkappa/fair_start.hpp"
#include "schemes/pkappa/soundness.hpp"

namespace kappabench::pkappa {
namespace {

Chain bare_chain(std::span<const Vec2> points, bool closed, const Vec2& origin, double unit) {
  Chain chain{.cyclic = closed};
  const auto into = [&](const Vec2& p) { return Vec2((p - origin) / unit); };
  const std::size_t skip = closed ? 0 : 1;
  for (std::size_t i = skip; i + skip < points.size(); ++i) chain.points.push_back(into(points[i]));
  chain.joints.resize(chain.size() + (closed ? 0 : 1));
  chain.freedom.assign(chain.joints.size(), Freedom::all);
  if (!closed) {
    chain.freedom.front() = chain.freedom.back() = Freedom::end_point;
    chain.joints.front().position = into(points.front());
    chain.joints.back().position = into(points.back());
  }
  return chain;
}

/// Weighted energy of every segment on the fine rule.
template <Continuity K>
std::vector<double> true_energies(const Chain& chain, const Weights& weights) {
  SegmentEnergy<Layout<K>::degree> energy(fine_gauss_rule());
  std::vector<double> e(chain.size());
  for (std::size_t i = 0; i < chain.size(); ++i)
    e[i] = energy.terms(polygon<K>(chain, i), chain.t[i]).weighted(weights);
  return e;
}

/// Takes from `b` the joints where `b` is locally much better than `a`: over the two segments beside the joint and
/// their neighbours. Both chains solve the same problem. Returns the number of segments that changed hands.
template <Continuity K>
int patch(Chain& a, const Chain& b, const Weights& weights) {
  constexpr double clearly = 0.9;
  constexpr std::ptrdiff_t reach = 2;
  const std::vector<double> ea = true_energies<K>(a, weights), eb = true_energies<K>(b, weights);
  const auto n = static_cast<std::ptrdiff_t>(a.size());
  const auto near = [&](const std::vector<double>& e, std::ptrdiff_t joint) {
    double sum = 0.0;
    for (std::ptrdiff_t k = joint - reach; k < joint + reach; ++k) {
      if (a.cyclic)
        sum += e[static_cast<std::size_t>(((k % n) + n) % n)];
      else if (k >= 0 && k < n)
        sum += e[static_cast<std::size_t>(k)];
    }
    return sum;
  };
  int patched = 0;
  std::vector<char> take(a.joints.size());
  for (std::size_t k = 0; k < take.size(); ++k)
    take[k] = near(eb, static_cast<std::ptrdiff_t>(k)) < clearly * near(ea, static_cast<std::ptrdiff_t>(k));
  for (std::size_t k = 0; k < take.size(); ++k)
    if (take[k]) a.joints[k] = b.joints[k];
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!take[i] && !take[a.end_joint(i)]) continue;
    if (eb[i] >= ea[i]) continue;
    ++patched;
    a.t[i] = b.t[i];
    a.t_least[i] = b.t_least[i];
    a.t_most[i] = b.t_most[i];
    if (!a.middles.empty()) a.middles[i] = b.middles[i];
  }
  return patched;
}

}  // namespace

template <Continuity K>
Spline<K> solve_globally(std::span<const Vec2> points, bool closed, const WindowSettings& settings,
                         GlobalReport& report) {
  double unit = 0.0;
  const std::size_t chords = points.size() - (closed ? 0 : 1);
  for (std::size_t i = 0; i < chords; ++i) unit += (points[(i + 1) % points.size()] - points[i]).norm();
  unit = settings.raw_units ? 1.0 : unit / static_cast<double>(chords);
  const Vec2 origin = points.front();

  Chain chain = bare_chain(points, closed, origin, unit);
  set_boxes(chain, chord_parameters(chain));
  const bool fair = make_fair<K>(chain);
  Chain other = bare_chain(points, closed, origin, unit);
  const bool polygonal = make_polygonal<K>(other);

  const Weights reduced{settings.second_weights * settings.weights.edges,
                        settings.second_weights * settings.weights.length};
  const auto phase = [&](Chain& c, const QuadratureRule& rule, const Weights& weights, int iterations,
                         double tolerance) {
    const Minimum m = minimise<K>(Solver::lm, c, rule, {weights, iterations, tolerance});
    report.iterations += m.iterations;
    report.converged = m.converged;
    report.trace.push_back(m.energy / static_cast<double>(c.size()));
  };
  constexpr double rough = 1e-3;
  if (fair) phase(chain, *settings.rule, settings.weights, settings.first_iterations, rough);
  Verification v = verify<K>(chain, *settings.rule);
  const QuadratureRule* rule = settings.rule;
  if (!fair || !v.sound || v.worst_parabola > 0.01) {
    rule = &fine_gauss_rule();
    if (polygonal) phase(other, *rule, settings.weights, settings.first_iterations, rough);
    if (polygonal) report.patched = patch<K>(chain, other, settings.weights);
    if (!restore_interpolation<K>(chain)) chain = other;
  }
  phase(chain, *rule, settings.weights, settings.first_iterations, 1e-7);
  Chain second = chain;
  phase(second, *rule, reduced, settings.second_iterations, settings.tolerance);
  v = verify<K>(second, *rule);
  if (v.sound) chain = std::move(second);
  report.sound = verify<K>(chain, *rule).sound;

  Spline<K> spline{.t = chain.t};
  for (std::size_t i = 0; i < chain.size(); ++i)
    spline.control.push_back((polygon<K>(chain, i) * unit).colwise() + origin);
  return spline;
}

template Spline<Continuity::c1> solve_globally<Continuity::c1>(std::span<const Vec2>, bool, const WindowSettings&,
                                                               GlobalReport&);
template Spline<Continuity::g1> solve_globally<Continuity::g1>(std::span<const Vec2>, bool, const WindowSettings&,
                                                               GlobalReport&);
template Spline<Continuity::c2> solve_globally<Continuity::c2>(std::span<const Vec2>, bool, const WindowSettings&,
                                                               GlobalReport&);
template Spline<Continuity::g2> solve_globally<Continuity::g2>(std::span<const Vec2>, bool, const WindowSettings&,
                                                               GlobalReport&);

}  // namespace kappabench::pkappa
