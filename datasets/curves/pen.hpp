#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "datasets/curves/arc.hpp"
#include "datasets/curves/transform.hpp"
#include "datasets/text.hpp"
#include "schemes/curve/segment.hpp"

namespace kappabench {

/// A curve as it was drawn: one subpath.
struct Outline {
  std::vector<SegmentPtr> segments{};
  bool closed = false;
};

/// The most segments that are read from a file.
inline constexpr std::size_t most_segments = 1'000'000;

/// Draws the lines, Béziers and elliptic arcs of SVG in an element's own coordinates; what comes out is mapped.
///
/// What has no length is left out: it has no direction. A subpath that is closed within 1e-6 of its size is closed
/// there, by its last stroke: what programs write is rounded, and relative coordinates add up. Otherwise closing it
/// draws a line.
class Pen {
 public:
  /// `place`: of the element, for messages. Throws DataError for what comes out not finite, and beyond `most_segments`.
  Pen(const AffineMap& map, Place place) : map_(map), place_(std::move(place)) {}

  void move_to(const Vec2& to);
  void line_to(const Vec2& to) { draw({at_, to}); }
  void quadratic_to(const Vec2& control, const Vec2& to) { draw({at_, control, to}); }
  void cubic_to(const Vec2& first, const Vec2& second, const Vec2& to) { draw({at_, first, second, to}); }
  void arc_to(const ArcArguments& arc, const Vec2& to) { draw({at_, to}, arc); }
  void close();

  [[nodiscard]] const Vec2& at() const { return at_; }

  /// Everything drawn.
  [[nodiscard]] std::vector<Outline> outlines() &&;

 private:
  struct Stroke {
    std::vector<Vec2> points;  ///< control points, from the pen's place on; of an arc its ends
    std::optional<ArcArguments> arc;

    [[nodiscard]] bool has_length() const;
  };

  void draw(std::initializer_list<Vec2> points, const std::optional<ArcArguments>& arc = {});
  void meet_start();
  void end_subpath(bool closed);
  [[nodiscard]] SegmentPtr mapped(const Stroke& stroke) const;

  AffineMap map_;
  Place place_;
  Vec2 start_ = Vec2::Zero(), at_ = Vec2::Zero();
  std::vector<Stroke> strokes_{};  ///< of the subpath that is being drawn
  std::vector<Outline> outlines_{};
  std::size_t segments_ = 0;
};

}  // namespace kappabench
