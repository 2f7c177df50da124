#pragma once

#include <string>
#include <vector>

#include "schemes/api/fit.hpp"

namespace kappabench::chen {

/// What a fitted FPC-curve has, against what its points ask for (Chen 2019, Sect. 3, requirements (1) and (2)).
struct FeatureCheck {
  int cusps = 0, loops = 0, inflections = 0;  ///< found inside segments; loops are local: of one segment with itself
  int misplaced_cusps = 0;                    ///< not at a point of type cusp
  int misplaced_loops = 0;                    ///< not at a point of type loop
  int misplaced_inflections = 0;              ///< inside a segment and not at a point of type inflection
  int missing = 0;  ///< typed points without their feature; a point whose segment has shrunk to nothing is one
  int typed = 0;    ///< points of type cusp, loop or inflection
  /// Loops at a point of that type, too thin for the search: it sees their tip as a cusp or not their crossing. That
  /// they are loops is known from the exact sign of the discriminant (Sect. 3.1).
  int thin_loops = 0;
  int uncertified = 0;  ///< segments whose crossings could not all be found
  std::string first;    ///< the first thing wrong, in words; empty if nothing is

  [[nodiscard]] bool holds() const {
    return misplaced_cusps + misplaced_loops + misplaced_inflections + missing + uncertified == 0;
  }
};

/// A place counts as at a point when it is within 1e-6 mean chord of it.
[[nodiscard]] FeatureCheck check_features(const Fit& fit);

}  // namespace kappabench::chen
