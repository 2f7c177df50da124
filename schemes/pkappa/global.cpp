#include "schemes/pkappa/global.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "schemes/pkappa/frame.hpp"
#include "schemes/pkappa/local.hpp"
#include "schemes/pkappa/soundness.hpp"
#include "schemes/pkappa/spans.hpp"
#include "schemes/pkappa/starts.hpp"
#include "schemes/pkappa/system.hpp"

namespace kappabench::pkappa {
namespace {

JointChain bare_chain(const Input& input, const Frame& frame, bool own_units) {
  const std::vector<Vec2>& points = input.points;
  const bool closed = input.closed;
  JointChain chain{.cyclic = closed};
  const std::size_t skip = closed ? 0 : 1;
  for (std::size_t i = skip; i + skip < points.size(); ++i) {
    chain.points.push_back(frame.into(points[i]));
    if (own_units) chain.units.push_back(chord_at(points, i) / frame.unit);
  }
  chain.joints.resize(chain.size() + (closed ? 0 : 1));
  chain.freedom.assign(chain.joints.size(), Freedom::all);
  if (!closed) {
    chain.freedom.front() = chain.freedom.back() = Freedom::end_point;
    chain.joints.front().position = frame.into(points.front());
    chain.joints.back().position = frame.into(points.back());
  }
  return chain;
}

/// The part of a chain of `count` segments from `first` on, what lies beyond held.
JointChain extract(const JointChain& chain, std::size_t first, std::size_t count) {
  const std::size_t n = chain.size();
  JointChain part;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (first + k) % n;
    part.joints.push_back(chain.joints[i]);
    part.freedom.push_back(chain.freedom[i]);
    part.points.push_back(chain.points[i]);
    if (!chain.units.empty()) part.units.push_back(chain.units[i]);
    part.t.push_back(chain.t[i]);
    part.t_least.push_back(chain.t_least[i]);
    part.t_most.push_back(chain.t_most[i]);
    if (!chain.middles.empty()) part.middles.push_back(chain.middles[i]);
  }
  const std::size_t end = chain.end_joint((first + count - 1) % n);
  part.joints.push_back(chain.joints[end]);
  part.freedom.push_back(chain.freedom[end]);
  if (part.freedom.front() == Freedom::all) part.freedom.front() = Freedom::none;
  if (part.freedom.back() == Freedom::all) part.freedom.back() = Freedom::none;
  return part;
}

/// Puts the inner joints and the segments of a part back.
void insert(const JointChain& part, std::size_t first, JointChain& chain) {
  const std::size_t n = chain.size();
  for (std::size_t k = 0; k < part.size(); ++k) {
    const std::size_t i = (first + k) % n;
    chain.joints[i] = part.joints[k];
    chain.t[i] = part.t[k];
    chain.t_least[i] = part.t_least[k];
    chain.t_most[i] = part.t_most[k];
    if (!chain.middles.empty()) chain.middles[i] = part.middles[k];
  }
  chain.joints[chain.end_joint((first + part.size() - 1) % n)] = part.joints.back();
}

/// E_p of every segment on the fine rule.
template <Continuity K>
std::vector<double> parabola_energies(const JointChain& chain) {
  SegmentEnergy<Layout<K>::degree> energy(fine_gauss_rule());
  std::vector<double> e;
  for (std::size_t i = 0; i < chain.size(); ++i)
    e.push_back(chain.unit(i) * energy.terms(polygon<K>(chain, i), chain.t[i]).parabola);
  return e;
}

template <Continuity K>
Spline<K> construct(const Input& input, const WindowSettings& settings, LocalReport& report) {
  return input.closed ? construct_closed<K>(input.points, settings, report)
                      : construct_open<K>(input.points, settings, report);
}

/// Solves the surroundings of every segment of large E_p, worst first, from other starts, and keeps what is better.
template <Continuity K>
void repair(JointChain& chain, const WindowSettings& settings, GlobalReport& report) {
  constexpr double large = 0.02;
  constexpr std::size_t reach = 3;
  const std::size_t n = chain.size();
  const std::vector<double> before = parabola_energies<K>(chain);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < n; ++i)
    if (!(before[i] < large)) order.push_back(i);
  std::ranges::stable_sort(order, std::greater<>{}, [&](std::size_t i) { return before[i]; });
  ChainSystem<K> exact(fine_gauss_rule(), settings.weights);
  for (const std::size_t i : order) {
    const std::size_t first = chain.cyclic ? (i + n - std::min(reach, n)) % n : i - std::min(i, reach);
    const std::size_t count = std::min(2 * reach + 1, chain.cyclic ? n : n - first);
    JointChain best = extract(chain, first, count);
    const JointChain given = best;
    double energy = exact.value(best);
    bool improved = false;
    for (std::optional<JointChain> start : {std::optional(given), fair_start<K>(given), polygonal_start<K>(given)}) {
      if (!start) continue;
      const Minimum m = minimise<K>(Solver::lm, *start, fine_gauss_rule(),
                                    {settings.weights, settings.first_iterations, settings.tolerance});
      report.iterations += m.iterations;
      if (!(m.energy < 0.999 * energy)) continue;
      energy = m.energy;
      best = std::move(*start);
      improved = true;
    }
    if (!improved) continue;
    insert(best, first, chain);
    ++report.repaired;
  }
}

