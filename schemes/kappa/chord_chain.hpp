#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "schemes/curve/vec.hpp"

namespace kappabench::kappa {

enum class BasisKind { cubic, trigonometric };

/// The given part of a problem: m segments in a row, numbered 1 to m, each with its input point. Number 0 stands
/// before the first one and m + 1 behind the last one: the neighbours across the seam if the chain is closed, else
/// fixed control points. Joint k lies between k and k + 1.
///
/// An open curve fixes the end points; a window of a longer chain fixes its neighbours' control points and the
/// outer joints' ratios. Both are the same problem.
struct ChordChain {
  BasisKind basis = BasisKind::cubic;
  bool closed = false;
  std::vector<Vec2> chord;   ///< m + 1: chord[k] = p_{k+1} - p_k
  std::vector<double> a;     ///< m + 2: sharpness
  std::vector<double> end;   ///< m + 2: log((1 - a) / a^2), the constant of the end curvatures (Eqs. (8) and (26))
  std::vector<double> size;  ///< m + 2: mean length of the two chords at a point, to which lengths are relative
  /// Below this fraction of the product of the two chords an area counts as none: what of it rounding decides, some
  /// 1e-16, then moves the log of areas by less than the square root of the accuracy, so that Newton converges along
  /// straight runs, where areas decay from point to point until they are all rounding.
  double least_area = 1e-10;

  [[nodiscard]] std::size_t segments() const { return chord.size() - 1; }
  /// The successor of segment i, with wrap-around if closed.
  [[nodiscard]] std::size_t next(std::size_t i) const { return closed && i == segments() ? 1 : i + 1; }
};

/// A chain through `points` (all of a closed curve; of an open one the first and last are its fixed ends), one `a`
/// for each point.
[[nodiscard]] ChordChain make_chain(std::span<const Vec2> points, std::span<const double> a, bool closed,
                                    BasisKind basis);

/// The unknowns. Kept relative to the input points and on logarithmic scales, because control points far from the
/// origin and joints near a control point would lose the digits that curvature needs.
struct State {
  std::vector<Vec2> e;    ///< m + 2: c_{i,1} - p_i (Miura 2022, Eq. (2)); numbers 0 and m + 1 are copies or fixed
  std::vector<double> x;  ///< m + 1: logit of the ratio lambda_k of joint k (Eq. (7)); -inf and +inf at open ends

  /// Copies the unknowns over the seam of a closed chain.
  void close(const ChordChain& chain);
};

/// Control points at the input points, joints in the middle (Algorithm 1 of Miura 2022).
[[nodiscard]] State initial_state(const ChordChain& chain);

}  // namespace kappabench::kappa
