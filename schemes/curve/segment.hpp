#pragma once

#include <memory>
#include <span>

#include "schemes/curve/exact_form.hpp"
#include "schemes/curve/jet.hpp"
#include "schemes/curve/placement.hpp"

namespace kappabench {

class Segment;
using SegmentPtr = std::shared_ptr<const Segment>;

/// One smooth piece of a curve on t in [0, 1]. All that the author of a new kind of segment writes is
/// `jet` and `exact`; overriding `jets` is worth it where a batch can share work.
/// Segments are immutable and safe to read from several threads.
class Segment {
 public:
  virtual ~Segment() = default;

  /// Analytic position and first `order` derivatives at `t`, 0 <= order <= max_jet_order.
  /// t outside [0, 1] extrapolates the same formula; nothing is guaranteed there.
  [[nodiscard]] virtual Jet jet(double t, int order) const = 0;

  /// `out[i] = jet(t[i], order)` for every i; the spans have equal length. Results agree with `jet`
  /// to rounding.
  virtual void jets(std::span<const double> t, int order, std::span<Jet> out) const;

  /// The defining numbers. Those of a segment that has none are `OpaqueForm`.
  [[nodiscard]] virtual ExactForm exact() const = 0;

  /// The segment whose jets are those of this one, placed. Null, the default, leaves it to `place`, which then wraps
  /// this segment: its exact form is lost.
  [[nodiscard]] virtual SegmentPtr placed(const Placement&) const { return nullptr; }

  /// Control points of a polynomial Bézier segment, else none: c(t) lies in their hull and c'(t) in that of their
  /// differences times the degree.
  [[nodiscard]] virtual std::span<const Vec2> bezier_points() const { return {}; }

 protected:
  Segment() = default;
  Segment(const Segment&) = default;
  Segment& operator=(const Segment&) = default;
};

/// jet(t, 0).position(), at the ends of a Bézier segment the control point itself.
[[nodiscard]] inline Vec2 position_at(const Segment& segment, double t) {
  if (t == 0.0 || t == 1.0)
    if (const std::span<const Vec2> points = segment.bezier_points(); !points.empty())
      return t == 0.0 ? points.front() : points.back();
  return segment.jet(t, 0).position();
}

/// The segment, placed.
[[nodiscard]] SegmentPtr place(const SegmentPtr& segment, const Placement& placement);

}  // namespace kappabench
