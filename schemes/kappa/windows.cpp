#include "schemes/kappa/windows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "schemes/kappa/chain_part.hpp"

namespace kappabench::kappa {
namespace {

constexpr std::size_t core = 64;  ///< segments that a window of the first pass is responsible for
constexpr int rough_sweeps = 3;
constexpr int last_newton_steps = 20;

/// Further segments on each side of what a window is responsible for, pass by pass. The first pass covers the whole
/// chain, later ones the spots that are still open; other widths give a spot that resisted other neighbours.
constexpr std::array<std::size_t, 10> overlaps{14, 20, 10, 30, 6, 40, 16, 60, 24, 100};

class WindowSolver {
 public:
  explicit WindowSolver(const ChordChain& chain) : chain_(chain), system_(chain) {
    solution_.state = initial_state(chain);
    solution_.setting = uniform_setting(chain, Form::divided);
  }

  /// Goes on from a state of the whole chain.
  Solution repair(Solution unsolved) {
    solution_ = std::move(unsolved);
    solve_open_spots();
    return std::move(solution_);
  }

  Solution solve() {
    PublishedIteration sweeps(system_);
    const int swept = sweeps.steps(solution_.state, rough_sweeps);
    solution_.effort.sweeps += swept;
    count(swept, chain_.segments());
    const std::size_t m = chain_.segments();
    check();
    for (std::size_t begin = 1; begin <= m; begin += core)
      solve_window(around(begin, std::min(begin + core, m + 1), overlaps[0]), 0);
    solve_open_spots();
    return std::move(solution_);
  }

 private:
  void solve_open_spots() {
    const std::size_t m = chain_.segments();
    for (std::size_t pass = 1; pass < overlaps.size() && !check(); ++pass)
      for (std::size_t begin = 1; begin <= m;) {
        if (!open_[begin]) {
          ++begin;
          continue;
        }
        std::size_t end = begin + 1;  // one behind the last open segment of this spot
        for (std::size_t k = end; k <= m && k < end + overlaps[pass]; ++k)
          if (open_[k]) end = k + 1;
        solve_window(around(begin, end, overlaps[pass]), pass);
        begin = end;
      }
    if (!solution_.converged) finish();
  }

  void count(double iterations, std::size_t segments) {
    solution_.iterations += iterations * static_cast<double>(segments) / static_cast<double>(chain_.segments());
  }

  /// Measures the state, and which segments' equations are still open.
  bool check() {
    solution_.residual = residual_of(system_, solution_.state, values_);
    solution_.trace.push_back(solution_.residual);
    solution_.converged = solution_.residual <= accuracy;
    open_.assign(chain_.segments() + 2, false);
    for (std::size_t i = 1; i <= chain_.segments(); ++i)
      open_[i] = residual_at(system_, solution_.state, values_, i) > accuracy;
    return solution_.converged;
  }

  [[nodiscard]] Window around(std::size_t begin, std::size_t end, std::size_t wider) const {
    const std::size_t m = chain_.segments();
    if (chain_.closed) {
      const std::size_t length = std::min(end - begin + 2 * wider, m - 2);  // its fixed ends lie outside
      return {(begin + m - std::min(wider, m) - 1) % m + 1, length};
    }
    const std::size_t first = begin > wider ? begin - wider : 1;
    return {first, std::min(end - 1 + wider, m) - first + 1};
  }

  void solve_window(const Window& w, std::size_t pass) {
    const ChainPart part = part_of(chain_, solution_.state, solution_.setting, w);
    const bool whole_was_tried = chain_.segments() <= longest_whole_chain;
    const Attempts attempts = pass % 3 == 2 && !whole_was_tried ? Attempts::all : Attempts::usual;
    // A window that a bad state holds is left from zeros.
    const bool afresh = pass % 2 == 0;
    State start = part.state;
    if (afresh && pass > 0) {
      std::fill(start.e.begin() + 1, start.e.end() - 1, Vec2::Zero());
      std::fill(start.x.begin() + 1, start.x.end() - 1, 0.0);
    }
    const Solution local = solve_chain(part.chain, start, afresh ? nullptr : &part.setting, attempts, false);
    solution_.effort += local.effort;
    count(local.iterations, w.length);
    if (local.converged) put_back(chain_, w, local.state, local.setting, solution_.state, solution_.setting);
  }

  void finish() {
    Newton newton(system_);
    solution_.effort.newton += newton.run(solution_.state, solution_.setting, last_newton_steps, 0.1 * accuracy).steps;
    check();
  }

  const ChordChain& chain_;
  System system_;
  Solution solution_;
  Values values_;
  std::vector<bool> open_;
};

}  // namespace

Solution solve_in_windows(const ChordChain& chain) { return WindowSolver(chain).solve(); }

Solution repair_in_windows(const ChordChain& chain, Solution unsolved) {
  Solution repaired = WindowSolver(chain).repair(unsolved);
  if (repaired.converged) return repaired;
  unsolved.effort = repaired.effort;
  return unsolved;
}

}  // namespace kappabench::kappa
