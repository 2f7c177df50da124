#include "datasets/curves/pen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "schemes/segments/polynomial.hpp"

namespace kappabench {

bool Pen::Stroke::has_length() const {
  return std::ranges::any_of(points, [&](const Vec2& p) { return p != points.front(); });
}

void Pen::move_to(const Vec2& to) {
  end_subpath(false);
  start_ = at_ = to;
}

void Pen::close() {
  meet_start();
  if (at_ != start_) line_to(start_);
  end_subpath(true);
  at_ = start_;
}

std::vector<Outline> Pen::outlines() && {
  end_subpath(false);
  return std::move(outlines_);
}

void Pen::draw(std::initializer_list<Vec2> points, const std::optional<ArcArguments>& arc) {
  Stroke stroke{points, arc};
  at_ = stroke.points.back();
  if (!stroke.has_length()) return;
  if (++segments_ > most_segments)
    refuse(place_, fmt::format("more than {} segments", most_segments), "measure a part of the drawing");
  strokes_.push_back(std::move(stroke));
}

void Pen::meet_start() {
  if (strokes_.empty()) return;
  double size = 0.0;
  for (const Stroke& stroke : strokes_)
    for (const Vec2& p : stroke.points) size = std::max(size, (p - start_).cwiseAbs().maxCoeff());
  constexpr double rounding = 1e-6;
  Stroke& last = strokes_.back();
  const bool would_vanish = last.arc && last.points.front() == start_;
  if (would_vanish || !((at_ - start_).cwiseAbs().maxCoeff() <= rounding * size)) return;
  at_ = last.points.back() = start_;
  if (!last.has_length()) strokes_.pop_back();
}

SegmentPtr Pen::mapped(const Stroke& stroke) const {
  const SegmentPtr segment = [&]() -> SegmentPtr {
    if (stroke.arc) return arc_between(stroke.points.front(), *stroke.arc, stroke.points.back(), map_);
    std::vector<Vec2> points;
    points.reserve(stroke.points.size());
    for (const Vec2& p : stroke.points) points.emplace_back(map_ * p);
    return std::make_shared<PolynomialSegment>(points);
  }();
  for (const double t : {0.0, 0.5, 1.0}) {
    const Jet jet = segment->jet(t, 2);
    if (!(jet.d[0].allFinite() && jet.d[1].allFinite() && jet.d[2].allFinite()))
      refuse(place_, "coordinates that do not fit a double", "give numbers of usual size");
  }
  return segment;
}

void Pen::end_subpath(bool closed) {
  if (strokes_.empty()) return;
  Outline outline{.closed = closed};
  outline.segments.reserve(strokes_.size());
  for (const Stroke& stroke : strokes_) outline.segments.push_back(mapped(stroke));
  outlines_.push_back(std::move(outline));
  strokes_.clear();
}

}  // namespace kappabench
