#include "experiments/check/transformed.hpp"

#include <cmath>
#include <memory>
#include <utility>

namespace kappabench::check {

namespace {

/// Another segment under a map.
class TransformedSegment final : public Segment {
 public:
  TransformedSegment(SegmentPtr of, Similarity map) : of_(std::move(of)), map_(std::move(map)) {}

  [[nodiscard]] Jet jet(double t, int order) const override {
    Jet result = of_->jet(t, order);
    result.d[0] = map_(result.d[0]);
    for (int k = 1; k <= order; ++k) {
      Vec2& d = result.d[static_cast<std::size_t>(k)];
      d = map_.linear(d);
    }
    return result;
  }
  [[nodiscard]] ExactForm exact() const override { return OpaqueForm{}; }

 private:
  SegmentPtr of_;
  Similarity map_;
};

}  // namespace

Vec2 Similarity::linear(Vec2 p) const {
  if (mirror) p.y() = -p.y();
  const double c = std::cos(angle), s = std::sin(angle);
  return scale * Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y());
}

Vec2 Similarity::operator()(const Vec2& p) const { return linear(p) + shift; }

Similarity Similarity::inverse() const {
  // A mirror is its own inverse; before it, the turn runs the other way.
  Similarity back{1.0 / scale, mirror ? angle : -angle, Vec2::Zero(), mirror};
  back.shift = -back.linear(shift);
  return back;
}

Input transformed(Input input, const Similarity& map) {
  for (Vec2& p : input.points) p = map(p);
  for (PointOptions& options : input.options) {
    if (options.tangent) options.tangent = (map.mirror ? -*options.tangent : *options.tangent) + map.angle;
    if (options.curvature) options.curvature = (map.mirror ? -*options.curvature : *options.curvature) / map.scale;
  }
  return input;
}

Curve transformed(const Curve& curve, const Similarity& map) {
  std::vector<SegmentPtr> segments;
  for (const SegmentPtr& segment : curve.segments())
    segments.push_back(std::make_shared<TransformedSegment>(segment, map));
  return {std::move(segments), curve.joints(), curve.nodes(), curve.closed()};
}

Input reordered(const Input& input, const std::vector<int>& order) {
  Input result;
  result.closed = input.closed;
  for (const int i : order) {
    result.points.push_back(input.points[static_cast<std::size_t>(i)]);
    result.ids.push_back(input.id_of(i));
    if (!input.options.empty()) result.options.push_back(input.options_of(i));
  }
  return result;
}

Input reversed(const Input& input, const std::vector<int>& order) {
  Input result = reordered(input, order);
  for (PointOptions& options : result.options) {
    std::swap(options.alpha, options.beta);
    if (options.tangent) options.tangent = *options.tangent + std::numbers::pi;
    if (options.curvature) options.curvature = -*options.curvature;
  }
  return result;
}

std::vector<Span> with_old_names(std::vector<Span> renamed, const std::vector<int>& order) {
  for (Span& span : renamed) {
    if (span.from != no_point) span.from = order[static_cast<std::size_t>(span.from)];
    if (span.to != no_point) span.to = order[static_cast<std::size_t>(span.to)];
  }
  return renamed;
}

}  // namespace kappabench::check
