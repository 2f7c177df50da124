#include "experiments/papers/fpc-2019-chen/feature_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <variant>

#include "metrics/self_intersection.hpp"
#include "schemes/curve/exact_curvature.hpp"
#include "schemes/curve/exact_form.hpp"
#include "schemes/fpc/marks.hpp"

namespace kappabench::chen {
namespace {

constexpr double at_point = 1e-6;  // of the mean chord

using Integer = boost::multiprecision::cpp_int;
using Integers = std::array<Integer, 2>;

/// The control points as integers, all over the same power of two: doubles are binary fractions, so this is exact.
std::array<Integers, 4> integer_points(const std::vector<Vec2>& control_points) {
  int least = std::numeric_limits<int>::max();
  for (const Vec2& q : control_points)
    for (const double v : q)
      if (v != 0.0) least = std::min(least, std::ilogb(v) - 52);
  std::array<Integers, 4> points;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t c = 0; c < 2; ++c)
      if (const double v = control_points[i][static_cast<Eigen::Index>(c)]; v != 0.0) {
        const int exponent = std::ilogb(v) - 52;
        points[i][c] = static_cast<long long>(std::ldexp(v, -exponent));
        points[i][c] <<= exponent - least;
      }
  return points;
}

/// Whether a cubic has a loop: B^2 - 4AC < 0 for the quadratic numerator of its curvature (Chen 2019, Sect. 3.1), in
/// integers, for its control points as they are.
bool loops_exactly(const Segment& segment) {
  const ExactForm form = segment.exact();
  const auto* polynomial = std::get_if<PolynomialForm>(&form);
  if (polynomial == nullptr || polynomial->control_points.size() != 4) return false;
  const std::array<Integers, 4> q = integer_points(polynomial->control_points);
  const auto combine = [&](int a, int b, int c, int d) {
    Integers sum;
    for (std::size_t k = 0; k < 2; ++k) sum[k] = a * q[0][k] + b * q[1][k] + c * q[2][k] + d * q[3][k];
    return sum;
  };
  const Integers p1 = combine(-3, 3, 0, 0), p2 = combine(3, -6, 3, 0), p3 = combine(-1, 3, -3, 1);
  const auto det = [](const Integers& u, const Integers& v) { return Integer(u[0] * v[1] - u[1] * v[0]); };
  const Integer a = 3 * det(p2, p3), b = 3 * det(p1, p3), c = det(p1, p2);
  return b * b < 4 * a * c;
}

class Checker {
 public:
  explicit Checker(const Fit& fit) : fit_(fit), close_(at_point * mean_chord(fit.input)) {
    found_.resize(fit.input.points.size());
  }

  FeatureCheck run() {
    for (int k = 0; k < fit_.curve->size(); ++k) check_segment(k);
    for (int i = 0; i < fit_.input.size(); ++i) {
      const PointType type = fit_.input.options_of(i).type.value_or(PointType::regular);
      if (type == PointType::regular) continue;
      ++check_.typed;
      if (found_[static_cast<std::size_t>(i)]) continue;
      if (type == PointType::loop && passed_twice(i)) {
        ++check_.thin_loops;
        continue;
      }
      ++check_.missing;
      note(fmt::format("point {} is no {}", i, name(type)));
    }
    return check_;
  }

 private:
  void note(std::string what) {
    if (check_.first.empty()) check_.first = std::move(what);
  }

  /// The point of this type on segment k at the place; notes that its feature is there. False if there is none.
  bool claim(int k, const Vec2& place, PointType type) {
    for (const Node& node : fit_.curve->nodes()) {
      if (node.segment != k || node.has(fpc::marks::at_inflection) || fit_.input.options_of(node.point).type != type)
        continue;
      const auto point = static_cast<std::size_t>(node.point);
      if ((fit_.input.points[point] - place).norm() > close_) continue;
      found_[point] = true;
      return true;
    }
    return false;
  }

  /// The loop point's two nodes, if they are where they should be and the segment's cubic has a loop.
  [[nodiscard]] bool passed_twice(int point) const {
    const auto is_there = [&](const Node& node) {
      const Segment& segment = fit_.curve->segment(node.segment);
      const Vec2& at = fit_.input.points[static_cast<std::size_t>(point)];
      return node.point == point && (segment.jet(node.t, 0).position() - at).norm() <= close_ && loops_exactly(segment);
    };
    return std::ranges::count_if(fit_.curve->nodes(), is_there) == 2;
  }

  /// Whether t lies between the two passes of a loop point of segment k.
  [[nodiscard]] bool inside_loop(int k, double t) const {
    const auto side = [&](bool before) {
      return std::ranges::any_of(fit_.curve->nodes(), [&](const Node& node) {
        return node.segment == k && fit_.input.options_of(node.point).type == PointType::loop &&
               (before ? node.t < t : node.t > t);
      });
    };
    return side(true) && side(false);
  }

  void check_segment(int k) {
    const SegmentPtr& segment = fit_.curve->segments()[static_cast<std::size_t>(k)];
    const auto at = [&](double t) { return segment->jet(t, 0).position(); };
    std::vector<Vec2> reversals;
    for (const double t : cusps(*segment)) {
      if (inside_loop(k, t) && loops_exactly(*segment)) continue;  // its tip
      reversals.push_back(at(t));
      ++check_.cusps;
      if (claim(k, at(t), PointType::cusp)) continue;
      ++check_.misplaced_cusps;
      note(fmt::format("segment {} has a cusp at t = {:.6g}", k, t));
    }
    std::vector<double> changes;
    for (const RootBracket& bracket : inflections(*segment).at) changes.push_back(bracket.mid());
    // Rounding of the control points opens the double root at a cusp into a pair of sign changes, or a tiny loop.
    const auto at_cusp = [&](const Vec2& place) {
      return std::ranges::any_of(reversals, [&](const Vec2& p) { return (p - place).norm() <= close_; });
    };
    std::erase_if(changes, [&](double t) { return at_cusp(at(t)); });
    for (const double t : changes) {
      ++check_.inflections;
      if (claim(k, at(t), PointType::inflection)) continue;
      ++check_.misplaced_inflections;
      note(fmt::format("segment {} has an inflection at t = {:.6g}", k, t));
    }
    const Crossings crossings = self_intersections(Curve({segment}, {}, {}, false));
    if (!crossings.complete) {
      ++check_.uncertified;
      note(fmt::format("segment {}: crossings not all found", k));
    }
    for (const Crossing& crossing : crossings.found) {
      if (at_cusp(crossing.position)) continue;
      ++check_.loops;
      if (claim(k, crossing.position, PointType::loop)) continue;
      ++check_.misplaced_loops;
      note(fmt::format("segment {} crosses itself at t = {:.6g} and {:.6g}", k, crossing.first.t, crossing.second.t));
    }
  }

  const Fit& fit_;
  double close_;
  FeatureCheck check_;
  std::vector<bool> found_;
};

}  // namespace

FeatureCheck check_features(const Fit& fit) { return Checker(fit).run(); }

}  // namespace kappabench::chen
