#include "schemes/pkappa/window.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "schemes/pkappa/frame.hpp"
#include "schemes/pkappa/soundness.hpp"
#include "schemes/pkappa/starts.hpp"

namespace kappabench::pkappa {
namespace {

/// Mean distance between consecutive points that the window passes, ends of the curve included.
template <Continuity K>
double window_unit(const Window<K>& window) {
  std::vector<Vec2> passed;
  if (window.first == Freedom::end_point) passed.push_back(window.start.control.front().col(0));
  passed.insert(passed.end(), window.points.begin(), window.points.end());
  if (window.last == Freedom::end_point) passed.push_back(window.start.control.back().template rightCols<1>());
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < passed.size(); ++i) sum += (passed[i + 1] - passed[i]).norm();
  return sum / static_cast<double>(passed.size() - 1);
}

template <Continuity K>
JointChain chain_in(const Frame& frame, const Window<K>& window, Unit unit) {
  std::vector<ControlPolygon<Layout<K>::degree>> control;
  for (const auto& c : window.start.control) control.push_back(frame.into(c));
  std::vector<Vec2> points;
  for (const Vec2& p : window.points) points.push_back(frame.into(p));
  JointChain chain = chain_of<K>(control, window.start.t, points, window.first, window.last);
  if (unit == Unit::span)
    for (const double chord : window.chords) chain.units.push_back(chord / frame.unit);
  return chain;
}

template <Continuity K>
std::optional<JointChain> published_start(const JointChain& given) {
  JointChain chain = given;
  if (!restore_interpolation<K>(chain)) return std::nullopt;
  return chain;
}

struct Candidate {
  JointChain chain;
  double energy = std::numeric_limits<double>::infinity();
  bool sound = false, good = false;
  bool converged = false;
};

/// Stage 1 from one start and then another: each until the energy settles roughly, the lower one to the end.
template <Continuity K>
class FirstStage {
 public:
  FirstStage(const WindowSettings& settings, WindowReport& report) : settings_(settings), report_(report) {}

  /// Minimises from the better of the starts; keeps the result if it is better than what there is.
  void run(std::span<const std::optional<JointChain>> starts, const QuadratureRule& rule) {
    constexpr double rough = 1e-2;
    Candidate candidate;
    for (const auto& start : starts) {
      if (!start) continue;
      Candidate here{.chain = *start};
      here.energy = minimise(here, rule, starts.size() > 1 ? rough : settings_.tolerance);
      if (here.energy < candidate.energy) candidate = std::move(here);
    }
    if (!std::isfinite(candidate.energy)) return;
    if (starts.size() > 1) candidate.energy = minimise(candidate, rule, settings_.tolerance);
    const std::vector<SegmentCheck> checks = check_segments<K>(candidate.chain, rule);
    candidate.sound = all_sound(checks);
    candidate.good = all_good(checks);
    const bool better = candidate.sound != best_.sound ? candidate.sound : candidate.energy < best_.energy;
    if (better) best_ = std::move(candidate);
  }

  [[nodiscard]] const Candidate& best() const { return best_; }

 private:
  double minimise(Candidate& candidate, const QuadratureRule& rule, double tolerance) {
    const Minimum m = pkappa::minimise<K>(settings_.solver, candidate.chain, rule,
                                          {settings_.weights, settings_.first_iterations, tolerance});
    report_.iterations += m.iterations;
    candidate.converged = m.converged;
    return std::isfinite(m.energy) ? m.energy : std::numeric_limits<double>::infinity();
  }

  const WindowSettings& settings_;
  WindowReport& report_;
  Candidate best_;
};

}  // namespace

template <Continuity K>
WindowReport solve_window(Window<K>& window, const WindowSettings& settings) {
  WindowReport report;
  const bool raw = settings.unit == Unit::paper;
  const Frame frame{raw ? Vec2::Zero() : window.points.front(), raw ? 1.0 : window_unit(window)};
  const JointChain given = chain_in<K>(frame, window, settings.unit);

  FirstStage<K> first_stage(settings, report);
  std::vector<std::optional<JointChain>> starts{published_start<K>(given)};
  if (settings.robust) starts.push_back(fair_start<K>(given));
  first_stage.run(starts, *settings.rule);
  if (settings.robust && !first_stage.best().good) {
    report.fell_back = true;
    starts.push_back(polygonal_start<K>(given));
    first_stage.run({&starts.back(), 1}, *settings.rule);
    if (!first_stage.best().sound)
      for (const auto& start : starts) first_stage.run({&start, 1}, fine_gauss_rule());
  }
  const Candidate& best = first_stage.best();
  report.converged = best.converged;
  report.first_energy = best.energy;
  if (!std::isfinite(best.energy)) return report;

  // Stage 2; if what comes out is not sound, with the finer rule; if that is not either, stage 1 stays.
  JointChain result = best.chain;
  report.second_stage_reverted = true;
  for (const QuadratureRule* rule : {settings.rule, &fine_gauss_rule()}) {
    JointChain second = best.chain;
    const Minimum m = minimise<K>(settings.solver, second, *rule,
                                  {settings.reduced_weights(), settings.second_iterations, settings.tolerance});
    report.iterations += m.iterations;
    std::vector<SegmentCheck> checks = check_segments<K>(second, *rule);
    if (settings.robust && !all_sound(checks)) continue;
    result = std::move(second);
    report.checks = std::move(checks);
    report.second_stage_reverted = false;
    break;
  }

  if (report.second_stage_reverted) report.checks = check_segments<K>(result, fine_gauss_rule());

  const Spline<K> old = window.start;
  for (std::size_t i = 0; i < result.size(); ++i) {
    window.start.control[i] = frame.out_of(polygon<K>(result, i));
    window.start.t[i] = result.t[i];
  }
  constexpr int side = Layout<K>::side;
  auto& first = window.start.control.front();
  auto& last = window.start.control.back();
  if (window.first == Freedom::none) first.template leftCols<side>() = old.control.front().template leftCols<side>();
  if (window.first == Freedom::end_point) first.col(0) = old.control.front().col(0);
  if (window.last == Freedom::none) last.template rightCols<side>() = old.control.back().template rightCols<side>();
  if (window.last == Freedom::end_point) last.template rightCols<1>() = old.control.back().template rightCols<1>();
  return report;
}

template WindowReport solve_window<Continuity::c1>(Window<Continuity::c1>&, const WindowSettings&);
template WindowReport solve_window<Continuity::g1>(Window<Continuity::g1>&, const WindowSettings&);
template WindowReport solve_window<Continuity::c2>(Window<Continuity::c2>&, const WindowSettings&);
template WindowReport solve_window<Continuity::g2>(Window<Continuity::g2>&, const WindowSettings&);

}  // namespace kappabench::pkappa
