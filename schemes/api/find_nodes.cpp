#include "schemes/api/find_nodes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/geometry/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "schemes/numerics/bracketed_newton.hpp"

namespace kappabench {

namespace {

constexpr int steps = 32;  // of a segment, between which a distance is taken to have one minimum at most
/// Two passages of one point are told apart by the order of the points, not by which of them misses it by less.
constexpr double alike = 4.0;
constexpr double last_places = 0x1p-40;  // of the size of a segment
constexpr double last_place = 0x1p-50;   // of the largest coordinate

/// Where a segment passes a point: a local minimum of the distance.
struct Passage {
  int segment;
  double t;
  double distance;

  [[nodiscard]] double along() const { return segment + t; }
};

/// A segment at equal steps.
std::vector<Vec2> trail_of(const Segment& segment) {
  std::vector<Vec2> trail;
  trail.reserve(steps + 1);
  for (int i = 0; i <= steps; ++i) trail.push_back(segment.jet(static_cast<double>(i) / steps, 0).position());
  return trail;
}

/// Around the trail, and what the polygon through it misses by little.
Eigen::AlignedBox2d box_of(const Segment& segment) {
  Eigen::AlignedBox2d box;
  for (const Vec2& p : trail_of(segment)) box.extend(p);
  const Vec2 margin = box.sizes() / steps;
  box.extend(Vec2(box.min() - margin));
  box.extend(Vec2(box.max() + margin));
  return box;
}

namespace geometry = boost::geometry;
using Corner = geometry::model::point<double, 2, geometry::cs::cartesian>;
using Box = geometry::model::box<Corner>;
using Boxed = std::pair<Box, std::size_t>;  ///< which segment
using Tree = geometry::index::rtree<Boxed, geometry::index::quadratic<16>>;

Corner corner_of(const Vec2& p) { return {p.x(), p.y()}; }

Tree tree_of(const std::vector<Eigen::AlignedBox2d>& boxes) {
  std::vector<Boxed> boxed;
  boxed.reserve(boxes.size());
  for (const Eigen::AlignedBox2d& box : boxes)
    boxed.emplace_back(Box(corner_of(box.min()), corner_of(box.max())), boxed.size());
  return Tree(boxed);
}

/// The parameter between `low` and `high` where the segment is nearest to p: a zero of the slope of the squared
/// distance, sought where it rises.
double nearest_between(const Segment& segment, const Vec2& p, double low, double high) {
  const auto falling = [&](double t) -> ValueAndSlope {
    const Jet jet = segment.jet(t, 2);
    const Vec2 away = jet.d[0] - p;
    return {-away.dot(jet.d[1]), -jet.d[1].squaredNorm() - away.dot(jet.d[2])};
  };
  if (!(falling(low).value > 0.0)) return low;
  if (!(falling(high).value < 0.0)) return high;
  return falling_root_in(falling, low, high, 0.5 * (low + high));
}

/// Appends the passages of one segment.
void append_passages(const Segment& segment, int index, const Vec2& p, std::vector<Passage>& passages) {
  std::vector<double> distance;
  distance.reserve(steps + 1);
  for (const Vec2& q : trail_of(segment)) distance.push_back((q - p).norm());
  const auto at = [&](int i) {
    const bool outside = i < 0 || i > steps;
    return outside ? std::numeric_limits<double>::infinity() : distance[static_cast<std::size_t>(i)];
  };
  for (int i = 0; i <= steps; ++i) {
    if (!(at(i) <= at(i - 1) && at(i) < at(i + 1))) continue;
    const double low = std::max(0, i - 1) / static_cast<double>(steps);
    const double high = std::min(steps, i + 1) / static_cast<double>(steps);
    const double t = nearest_between(segment, p, low, high);
    passages.push_back({index, t, (segment.jet(t, 0).position() - p).norm()});
  }
}

/// The passages of a point that are as near as any, in the order of the curve: segments are looked at from the nearest
/// box on, until one is too far.
std::vector<Passage> passages_of(std::span<const SegmentPtr> segments, const Tree& tree, const Vec2& p, double noise) {
  std::vector<Passage> found;
  double limit = std::numeric_limits<double>::infinity();
  const auto far = [&limit, noise] { return alike * limit + noise; };
  const Corner place = corner_of(p);
  for (auto at = tree.qbegin(geometry::index::nearest(place, static_cast<unsigned>(tree.size()))); at != tree.qend();
       ++at) {
    if (!(geometry::distance(at->first, place) <= far())) break;
    append_passages(*segments[at->second], static_cast<int>(at->second), p, found);
    for (const Passage& passage : found) limit = std::min(limit, passage.distance);
  }
  std::erase_if(found, [&](const Passage& passage) { return !(passage.distance <= far()); });
  std::ranges::sort(found, {}, &Passage::along);
  return found;
}

/// One passage of each point so that they follow one another, starting with passage `first` of the first point, on a
/// closed curve around it; of those the ones that are nearest in sum. None if there are none.
struct Choice {
  std::vector<std::size_t> passage;
  double distance = 0.0;
};

std::optional<Choice> in_order(const std::vector<std::vector<Passage>>& of_points, std::size_t first, double around) {
  const double start = of_points.front()[first].along();
  const auto along = [&](const Passage& passage) {
    return passage.along() < start ? passage.along() + around : passage.along();
  };
  // The best sum that ends with each passage, and from which one of the point before it came.
  std::vector<std::vector<double>> sum(of_points.size());
  std::vector<std::vector<std::size_t>> from(of_points.size());
  constexpr double never = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < of_points.size(); ++i) {
    sum[i].assign(of_points[i].size(), never);
    from[i].assign(of_points[i].size(), 0);
    for (std::size_t k = 0; k < of_points[i].size(); ++k) {
      const Passage& passage = of_points[i][k];
      if (i == 0) {
        if (k == first) sum[i][k] = passage.distance;
        continue;
      }
      for (std::size_t j = 0; j < of_points[i - 1].size(); ++j) {
        const double with = sum[i - 1][j] + passage.distance;
        if (!(along(of_points[i - 1][j]) < along(passage) && with < sum[i][k])) continue;
        sum[i][k] = with;
        from[i][k] = j;
      }
    }
  }
  const auto best = std::ranges::min_element(sum.back());
  if (best == sum.back().end() || !(*best < never)) return std::nullopt;
  Choice choice{std::vector<std::size_t>(of_points.size()), *best};
  auto k = static_cast<std::size_t>(best - sum.back().begin());
  for (std::size_t i = of_points.size(); i-- > 0;) {
    choice.passage[i] = k;
    k = from[i][k];
  }
  return choice;
}

/// The nearest of each, whatever the order.
Choice nearest(const std::vector<std::vector<Passage>>& of_points) {
  Choice choice;
  for (const std::vector<Passage>& passages : of_points)
    choice.passage.push_back(
        static_cast<std::size_t>(std::ranges::min_element(passages, {}, &Passage::distance) - passages.begin()));
  return choice;
}

Choice best_choice(const std::vector<std::vector<Passage>>& of_points, double around) {
  std::optional<Choice> best;
  for (std::size_t first = 0; first < of_points.front().size(); ++first) {
    std::optional<Choice> choice = in_order(of_points, first, around);
    if (choice && (!best || choice->distance < best->distance)) best = std::move(choice);
  }
  return best ? *best : nearest(of_points);
}

/// A passage that the ends of a segment cannot be told from is that end, and that of a segment the start of the next.
Node node_of(const Passage& passage, std::span<const SegmentPtr> segments, bool closed, const Vec2& p, int point,
             double noise) {
  const Segment& segment = *segments[static_cast<std::size_t>(passage.segment)];
  const auto at_end = [&](double t) {
    return std::abs(passage.t - t) < 0.5 && (segment.jet(t, 0).position() - p).norm() <= passage.distance + noise;
  };
  if (at_end(0.0)) return {.point = point, .segment = passage.segment, .t = 0.0};
  if (!at_end(1.0)) return {.point = point, .segment = passage.segment, .t = passage.t};
  const bool last = passage.segment + 1 == static_cast<int>(segments.size());
  if (last && !closed) return {.point = point, .segment = passage.segment, .t = 1.0};
  return {.point = point, .segment = last ? 0 : passage.segment + 1, .t = 0.0};
}

/// A joint is the end of one segment and the start of the next: one passage.
void unite_at_joints(std::vector<Passage>& passages, double around) {
  const auto next = [around](const Passage& a, const Passage& b) {
    return a.t == 1.0 && b.t == 0.0 && (a.segment + 1 == b.segment || (a.along() == around && b.segment == 0));
  };
  for (std::size_t i = 0; i < passages.size();) {
    const bool doubled = std::ranges::any_of(passages, [&](const Passage& other) { return next(passages[i], other); });
    if (doubled)
      passages.erase(passages.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
}

}  // namespace

std::vector<Node> find_nodes(std::span<const SegmentPtr> segments, bool closed, std::span<const Vec2> points) {
  if (points.empty() || segments.empty()) return {};
  std::vector<Eigen::AlignedBox2d> boxes;
  boxes.reserve(segments.size());
  Eigen::AlignedBox2d box;
  for (const SegmentPtr& segment : segments) {
    boxes.push_back(box_of(*segment));
    box.extend(boxes.back());
  }
  if (!box.min().allFinite() || !box.max().allFinite()) return {};
  const Tree tree = tree_of(boxes);
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  const double noise = last_places * box.sizes().norm() / static_cast<double>(segments.size()) + last_place * largest;
  const auto around = static_cast<double>(segments.size());
  std::vector<std::vector<Passage>> of_points;
  of_points.reserve(points.size());
  for (const Vec2& p : points) {
    if (!p.allFinite()) return {};
    of_points.push_back(passages_of(segments, tree, p, noise));
    if (closed || segments.size() > 1) unite_at_joints(of_points.back(), closed ? around : -1.0);
    if (of_points.back().empty()) return {};
  }
  const Choice choice = best_choice(of_points, around);
  std::vector<Node> nodes;
  nodes.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    nodes.push_back(node_of(of_points[i][choice.passage[i]], segments, closed, points[i], static_cast<int>(i), noise));
  return nodes;
}

}  // namespace kappabench
