#pragma once

#include "schemes/curve/segment.hpp"

namespace kappabench {

/// A segment known by samples alone: between two of them the quintic that has the position and the first two
/// derivatives of both, so that it is C2. For curves from elsewhere that have no form of ours.
class SampledSegment final : public Segment {
 public:
  /// At least two samples, parameters strictly ascending from 0 to 1, one position and two derivatives for each, all
  /// finite; throws std::invalid_argument.
  explicit SampledSegment(SampledForm form);

  [[nodiscard]] Jet jet(double t, int order) const override;
  [[nodiscard]] ExactForm exact() const override { return form_; }
  [[nodiscard]] SegmentPtr placed(const Placement& placement) const override;

 private:
  SampledForm form_;
};

}  // namespace kappabench