/// Whether a block still has something to gain: more than a small part of the mean energy of a segment.
template <Continuity K>
std::vector<char> unsettled_segments(const JointChain& chain, const QuadratureRule& rule, const Weights& weights) {
  constexpr double damping = 1e-6, small = 1e-6;
  ChainSystem<K> system(rule, weights);
  typename ChainSystem<K>::Step step;
  const double mean = system.linearise(chain, {}) / static_cast<double>(chain.size());
  std::vector<char> unsettled(chain.size(), 1);
  if (!system.step(chain, damping, step)) return unsettled;
  for (std::size_t i = 0; i < chain.size(); ++i)
    unsettled[i] = std::abs(system.predicted_decrease(step, damping, i)) > small * mean;
  return unsettled;
}

struct Range {
  std::size_t first, count;
};

/// Windows over the marked segments: runs of them, cut where they are long, each widened by `reach` on both sides.
std::vector<Range> windows_over(const std::vector<char>& marked, std::size_t longest, std::size_t reach) {
  std::vector<Range> windows;
  const std::size_t n = marked.size();
  for (std::size_t i = 0; i < n;) {
    if (!marked[i]) {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    while (end < n && end - i < longest && marked[end]) ++end;
    const std::size_t from = i - std::min(i, reach);
    windows.push_back({from, std::min(end + reach, n) - from});
    i = end;
  }
  return windows;
}

/// Minimises a long chain: as a whole while that pays, then in windows over what has not settled, each with a damping
/// of its own so that a bad spot does not slow the rest, then as a whole again.
template <Continuity K>
Minimum settle(JointChain& chain, const QuadratureRule& rule, const Weights& weights, double tolerance,
               int iterations) {
  constexpr double rough = 1e-3, by_parts = 1e-7, near = 1e-6, enough = 1e-7;
  constexpr std::size_t short_chain = 32, longest = 16, reach = 4;
  constexpr int sweeps = 3, steps = 4;
  if (chain.size() <= short_chain) return minimise<K>(Solver::lm, chain, rule, {weights, iterations, tolerance});
  Minimum whole = minimise<K>(Solver::lm, chain, rule, {weights, iterations, rough});
  for (int sweep = 0; tolerance < rough && sweep < sweeps && !(whole.decrease < enough && sweep > 0); ++sweep) {
    for (const Range& w : windows_over(unsettled_segments<K>(chain, rule, weights), longest, reach)) {
      JointChain part = extract(chain, w.first, w.count);
      minimise<K>(Solver::lm, part, rule, {weights, iterations, by_parts});
      insert(part, w.first, chain);
    }
    const int before = whole.iterations;
    whole = minimise<K>(Solver::lm, chain, rule, {weights, std::min(iterations, steps), tolerance, near});
    whole.iterations += before;
  }
  // The last steps need not reach the tolerance: what they still promise says how near they came.
  whole.converged = whole.converged || whole.decrease < enough;
  return whole;
}

/// Where a drawing is solved as one problem.
Frame frame_for(const Input& input, const WindowSettings& settings) {
  return {input.points.front(), settings.unit == Unit::paper ? 1.0 : mean_chord(input)};
}

template <Continuity K>
Spline<K> spline_of(const JointChain& chain, const Frame& frame) {
  Spline<K> spline{.control = {}, .t = chain.t};
  for (std::size_t i = 0; i < chain.size(); ++i) spline.control.push_back(frame.out_of(polygon<K>(chain, i)));
  return spline;
}

/// The whole curve through windows, as one chain.
template <Continuity K>
std::optional<JointChain> chain_through(const JointChain& bare, Spline<K> spline, const Frame& frame) {
  for (auto& control : spline.control) {
    control = frame.into(control);
    if (!control.allFinite()) return std::nullopt;
  }
  JointChain chain = bare;
  set_boxes(chain, spline.t);
  const std::size_t n = chain.size();
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    if (!chain.cyclic && k == 0)
      chain.joints[k] = joint_at_start<K>(spline.control.front());
    else if (!chain.cyclic && k == n)
      chain.joints[k] = joint_at_end<K>(spline.control.back());
    else
      chain.joints[k] = joint_between<K>(spline.control[(k + n - 1) % n], spline.control[k]);
  }
  if constexpr (Layout<K>::middle > 0)
    for (const auto& control : spline.control) chain.middles.push_back(control.col(Layout<K>::side));
  if (!restore_interpolation<K>(chain)) return std::nullopt;
  return chain;
}

