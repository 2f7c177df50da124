#pragma once

#include <vector>

#include "schemes/curve/curve.hpp"

namespace kappabench {

/// The segments from one input point to the next, and what is claimed where they meet.
struct SpanPieces {
  std::vector<SegmentPtr> segments;  ///< at least one
  Continuity inside;                 ///< at the joints between them
  /// At the joint to the next span, where both have a direction and the path does not turn back (claim_at); unused at
  /// the end of an open curve.
  Continuity at_end;
};

/// A curve whose nodes are joints: span i runs from point i to point i + 1, on a closed curve the last one to point 0.
[[nodiscard]] Curve curve_of_spans(std::vector<SpanPieces> spans, bool closed);

}  // namespace kappabench
