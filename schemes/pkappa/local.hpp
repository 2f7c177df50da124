#pragma once

#include <span>

#include "schemes/api/edit.hpp"
#include "schemes/pkappa/window.hpp"

namespace kappabench::pkappa {

/// What happened in the windows that a construction or an edit solved.
struct LocalReport {
  int windows = 0;
  int iterations = 0;
  int fallbacks = 0;   ///< windows that needed other starts than the usual two
  int widened = 0;     ///< windows beyond three segments that made the curve better
  int reverted = 0;    ///< windows that kept stage 1
  bool whole = false;  ///< the windows did not do: the curve is that of one problem
  int unsound = 0;     ///< windows whose result failed verification; a later one may have mended it
  int unfinished = 0;  ///< windows that met the iteration limit in stage 1

  void add(const WindowReport& window);
};

/// The open curve through `points`, inserted one by one (Wang 2024, Section 5.1 and Eq. (7)): segment i passes
/// point i + 1. At least 3 points.
template <Continuity K>
[[nodiscard]] Spline<K> construct_open(std::span<const Vec2> points, const WindowSettings& settings,
                                       LocalReport& report);

/// The closed curve: the open one, closed by Eq. (8). Segment i passes point i. At least 3 points.
template <Continuity K>
[[nodiscard]] Spline<K> construct_closed(std::span<const Vec2> points, const WindowSettings& settings,
                                         LocalReport& report);

/// Edits a spline (Section 5.1, local shape editing); `edited` are its points afterwards. Only these
/// segments change: a move's own and one on each side (two at an open end); for an insertion the new one and one on
/// each side, at an open end the last three (or, where those do not do, up to seven: see README.md); for an erasure two
/// on each side. All others stay bit for bit. False, and nothing done, where fewer points are left than the scheme
/// takes.
template <Continuity K>
[[nodiscard]] bool edit_locally(Spline<K>& spline, std::span<const Vec2> edited, bool closed, const Edit& change,
                                const WindowSettings& settings, LocalReport& report);

}  // namespace kappabench::pkappa
