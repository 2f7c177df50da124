#pragma once

#include <cstdint>
#include <vector>

#include "schemes/kappa/basis.hpp"
#include "schemes/kappa/chord_chain.hpp"
#include "schemes/numerics/block_tridiagonal.hpp"

namespace kappabench::kappa {

/// How the condition "the segment's stationary point of curvature is the input point" is written for one segment,
/// as a vector that must vanish. With X, Y the joints relative to the point and e the middle control point:
enum class Form : std::uint8_t {
  divided,    ///< e + (b_0 X + b_2 Y) / b_1, t from X and Y: well conditioned, but blind to peaks at the ends
  undivided,  ///< b_0 X + b_1 e + b_2 Y, t from X and Y: has false solutions X = 0, t = 0 and Y = 0, t = 1
  direct,     ///< b_0 X + b_1 e + b_2 Y, t the peak of |kappa| over the closed segment: any peak, ill conditioned
              ///< where the segment is almost straight
  at_start,   ///< X: the point is pinned to the joint before it
  at_end,     ///< Y: the point is pinned to the joint behind it
  shrunk      ///< X = Y = e = 0: the segment is its point, and no equation is left (shrunken.hpp)
};

/// What the equations are at one moment: a form for each segment (m + 2, the outer ones unused), and a smoothing
/// that is 0 in the end: it keeps peaks inside the segments and areas away from zero.
struct Setting {
  std::vector<Form> form;
  double softness = 0.0;
  double area_share = 1.0;  ///< areas are smoothed by softness times this
};
[[nodiscard]] Setting uniform_setting(const ChordChain& chain, Form form);

/// lambda and 1 - lambda of every joint, each with all its digits.
struct Ratios {
  std::vector<double> lambda, rest;
};

/// Whether the form holds the point at an end of its segment.
[[nodiscard]] inline bool is_pinned(Form form) { return form == Form::at_start || form == Form::at_end; }

/// Legs of the control polygon at point i: c_i - c_{i-1} and c_{i+1} - c_i.
struct PolygonLegs {
  Vec2 before, after;
};
[[nodiscard]] PolygonLegs polygon_legs(const ChordChain& chain, const State& state, std::size_t i);

/// Whether the area T_i between these legs counts as none (ChordChain::least_area).
[[nodiscard]] bool is_straight(const ChordChain& chain, const PolygonLegs& legs, std::size_t i);

/// The equations' values at a state. Indices are those of ChordChain.
struct Values {
  Ratios ratios;
  std::vector<double> t;     ///< parameter of the stationary point, in the basis's own units
  std::vector<Vec2> miss;    ///< interpolation equation over the point's size
  std::vector<double> jump;  ///< G2 equation at joint i, the log of the ratio of end curvatures; 0 at fixed joints
  std::vector<double> area;  ///< T_i, twice the area of the middle control points i - 1, i, i + 1
  std::vector<double> s;     ///< log |T_i|, smoothed
  /// How much of `jump` counts in `residual`: 1, or less where the control polygon turns by less than a thousandth at
  /// either end, in proportion. There the curvature is mostly the rounding of control points.
  std::vector<double> weight;
  double merit = 0.0;     ///< sum of squares of miss and jump: what a line search decreases
  double residual = 0.0;  ///< the largest |miss| or weighted |jump|; infinite if a value is not finite
};

using Block4 = BlockTridiagonal<4>;
using Right4 = BlockRight<4, 1>;

/// The equations of a chain, which must outlive it.
class System {
 public:
  explicit System(const ChordChain& chain) : chain_(&chain) {}

  [[nodiscard]] const ChordChain& chain() const { return *chain_; }

  void evaluate(const State& state, const Setting& setting, Values& values) const;

  /// Only `area`, `s`, `jump` and `weight`, areas smoothed by `softness`.
  void evaluate_jumps(const State& state, double softness, Values& values) const;

  /// The Jacobian at `state`, in the order (e_x, e_y, x, s) of unknowns and (miss, miss, jump, s) of equations, and
  /// the negative values as right-hand side. `values` must come from `evaluate` at the same state and setting.
  void linearise(const State& state, const Setting& setting, const Values& values, Block4& jacobian,
                 std::vector<Right4>& right) const;

 private:
  const ChordChain* chain_;
};

/// Joints before and behind point i relative to it: X and Y.
struct Ends {
  Vec2 x, y;
};
[[nodiscard]] Ends ends(const ChordChain& chain, const State& state, const Ratios& ratios, std::size_t i);
[[nodiscard]] Ratios ratios_of(const State& state);

/// The sign and size of d|kappa|/dt (up to a positive factor) along segment i with middle control point e, at a
/// parameter in the basis's own units.
[[nodiscard]] double peak_slope(const ChordChain& chain, std::size_t i, const Vec2& e, const Ends& q, double t);
/// The basis's parameter at the end of a segment.
[[nodiscard]] double last_parameter(BasisKind basis);

/// How far a state is from a solution, whatever form an iteration uses: the largest, over points and joints, of
/// weighted |jump| and of the distance, over the point's size, by which a segment passes its point at t, or of K(t)
/// over the sum of the squares of its legs if that is more: control points that move by so much of their legs bring K
/// to zero. t is the stationary point of the divided form, or an end towards which |kappa| rises if that is nearer to a
/// solution.
[[nodiscard]] double residual_of(const System& system, const State& state, Values& values);
/// The part of point i and the joint behind it; `values` are those of `residual_of`.
[[nodiscard]] double residual_at(const System& system, const State& state, const Values& values, std::size_t i);
/// The same with a given form for each point.
[[nodiscard]] double residual_of(const System& system, const State& state, const Setting& setting, Values& values);
/// The form in which point i is nearest to a solution, by the same rule; `values` are those of `residual_of`.
[[nodiscard]] Form nearest_form(const System& system, const State& state, const Values& values, std::size_t i);

/// The stationary point of the segment with these ends through its point, in the basis's own units, and the basis
/// there (Miura 2022, Section 3.1).
[[nodiscard]] double stationary_parameter(const ChordChain& chain, std::size_t i, const Ends& q);
[[nodiscard]] Blend stationary_blend(const ChordChain& chain, std::size_t i, const Ends& q);

}  // namespace kappabench::kappa
