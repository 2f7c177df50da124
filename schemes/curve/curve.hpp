#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "schemes/curve/segment.hpp"

namespace kappabench {

/// What a scheme promises where two segments meet. `g1_equal_magnitude` is the joint of the kappa and
/// FPC families at an inflection: tangents agree and |kappa| agrees, but kappa changes sign.
enum class Continuity { g0, g1, g1_equal_magnitude, g2, c1, c2 };

/// "G0", "G1", "G1 |k|", "G2", "C1", "C2".
[[nodiscard]] std::string_view name(Continuity continuity);

/// The end of segment `segment`, where the next one starts (the first one again, if the curve is closed).
struct Joint {
  int segment;
  Continuity claimed;
};

/// Where the curve passes through input point `point`. A point may have several nodes (a loop has two).
struct Node {
  int point;
  int segment;
  double t;
  /// What the scheme says of the node: words without blanks, each once, in alphabetical order. SchemeInfo::marks says
  /// what they mean.
  std::vector<std::string> marks{};

  [[nodiscard]] bool has(std::string_view mark) const;
};

/// An immutable planar curve: segments in order, the joints between them, and the nodes where it passes
/// through the input points. Cheap to copy: segments are shared.
class Curve {
 public:
  /// Needs at least one segment; joints and nodes name existing segments, marks are words and are put in order. Throws
  /// std::invalid_argument.
  /// A closed curve of n segments has n joints, an open one n - 1.
  Curve(std::vector<SegmentPtr> segments, std::vector<Joint> joints, std::vector<Node> nodes, bool closed);

  [[nodiscard]] int size() const { return static_cast<int>(segments_.size()); }
  [[nodiscard]] bool closed() const { return closed_; }
  [[nodiscard]] const Segment& segment(int i) const { return *segments_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const std::vector<SegmentPtr>& segments() const { return segments_; }
  [[nodiscard]] const std::vector<Joint>& joints() const { return joints_; }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

  /// The segment that follows `i`, with wrap-around.
  [[nodiscard]] int next(int i) const { return i + 1 < size() ? i + 1 : 0; }

  [[nodiscard]] Vec2 start() const { return segment(0).jet(0.0, 0).position(); }
  [[nodiscard]] Vec2 end() const { return segment(size() - 1).jet(1.0, 0).position(); }

 private:
  std::vector<SegmentPtr> segments_;
  std::vector<Joint> joints_;
  std::vector<Node> nodes_;
  bool closed_;
};

/// The curve, placed: the same joints and nodes.
[[nodiscard]] Curve place(const Curve& curve, const Placement& placement);

/// A curve evaluated at the same parameters in every segment: what figures and sampled metrics read.
struct CurveSamples {
  std::vector<double> t;  ///< parameters within a segment, ascending, the same for all
  std::vector<Jet> jets;  ///< segment-major: jets[segment * t.size() + j]
  int order;

  [[nodiscard]] std::span<const Jet> of_segment(int segment) const {
    return std::span{jets}.subspan(static_cast<std::size_t>(segment) * t.size(), t.size());
  }
};

/// Evaluates every segment at `per_segment` >= 2 uniform parameters, both ends included.
[[nodiscard]] CurveSamples sample(const Curve& curve, int per_segment, int order);

}  // namespace kappabench
