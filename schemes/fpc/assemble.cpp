#include "schemes/fpc/assemble.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "schemes/fpc/marks.hpp"
#include "schemes/segments/joint_claim.hpp"
#include "schemes/segments/open_curve.hpp"
#include "schemes/segments/polynomial.hpp"

namespace kappabench::fpc {
namespace {

/// A segment whose joints are both this near to its point, over the point's size, has shrunk to the point.
constexpr double shrunk = 1e-11;
/// Below this share of |X||Y| an area is rounding and its sign means nothing.
constexpr double straight = 1e-14;

/// One segment that is really there.
struct Piece {
  std::size_t number;        ///< in the chain
  int start_sign, end_sign;  ///< of the curvature at its ends, 0 if it is straight
};

Piece piece_of(const CubicChain& chain, const State& state, std::size_t k) {
  const Vec2 &x = state.x[k], &y = state.y[k];
  const double area = cross(x, y);
  if (std::abs(area) <= straight * x.norm() * y.norm()) return {k, 0, 0};
  const int turn = area > 0.0 ? 1 : -1;
  return {k, chain.cubic[k].start_numerator > 0.0 ? turn : -turn, chain.cubic[k].end_numerator > 0.0 ? turn : -turn};
}

class Assembly {
 public:
  Assembly(const Input& input, const CubicChain& chain, const State& state)
      : input_(input), chain_(chain), state_(state), gone_(chain.segments(), false) {
    const std::size_t m = chain.segments();
    for (std::size_t k = 0; k < m && m > 1; ++k)
      gone_[k] = std::max(state.x[k].norm(), state.y[k].norm()) < shrunk * chain.size[k];
  }

  Assembled run() {
    counters_ = {{"s_joints", 0}, {std::string(marks::at_inflection), 0}};
    for (std::size_t k = 0; k < chain_.segments(); ++k) {
      if (gone_[k]) {
        // The node is the end of the segment before; of a closed curve's very first one, the start of the next.
        const int before = static_cast<int>(segments_.size()) - 1;
        nodes_.push_back({.point = point_of(k),
                          .segment = std::max(before, 0),
                          .t = before < 0 ? 0.0 : 1.0,
                          .marks = {std::string(marks::at_inflection)}});
        ++counters_[nodes_.back().marks.front()];
      } else {
        add_segment(k);
      }
    }
    add_joints();
    if (!input_.closed) add_end_nodes(nodes_, input_.size(), static_cast<int>(segments_.size()));
    return {Curve(std::move(segments_), std::move(joints_), std::move(nodes_), input_.closed), std::move(counters_)};
  }

 private:
  [[nodiscard]] int point_of(std::size_t k) const { return static_cast<int>(k) + (input_.closed ? 0 : 1); }
  [[nodiscard]] const Vec2& position(std::size_t k) const {
    return input_.points[static_cast<std::size_t>(point_of(k))];
  }

  /// The end of segment k, from the nearer point; a segment that has shrunk gives its point.
  [[nodiscard]] Vec2 joint(std::size_t k) const {
    if (k + 1 == chain_.segments() && !chain_.closed) return input_.points.back();
    const std::size_t next = chain_.next(k);
    if (gone_[k]) return position(k);
    if (gone_[next]) return position(next);
    const Vec2 &y = state_.y[k], &x = state_.x[next];
    return y.squaredNorm() < x.squaredNorm() ? Vec2(position(k) + chain_.unit * y)
                                             : Vec2(position(next) + chain_.unit * x);
  }

  void add_segment(std::size_t k) {
    const LocalCubic& cubic = chain_.cubic[k];
    const Vec2 &x = state_.x[k], &y = state_.y[k];
    const Vec2 start = k == 0 && !chain_.closed ? input_.points.front() : joint(chain_.before(k));
    const Vec2 end = joint(k);
    const Vec2 leave = chain_.unit / 3.0 * cubic.start_velocity(x, y);
    const Vec2 arrive = chain_.unit / 3.0 * cubic.end_velocity(x, y);
    const int number = static_cast<int>(segments_.size());
    segments_.push_back(
        std::make_shared<const PolynomialSegment>(std::array<Vec2, 4>{start, start + leave, end - arrive, end}));
    pieces_.push_back(piece_of(chain_, state_, k));
    if (cubic.task.type == PointType::loop) {
      nodes_.push_back({.point = point_of(k), .segment = number, .t = cubic.task.t1});
      nodes_.push_back({.point = point_of(k), .segment = number, .t = cubic.task.t2});
    } else {
      nodes_.push_back({.point = point_of(k), .segment = number, .t = cubic.task.t});
    }
  }

  void add_joints() {
    const std::size_t count = pieces_.size(), met = input_.closed ? count : count - 1;
    for (std::size_t j = 0; j < met; ++j) {
      const std::size_t behind = (j + 1) % count;
      const bool s_shaped = pieces_[j].end_sign * pieces_[behind].start_sign < 0;
      const Continuity smooth = s_shaped ? Continuity::g1_equal_magnitude : Continuity::g2;
      counters_["s_joints"] += s_shaped;
      // A segment that has shrunk in between may have turned from one direction and curvature to others.
      const bool adjacent = chain_.next(pieces_[j].number) == pieces_[behind].number;
      joints_.push_back({static_cast<int>(j), adjacent ? claim_at(*segments_[j], *segments_[behind], smooth)
                                                       : claim_found(*segments_[j], *segments_[behind], smooth)});
    }
  }

  const Input& input_;
  const CubicChain& chain_;
  const State& state_;
  std::vector<bool> gone_;
  std::vector<Piece> pieces_;
  std::vector<SegmentPtr> segments_;
  std::vector<Joint> joints_;
  std::vector<Node> nodes_;
  std::map<std::string, long> counters_;
};

}  // namespace

Assembled assemble(const Input& input, const CubicChain& chain, const State& state) {
  return Assembly(input, chain, state).run();
}

}  // namespace kappabench::fpc
