#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "schemes/fpc/local_cubic.hpp"

namespace kappabench::fpc {

/// The given part of a problem: m segments in a row, numbered from 0, each through its point. Joint k is the end of
/// segment k. A closed chain has m of them; an open one starts and ends at fixed places and has m - 1 unknown ones. A
/// window of a longer chain is an open chain between two of its joints.
///
/// All lengths are in units of a power of two near the mean chord, so that areas and their squares stay in the range of
/// numbers whatever the drawing's unit is; scaling by it is exact.
struct CubicChain {
  std::vector<LocalCubic> cubic;  ///< m
  std::vector<Vec2> chord;        ///< m: point k + 1 minus point k (closed: cyclic; open: the last one is not used)
  std::vector<double> size;       ///< m: length to which those of segment k are relative
  bool closed = false;
  double unit = 1.0;          ///< in the drawing's unit
  Vec2 start = Vec2::Zero();  ///< open: where segment 0 starts, minus its point
  Vec2 end = Vec2::Zero();    ///< open: where segment m - 1 ends, minus its point

  [[nodiscard]] std::size_t segments() const { return cubic.size(); }
  [[nodiscard]] std::size_t joints() const { return closed ? cubic.size() : cubic.size() - 1; }
  [[nodiscard]] std::size_t next(std::size_t k) const { return k + 1 < cubic.size() ? k + 1 : 0; }
  [[nodiscard]] std::size_t before(std::size_t k) const { return k > 0 ? k - 1 : cubic.size() - 1; }
};

/// A chain through `points`, one task for each point that has a segment: all of a closed curve, all but the first and
/// the last, which are the fixed ends, of an open one.
[[nodiscard]] CubicChain make_chain(std::span<const Vec2> points, std::span<const PointTask> tasks, bool closed);

/// The unknowns. A joint is kept twice, relative to the points on both sides: the two differ by the chord, but near a
/// point that its segment has shrunk to, only the one relative to that point has digits left. A segment's weight is
/// |T|^(1/3), T = X x Y: the ratio of the velocities at joint k that makes the curvatures agree is a constant times the
/// ratio of the weights of its two segments (Eq. (17)).
struct State {
  std::vector<Vec2> x;             ///< m: the joint before segment k, minus point k
  std::vector<Vec2> y;             ///< m: the joint behind it, minus point k
  std::vector<double> log_weight;  ///< m

  /// Moves joint k.
  void shift(const CubicChain& chain, std::size_t k, const Vec2& by) {
    y[k] += by;
    x[chain.next(k)] += by;
  }
};

}  // namespace kappabench::fpc
