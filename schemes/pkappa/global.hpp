#pragma once

#include <vector>

#include "schemes/api/input.hpp"
#include "schemes/pkappa/local.hpp"

namespace kappabench::pkappa {

struct GlobalReport {
  int iterations = 0;
  int repaired = 0;  ///< surroundings of bad segments that another start solved better
  bool converged = false;
  bool second_stage_reverted = false;  ///< stage 2 was not sound, and the curve is that of stage 1
  bool second_stage_at_rest = false;   ///< stage 2 found no step down, and the curve is that of stage 1
  bool from_local = false;             ///< the curve of mode=local was the better start, or the result
  std::vector<double> trace{};         ///< weighted energy over the number of segments after each phase
};

/// Minimises the energy of the whole curve at once, open or periodic: no frozen segments, and a start that prefers no
/// direction. Never above the curve by windows in energy, weighted as in stage 2 and in the unit of `settings`, if that
/// curve is sound: where it is below, it is the start. Linear in the number of points, in time and memory. Segment i
/// passes point i + 1 if open, point i if closed. Empty if not even a start can be computed.
template <Continuity K>
[[nodiscard]] Spline<K> solve_globally(const Input& input, const WindowSettings& settings, GlobalReport& report);

/// The curve by windows (local.hpp). Where frozen segments leave it no good curve, wide windows neither, a drawing of
/// up to 256 points is solved at once from the start of `solve_globally`, and the curve kept whose energy is lower.
template <Continuity K>
[[nodiscard]] Spline<K> solve_locally(const Input& input, const WindowSettings& settings, LocalReport& report);

}  // namespace kappabench::pkappa
