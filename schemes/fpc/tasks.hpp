#pragma once

#include <string>
#include <vector>

#include "schemes/fpc/local_cubic.hpp"

namespace kappabench::fpc {

/// The options of the scheme, for points that have none of their own.
struct Defaults {
  double h = 0.5;
  bool h_sign_by_rule = true;  ///< |h| with the sign that keeps away from the singular value; else h as it is
  double alpha = 0.0;          ///< 0: half of min(t, 1 - t)
  double beta = 0.0;
};

/// One task for each point that has a segment, or one line that says why there can be none.
struct Tasks {
  std::vector<PointTask> tasks;
  std::string problem;
};

/// Reads types and shapes of the points, places t by chord length (Eqs. (20), (21)) and checks the ranges. A point's
/// own h is taken as it is. Refused: a type at an end of an open curve, a loop that reaches out of its segment, an h
/// that lets a second inflection into the segment, and an h at which the inflection has no solution.
[[nodiscard]] Tasks read_tasks(const Input& input, const Defaults& defaults);

}  // namespace kappabench::fpc