/// In the weights that were minimised last.
template <Continuity K>
Judgement judge(const JointChain& chain, const Weights& weights) {
  return {all_sound(check_segments<K>(chain, fine_gauss_rule())),
          ChainSystem<K>(finest_gauss_rule(), weights).value(chain)};
}

/// By more than what the tolerance of a minimisation leaves open.
bool below(const Judgement& a, const Judgement& b) { return better(a, b, 1.0 - 1e-9); }

Weights last_weights(const WindowSettings& settings) {
  return settings.second_iterations == 0 ? settings.weights : settings.reduced_weights();
}

template <Continuity K>
void phase(JointChain& chain, const QuadratureRule& rule, const Weights& weights, int iterations, double tolerance,
           GlobalReport& report) {
  const Minimum m = settle<K>(chain, rule, weights, tolerance, iterations);
  report.iterations += m.iterations;
  report.converged = m.converged;
  report.trace.push_back(m.energy / static_cast<double>(chain.size()));
}

/// From a start that prefers no direction, in two stages.
template <Continuity K>
std::optional<JointChain> whole_curve(const JointChain& bare, const WindowSettings& settings, GlobalReport& report) {
  std::optional<JointChain> start = fair_start<K>(bare);
  if (!start) start = polygonal_start<K>(bare);
  if (!start) return std::nullopt;
  JointChain chain = std::move(*start);

  constexpr double rough = 1e-3;
  const QuadratureRule* rule = settings.rule;
  phase<K>(chain, *rule, settings.weights, settings.first_iterations, rough, report);
  constexpr int most_rounds = 3;
  for (int round = 0; round < most_rounds && !all_good(check_segments<K>(chain, *rule)); ++round) {
    repair<K>(chain, settings, report);
    rule = &fine_gauss_rule();
    phase<K>(chain, *rule, settings.weights, settings.first_iterations, rough, report);
  }
  // Stage 1 only prepares stage 2, unless there is none.
  const bool one_stage = settings.second_iterations == 0;
  phase<K>(chain, *rule, settings.weights, settings.first_iterations, one_stage ? settings.tolerance : 1e-6, report);
  if (one_stage) return chain;
  const Weights weights = last_weights(settings);
  JointChain second = chain;
  const double before = ChainSystem<K>(*rule, weights).value(chain);
  phase<K>(second, *rule, weights, settings.second_iterations, settings.tolerance, report);
  report.second_stage_at_rest = !report.converged && !(ChainSystem<K>(*rule, weights).value(second) < before);
  report.second_stage_reverted = !all_sound(check_segments<K>(second, *rule));
  return report.second_stage_reverted ? chain : second;
}

