#include "schemes/fpc/windows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "schemes/fpc/newton.hpp"

namespace kappabench::fpc {
namespace {

constexpr std::size_t core = 64;  ///< segments that a window of the first pass is responsible for
constexpr int last_newton_steps = 10, polishing_steps = 5;

/// Further segments on each side of what a window is responsible for, pass by pass: other widths give a spot that
/// resisted other neighbours.
constexpr std::array<std::size_t, 8> overlaps{16, 24, 10, 40, 16, 60, 24, 100};

/// Segments begin ... begin + length - 1 of a chain, around the seam if it is closed.
struct Window {
  std::size_t begin, length;
};

class WindowSolver {
 public:
  explicit WindowSolver(const CubicChain& chain) : chain_(chain), system_(chain) {}

  Solution solve() {
    solution_.residual = std::numeric_limits<double>::infinity();
    const std::size_t m = chain_.segments();
    const std::vector<double> equal(chain_.joints(), 0.0);
    if (!system_.solve_joints(equal, solution_.state)) return std::move(solution_);
    system_.solve_weights(solution_.state);
    ++solution_.effort.sweeps;
    count(1.0, m);
    measure();
    for (std::size_t begin = 0; begin < m; begin += core)
      solve_window(around(begin, std::min(begin + core, m), overlaps[0]), false);
    for (std::size_t pass = 1; pass < overlaps.size() && !finish(); ++pass) reopen(overlaps[pass]);
    if (!solution_.converged) finish();
    return std::move(solution_);
  }

 private:
  void count(double iterations, std::size_t segments) {
    solution_.iterations += iterations * static_cast<double>(segments) / static_cast<double>(chain_.segments());
  }

  void measure() {
    solution_.residual = residual_of(chain_, solution_.state, system_.log_ratios(solution_.state));
    solution_.trace.push_back(solution_.residual);
    solution_.converged = solution_.residual <= accuracy;
  }

  /// Newton on the whole chain, which soon ends without success if there is a bad spot. Finds the open spots.
  bool finish() {
    Newton newton(system_);
    const Newton::Result result = newton.run(solution_.state, 0.0, last_newton_steps, 0.01 * accuracy);
    const int steps = result.steps + newton.polish(solution_.state, 0.0, polishing_steps);
    solution_.effort.newton += steps;
    count(steps, chain_.segments());
    measure();
    return solution_.converged;
  }

  /// Solves the spots again whose equations are open.
  void reopen(std::size_t wider) {
    const std::size_t m = chain_.segments();
    system_.evaluate(solution_.state, 0.0, values_);
    const auto open = [&](std::size_t k) {
      const Values::Segment& s = values_.segment[k];
      return !(std::abs(s.weight_gap) <= 1e-9 && s.gap.norm() <= 1e-9);
    };
    for (std::size_t begin = 0; begin < m;) {
      if (!open(begin)) {
        ++begin;
        continue;
      }
      std::size_t end = begin + 1;  // one behind the last open segment of this spot
      for (std::size_t k = end; k < m && k < end + wider; ++k)
        if (open(k)) end = k + 1;
      solve_window(around(begin, end, wider), true);
      begin = end;
    }
  }

  [[nodiscard]] Window around(std::size_t begin, std::size_t end, std::size_t wider) const {
    const std::size_t m = chain_.segments();
    if (chain_.closed) {
      const std::size_t length = std::min(end - begin + 2 * wider, m - 1);  // its fixed ends lie outside
      return {(begin + m - std::min(wider, m)) % m, length};
    }
    const std::size_t first = begin > wider ? begin - wider : 0;
    return {first, std::min(end + wider, m) - first};
  }

  void solve_window(const Window& w, bool from_here) {
    const std::size_t m = chain_.segments();
    const auto number = [&](std::size_t j) { return (w.begin + j) % m; };
    State& all = solution_.state;
    CubicChain part{.cubic = {}, .chord = {}, .size = {}, .closed = false, .unit = chain_.unit};
    State state;
    for (std::size_t j = 0; j < w.length; ++j) {
      const std::size_t k = number(j);
      part.cubic.push_back(chain_.cubic[k]);
      part.chord.push_back(chain_.chord[k]);
      part.size.push_back(chain_.size[k]);
      state.x.push_back(all.x[k]);
      state.y.push_back(all.y[k]);
      state.log_weight.push_back(all.log_weight[k]);
    }
    part.start = state.x.front();
    part.end = state.y.back();
    const Solution local = solve_chain(part, from_here ? &state : nullptr, false);
    solution_.effort += local.effort;
    count(local.iterations, w.length);
    if (!local.converged) return;
    for (std::size_t j = 0; j < w.length; ++j) {
      const std::size_t k = number(j);
      all.x[k] = local.state.x[j];
      all.y[k] = local.state.y[j];
      all.log_weight[k] = local.state.log_weight[j];
    }
  }

  const CubicChain& chain_;
  System system_;
  Solution solution_;
  Values values_;
};

}  // namespace

Solution solve_in_windows(const CubicChain& chain) { return WindowSolver(chain).solve(); }

Solution solve(const CubicChain& chain) {
  return chain.segments() > longest_whole_chain ? solve_in_windows(chain) : solve_chain(chain, nullptr, true);
}

}  // namespace kappabench::fpc
