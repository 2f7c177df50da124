#pragma once

#include <vector>

#include "schemes/pkappa/joint_chain.hpp"
#include "schemes/pkappa/solver.hpp"
#include "schemes/pkappa/soundness.hpp"

namespace kappabench::pkappa {

/// Consecutive segments as the user sees them: control polygons in the units of the input and the t of each point.
template <Continuity K>
struct Spline {
  std::vector<ControlPolygon<Layout<K>::degree>> control;
  std::vector<double> t;
};

/// The unit of length in the energies.
enum class Unit {
  span,   ///< for each segment the mean of the two chords at its point
  chord,  ///< the mean chord, of the window or of the whole curve
  paper   ///< that of the input
};

/// How a window is solved: the scheme's options.
struct WindowSettings {
  Weights weights{0.1, 0.1};
  const QuadratureRule* rule = &gauss_rule();
  Solver solver = Solver::lm;
  Unit unit = Unit::span;
  bool robust = true;           ///< a second start, verification and fallbacks; else as printed
  double second_weights = 0.1;  ///< factor of the weights in stage 2
  int first_iterations = 100;
  int second_iterations = 60;
  double tolerance = 1e-9;

  /// Those of stage 2.
  [[nodiscard]] Weights reduced_weights() const {
    return {second_weights * weights.edges, second_weights * weights.length};
  }
};

/// Segments to solve for while everything else stays: what Wang 2024, Eqs. (7) and (8) call the simplified problem.
template <Continuity K>
struct Window {
  Spline<K> start;  ///< the published start; its outermost control points are those of ends that are fixed
  std::vector<Vec2> points;
  std::vector<double> chords;  ///< for each segment the mean of the two chords at its point
  Freedom first = Freedom::none, last = Freedom::none;
};

struct WindowReport {
  int iterations = 0;
  bool fell_back = false;
  bool second_stage_reverted = false;
  bool converged = true;
  double first_energy = 0.0;           ///< weighted, after stage 1, in the window's unit
  std::vector<SegmentCheck> checks{};  ///< of the result; empty if there is none
};

/// Solves the window in two stages (Wang 2024, Section 5.3) and replaces `window.start` by the result. Control points
/// that a fixed end gives are returned bit for bit.
template <Continuity K>
WindowReport solve_window(Window<K>& window, const WindowSettings& settings);

}  // namespace kappabench::pkappa