/// More iterations, unless the option says how many.
WindowSettings for_whole_curve(WindowSettings settings) {
  constexpr int iterations = 300;
  settings.first_iterations = iterations;
  if (settings.second_iterations == WindowSettings{}.second_iterations) settings.second_iterations = iterations;
  return settings;
}

}  // namespace

template <Continuity K>
Spline<K> solve_globally(const Input& input, const WindowSettings& given, GlobalReport& report) {
  const WindowSettings settings = for_whole_curve(given);
  const Frame frame = frame_for(input, settings);
  const JointChain bare = bare_chain(input, frame, settings.unit == Unit::span);
  std::optional<JointChain> chain = whole_curve<K>(bare, settings, report);

  // The curve by windows, if it is below, is the better start, and never a worse end.
  LocalReport windows;
  const Spline<K> by_windows = construct<K>(input, given, windows);
  const Weights weights = last_weights(settings);
  const std::optional<JointChain> local = chain_through<K>(bare, by_windows, frame);
  if (local && (!chain || below(judge<K>(*local, weights), judge<K>(*chain, weights)))) {
    report.from_local = true;
    report.second_stage_reverted = report.second_stage_at_rest = false;
    chain = local;
    const bool one_stage = settings.second_iterations == 0;
    phase<K>(*chain, fine_gauss_rule(), weights, one_stage ? settings.first_iterations : settings.second_iterations,
             settings.tolerance, report);
    if (below(judge<K>(*local, weights), judge<K>(*chain, weights))) chain = local;
  }
  return chain ? spline_of<K>(*chain, frame) : Spline<K>{};
}

template <Continuity K>
Spline<K> solve_locally(const Input& input, const WindowSettings& settings, LocalReport& report) {
  constexpr int longest = 256;
  Spline<K> by_windows = construct<K>(input, settings, report);
  if (!settings.robust || settings.solver != Solver::lm || input.size() > longest) return by_windows;
  const Frame frame = frame_for(input, settings);
  const JointChain bare = bare_chain(input, frame, settings.unit == Unit::span);
  const std::optional<JointChain> local = chain_through<K>(bare, by_windows, frame);
  if (local && all_good(check_segments<K>(*local, fine_gauss_rule()))) return by_windows;
  GlobalReport whole;
  const std::optional<JointChain> chain = whole_curve<K>(bare, for_whole_curve(settings), whole);
  report.iterations += whole.iterations;
  const Weights weights = last_weights(settings);
  if (!chain || (local && !below(judge<K>(*chain, weights), judge<K>(*local, weights)))) return by_windows;
  report.whole = true;
  return spline_of<K>(*chain, frame);
}

template Spline<Continuity::c1> solve_globally<Continuity::c1>(const Input&, const WindowSettings&, GlobalReport&);
template Spline<Continuity::g1> solve_globally<Continuity::g1>(const Input&, const WindowSettings&, GlobalReport&);
template Spline<Continuity::c2> solve_globally<Continuity::c2>(const Input&, const WindowSettings&, GlobalReport&);
template Spline<Continuity::g2> solve_globally<Continuity::g2>(const Input&, const WindowSettings&, GlobalReport&);
template Spline<Continuity::c1> solve_locally<Continuity::c1>(const Input&, const WindowSettings&, LocalReport&);
template Spline<Continuity::g1> solve_locally<Continuity::g1>(const Input&, const WindowSettings&, LocalReport&);
template Spline<Continuity::c2> solve_locally<Continuity::c2>(const Input&, const WindowSettings&, LocalReport&);
template Spline<Continuity::g2> solve_locally<Continuity::g2>(const Input&, const WindowSettings&, LocalReport&);

}  // namespace kappabench::pkappa
