#pragma once

#include "schemes/curve/vec.hpp"

namespace kappabench::pkappa {

/// In which a window, or a whole curve, is solved: lengths over `unit`, measured from `origin`.
struct Frame {
  Vec2 origin;
  double unit;

  /// Of a matrix with a point in each column.
  template <class Points>
  [[nodiscard]] Points into(const Points& points) const {
    return (points.colwise() - origin) / unit;
  }
  template <class Points>
  [[nodiscard]] Points out_of(const Points& points) const {
    return (points * unit).colwise() + origin;
  }
};

}  // namespace kappabench::pkappa
