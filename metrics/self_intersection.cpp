#include "metrics/self_intersection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "metrics/arc_samples.hpp"
#include "schemes/curve/exact_curvature.hpp"
#include "schemes/curve/tangents.hpp"

namespace kappabench {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double most_turn = pi / 3.0;
constexpr double finest = 1e-9;         // of the curve's length
constexpr double same_crossing = 1e-8;  // of the curve's length, along it
constexpr long budget_per_arc = 400;
constexpr long least_budget = 200000;

/// A convex arc and the triangle around it.
struct Arc {
  int segment;
  double t0;
  double t1;
  Vec2 start_tangent;
  Vec2 end_tangent;
  double turn;  ///< signed, radians
  std::array<Vec2, 3> hull;

  [[nodiscard]] const Vec2& start() const { return hull[0]; }
  [[nodiscard]] const Vec2& end() const { return hull[2]; }
  [[nodiscard]] double size() const { return (end() - start()).norm(); }
};

class Search {
 public:
  explicit Search(const Curve& curve) : curve_(curve), arcs_(curve) {
    for (int i = 0; i < curve_.size(); ++i) cut(i);
    budget_ = std::max(least_budget, budget_per_arc * static_cast<long>(pieces_.size()));
  }

  Crossings run() {
    // Sweep: arcs whose boxes overlap in x, then all pairs of them.
    std::vector<std::size_t> order(pieces_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto least_x = [&](std::size_t i) {
      const auto& h = pieces_[i].hull;
      return std::min({h[0].x(), h[1].x(), h[2].x()});
    };
    const auto most_x = [&](std::size_t i) {
      const auto& h = pieces_[i].hull;
      return std::max({h[0].x(), h[1].x(), h[2].x()});
    };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return least_x(a) < least_x(b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = i + 1; j < order.size() && least_x(order[j]) <= most_x(order[i]); ++j) {
        const auto [a, b] = std::minmax(order[i], order[j]);
        compare(pieces_[a], pieces_[b]);
      }
    }
    return {std::move(found_), budget_ > 0};
  }

 private:
  [[nodiscard]] const Segment& segment(const Arc& arc) const { return curve_.segment(arc.segment); }

  [[nodiscard]] Arc make(int index, double t0, double t1) const {
    const Segment& s = curve_.segment(index);
    const double rest = 1e-8 * arcs_.segment_length(index);
    const Vec2 a = s.jet(t0, 0).position();
    const Vec2 b = s.jet(t1, 0).position();
    const Vec2 da = unit_tangent(s, t0, Side::after, rest);
    const Vec2 db = unit_tangent(s, t1, Side::before, rest);
    const double sine = cross(da, db);
    Vec2 apex = 0.5 * (a + b);
    if (std::abs(sine) > 1e-7) apex = a + da * (cross(b - a, db) / sine);
    return {index, t0, t1, da, db, angle_between(da, db), {a, apex, b}};
  }

  /// Cuts a segment into convex arcs.
  void cut(int index) {
    const Segment& s = curve_.segment(index);
    if (!(arcs_.segment_length(index) > 0.0)) return;
    std::vector<double> bounds = cusps(s);
    for (const RootBracket& bracket : inflections(s).at) bounds.push_back(bracket.mid());
    bounds.push_back(0.0);
    bounds.push_back(1.0);
    std::sort(bounds.begin(), bounds.end());
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
      if (!(bounds[i] < bounds[i + 1])) continue;
      double turned = 0.0;
      double from = bounds[i];
      for (const ArcSample& sample : arc_samples(s, bounds[i], bounds[i + 1])) {
        const double more = sample.weight * std::abs(sample.curvature);
        if (turned + more > 0.9 * most_turn && sample.t > from) {
          pieces_.push_back(make(index, from, sample.t));
          from = sample.t;
          turned = 0.0;
        }
        turned += more;
      }
      pieces_.push_back(make(index, from, bounds[i + 1]));
    }
  }

  /// Does b start where a ends?
  [[nodiscard]] bool follows(const Arc& a, const Arc& b) const {
    if (a.segment == b.segment && a.t1 == b.t0) return true;
    const bool joined = curve_.closed() || a.segment + 1 < curve_.size();
    if (!joined || a.t1 != 1.0 || b.t0 != 0.0) return false;
    // Segments without length in between are skipped.
    int next = curve_.next(a.segment);
    while (next != b.segment && next != a.segment && !(arcs_.segment_length(next) > 0.0)) next = curve_.next(next);
    return next == b.segment;
  }

  [[nodiscard]] static bool apart(const Arc& a, const Arc& b) {
    const auto separated_along = [&](const Vec2& axis) {
      const auto interval = [&](const Arc& arc) {
        const double p[] = {axis.dot(arc.hull[0] - a.start()), axis.dot(arc.hull[1] - a.start()),
                            axis.dot(arc.hull[2] - a.start())};
        return std::minmax({p[0], p[1], p[2]});
      };
      const auto [a0, a1] = interval(a);
      const auto [b0, b1] = interval(b);
      const double slack = 1e-14 * ((a1 - a0) + (b1 - b0));
      return a1 + slack < b0 || b1 + slack < a0;
    };
    return separated_along(Vec2::UnitX()) || separated_along(Vec2::UnitY()) ||
           separated_along(left_normal(a.end() - a.start())) || separated_along(left_normal(b.end() - b.start()));
  }

