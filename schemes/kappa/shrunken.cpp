#include "schemes/kappa/shrunken.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "schemes/kappa/chain_part.hpp"

namespace kappabench::kappa {
namespace {

constexpr double tiny = 1e-4;             ///< both joints are so near to the point, over its size
constexpr double nearly_straight = 1e-3;  ///< sine of the turn between the neighbours' control points, at the point
constexpr double straight = 1e-11;        ///< the same for a solution
constexpr double lost = 0.1;              ///< part of a curvature that rounding must not explain
constexpr std::size_t reach = 64;         ///< segments to each side that feel the change

class Shrinking {
 public:
  Shrinking(const ChordChain& chain, double rounding, Solution& solution)
      : chain_(chain), rounding_(rounding), solution_(solution) {}

  void run() {
    std::optional<Solution> given;
    bool any = false;
    for (std::size_t i = 1; i <= chain_.segments(); ++i) {
      if (!may_shrink(i)) continue;
      if (!given) given = solution_;
      any = try_at(i) || any;
    }
    if (!any) return;
    solution_.residual = residual_of_runs();
    solution_.converged = solution_.residual <= accuracy;
    if (given->converged && !solution_.converged) {
      solution_ = std::move(*given);
    } else {
      solution_.trace.push_back(solution_.residual);
    }
  }

 private:
  [[nodiscard]] Ends ends_of(std::size_t i) const {
    // Only the two joints of one segment: a scan of all must stay linear.
    const std::size_t b = before(i);
    State near{{solution_.state.e[i - 1], solution_.state.e[i], solution_.state.e[i + 1]},
               {solution_.state.x[b], solution_.state.x[i]}};
    const Ratios r = ratios_of(near);
    return {r.rest[0] * (near.e[0] - chain_.chord[i - 1]) + r.lambda[0] * near.e[1],
            r.rest[1] * near.e[1] + r.lambda[1] * (near.e[2] + chain_.chord[i])};
  }

  /// The joint before segment i.
  [[nodiscard]] std::size_t before(std::size_t i) const { return chain_.closed && i == 1 ? chain_.segments() : i - 1; }

  /// Of the turn from c_{i-1} through the point to c_{i+1}.
  [[nodiscard]] double sine_at_point(std::size_t i) const {
    const Vec2 arriving = chain_.chord[i - 1] - solution_.state.e[i - 1];
    const Vec2 leaving = chain_.chord[i] + solution_.state.e[i + 1];
    return std::abs(cross(arriving, leaving)) / (arriving.norm() * leaving.norm());
  }

  [[nodiscard]] bool may_shrink(std::size_t i) const {
    const Ends q = ends_of(i);
    return std::max(q.x.norm(), q.y.norm()) < tiny * chain_.size[i] && sine_at_point(i) < nearly_straight;
  }

  /// Whether rounding alone explains too much of the curvature, which goes with the area of the segment's legs.
  [[nodiscard]] bool curvature_is_lost(std::size_t i) const {
    const Ends q = ends_of(i);
    const Vec2 first = solution_.state.e[i] - q.x, second = q.y - solution_.state.e[i];
    return 2.0 * rounding_ * (first.norm() + second.norm()) > lost * std::abs(cross(first, second));
  }

  [[nodiscard]] bool is_shrunk(std::size_t i) const { return solution_.setting.form[i] == Form::shrunk; }

  /// Segments from i on, to the left or right, up to the next shrunken one or the end of the chain.
  [[nodiscard]] std::size_t run_length(std::size_t i, bool forward, std::size_t most) const {
    const std::size_t m = chain_.segments();
    std::size_t count = 0, k = i;
    while (count < most) {
      if (!chain_.closed && (forward ? k == m : k == 1)) break;
      k = forward ? chain_.next(k) : (k == 1 ? m : k - 1);
      if (k == i || is_shrunk(k)) break;
      ++count;
    }
    return count;
  }

  /// What is to be solved again when segment i shrinks; empty if nothing would be left on one of its sides.
  [[nodiscard]] std::vector<Window> surroundings(std::size_t i) const {
    const std::size_t m = chain_.segments(), left = run_length(i, false, reach), right = run_length(i, true, reach);
    if (left == 0 || right == 0) return {};
    const std::size_t next = chain_.next(i);
    if (chain_.closed && left + right >= m - 1) return {{next, run_length(i, true, m)}};
    return {{chain_.closed ? (i + m - left - 1) % m + 1 : i - left, left}, {next, right}};
  }

  /// True if segment i is shrunken now.
  bool try_at(std::size_t i) {
    const std::vector<Window> windows = surroundings(i);
    if (windows.empty()) return false;
    const bool is_lost = curvature_is_lost(i);
    State& state = solution_.state;
    Setting& setting = solution_.setting;
    const Window own{i, 1};
    const ChainPart given = part_of(chain_, state, setting, own);
    std::vector<ChainPart> given_around;
    for (const Window& w : windows) given_around.push_back(part_of(chain_, state, setting, w));

    setting.form[i] = Form::shrunk;
    state.e[i] = Vec2::Zero();
    state.x[before(i)] = std::numeric_limits<double>::infinity();
    state.x[i] = -std::numeric_limits<double>::infinity();
    state.close(chain_);
    bool solved = true;
    for (const Window& w : windows) {
      const ChainPart part = part_of(chain_, state, setting, w);
      const Solution found = solve_chain(part.chain, part.state, &part.setting, Attempts::usual, false);
      solution_.effort += found.effort;
      solved = solved && found.converged;
      put_back(chain_, w, found.state, found.setting, state, setting);
    }
    if (solved && (is_lost || sine_at_point(i) <= straight)) return true;

    for (std::size_t k = 0; k < windows.size(); ++k)
      put_back(chain_, windows[k], given_around[k].state, given_around[k].setting, state, setting);
    put_back(chain_, own, given.state, given.setting, state, setting);
    state.x[before(i)] = given.state.x[0];
    state.x[i] = given.state.x[1];
    state.close(chain_);
    return false;
  }

  /// The residual of the parts between shrunken segments.
  [[nodiscard]] double residual_of_runs() const {
    const std::size_t m = chain_.segments();
    double largest = 0.0;
    Values values;
    const auto add = [&](const Window& w) {
      const ChainPart part = part_of(chain_, solution_.state, solution_.setting, w);
      largest = std::max(largest, residual_of(System(part.chain), part.state, values));
    };
    if (!chain_.closed && !is_shrunk(1)) add({1, run_length(1, true, m) + 1});
    for (std::size_t i = 1; i <= m; ++i)
      if (is_shrunk(i)) add({chain_.next(i), run_length(i, true, m)});
    return largest;
  }

  const ChordChain& chain_;
  double rounding_;
  Solution& solution_;
};

}  // namespace

void shrink_at_inflections(const ChordChain& chain, double rounding, Solution& solution) {
  if (chain.segments() > 1 && std::isfinite(solution.residual)) Shrinking(chain, rounding, solution).run();
}

}  // namespace kappabench::kappa