  /// No direction of one arc is parallel to one of the other: they meet at most once.
  [[nodiscard]] static bool transversal(const Arc& a, const Arc& b) {
    const double between = angle_between(a.start_tangent, b.start_tangent) + 0.5 * (b.turn - a.turn);
    const double line_angle = std::abs(std::remainder(between, pi));
    return line_angle > 0.5 * (std::abs(a.turn) + std::abs(b.turn)) + 1e-7;
  }

  /// Newton's method for a(t) = b(u) from the crossing of the chords, if it ends inside both arcs.
  [[nodiscard]] std::optional<Crossing> crossing(const Arc& a, const Arc& b) const {
    const Vec2 ca = a.end() - a.start();
    const Vec2 cb = b.end() - b.start();
    const double det = cross(ca, cb);
    if (det == 0.0) return std::nullopt;
    const Vec2 offset = b.start() - a.start();
    double t = a.t0 + (a.t1 - a.t0) * std::clamp(cross(offset, cb) / det, 0.0, 1.0);
    double u = b.t0 + (b.t1 - b.t0) * std::clamp(cross(offset, ca) / det, 0.0, 1.0);
    const double slack_t = 1e-9 * (a.t1 - a.t0) + 1e-14;
    const double slack_u = 1e-9 * (b.t1 - b.t0) + 1e-14;
    for (int step = 0; step < 12; ++step) {
      const Jet ja = segment(a).jet(t, 1);
      const Jet jb = segment(b).jet(u, 1);
      const Vec2 gap = jb.position() - ja.position();
      const double slope = cross(ja.d[1], jb.d[1]);
      if (slope == 0.0) return std::nullopt;
      const double dt = cross(gap, jb.d[1]) / slope;
      const double du = cross(gap, ja.d[1]) / slope;
      t += dt;
      u += du;
      const bool inside = t >= a.t0 - slack_t && t <= a.t1 + slack_t && u >= b.t0 - slack_u && u <= b.t1 + slack_u;
      if (std::abs(dt) <= 1e-14 + 0.1 * slack_t && std::abs(du) <= 1e-14 + 0.1 * slack_u) {
        if (!inside) return std::nullopt;
        return Crossing{{a.segment, t}, {b.segment, u}, segment(a).jet(t, 0).position()};
      }
      const bool lost = t < 2 * a.t0 - a.t1 || t > 2 * a.t1 - a.t0 || u < 2 * b.t0 - b.t1 || u > 2 * b.t1 - b.t0;
      if (lost || std::isnan(t) || std::isnan(u)) return std::nullopt;
    }
    return std::nullopt;
  }

  void record(const Crossing& crossing) {
    const double s = arcs_.position(crossing.first);
    const double u = arcs_.position(crossing.second);
    const auto near = [&](double x, double y) {
      const double direct = std::abs(x - y);
      const double along = curve_.closed() ? std::min(direct, arcs_.length() - direct) : direct;
      return along <= same_crossing * arcs_.length();
    };
    if (near(s, u)) return;  // a common end of neighbours
    for (const auto& [v, w] : positions_) {
      if ((near(s, v) && near(u, w)) || (near(s, w) && near(u, v))) return;
    }
    positions_.emplace_back(s, u);
    found_.push_back(crossing);
  }

  void compare(const Arc& a, const Arc& b) {
    if (--budget_ <= 0 || apart(a, b)) return;
    const bool ab = follows(a, b);
    const bool ba = follows(b, a);
    if (ab != ba) {
      const double corner =
          ab ? angle_between(a.end_tangent, b.start_tangent) : angle_between(b.end_tangent, a.start_tangent);
      if (std::abs(a.turn) + std::abs(b.turn) + std::abs(corner) < pi * (1.0 - 1e-6)) return;
    }
    if (transversal(a, b)) {
      if (ab || ba) return;
      if (const auto hit = crossing(a, b)) {
        record(*hit);
        return;
      }
    }
    const double least = finest * arcs_.length();
    if (a.size() <= least && b.size() <= least) return;
    const bool split_a = a.size() >= b.size();
    const Arc& longer = split_a ? a : b;
    const double mid = 0.5 * (longer.t0 + longer.t1);
    if (!(mid > longer.t0 && mid < longer.t1)) return;
    for (const Arc& half : {make(longer.segment, longer.t0, mid), make(longer.segment, mid, longer.t1)}) {
      split_a ? compare(half, b) : compare(a, half);
    }
  }

  Curve curve_;
  ArcMap arcs_;
  std::vector<Arc> pieces_;
  long budget_ = 0;
  std::vector<Crossing> found_;
  std::vector<std::pair<double, double>> positions_;
};

}  // namespace

Crossings self_intersections(const Curve& curve) { return Search(curve).run(); }

}  // namespace kappabench
