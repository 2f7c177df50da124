// Drawings far out, huge or tiny are computed in a frame of their own.
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "schemes/api/frame.hpp"
#include "schemes/segments/blend.hpp"
#include "schemes/segments/clothoid.hpp"
#include "schemes/segments/elliptic_arc.hpp"
#include "schemes/segments/intrinsic.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/reparametrized.hpp"
#include "schemes/segments/trigonometric.hpp"
#include "tests/catch.hpp"

using namespace kappabench;

namespace {

Input ring(double radius, const Vec2& middle) {
  Input input{.points = {}, .closed = true};
  for (int i = 0; i < 7; ++i) input.points.push_back(middle + radius * Vec2(std::cos(0.9 * i), std::sin(0.9 * i)));
  return input;
}

class Bare final : public Segment {
 public:
  [[nodiscard]] Jet jet(double t, int) const override {
    return {{Vec2(t, t * t), Vec2(1, 2 * t), Vec2(0, 2), Vec2::Zero(), Vec2::Zero()}};
  }
  [[nodiscard]] ExactForm exact() const override { return OpaqueForm{}; }
};

std::vector<SegmentPtr> one_of_each() {
  const auto arc = std::make_shared<EllipticArcSegment>(EllipticArcForm{{1, 2}, {2, 0.3}, {-0.2, 1}, 0.2, 1.9});
  const std::vector<Vec2> points{{0, 0}, {1, 2}, {3, 1}, {4, 3}};
  const auto cubic = std::make_shared<PolynomialSegment>(points);
  return {cubic,
          std::make_shared<TrigonometricSegment>(std::array<Vec2, 5>{{{0, 0}, {1, 2}, {2, 2}, {3, 1}, {3, 0}}}),
          std::make_shared<ClothoidSegment>(ClothoidForm{{1, -1}, 0.4, 0.3, 1.1, 2.0}),
          std::make_shared<IntrinsicSegment>(IntrinsicForm{{1, -1}, 0.4, 2.0, 2, {0, 0, 0.5, 1, 1}, {0.1, 1, -1, 0.5}}),
          arc,
          std::make_shared<ReparametrizedSegment>(arc, 1.7),
          std::make_shared<BlendSegment>(arc, cubic),
          std::make_shared<Bare>()};
}

}  // namespace

TEST_CASE("what is of common size and place is left as it is", "[frame]") {
  CHECK(frame_of(ring(1.0, {0, 0})).is_identity());
  CHECK(frame_of(ring(1e6, {3e6, -3e7})).is_identity());
  CHECK(frame_of(ring(1e-6, {0, 0})).is_identity());
  CHECK(frame_of({}).is_identity());
  CHECK(frame_of({.points = {{1e9, 0}, {1e9, 0}}}).is_identity());
  CHECK(frame_of({.points = {{0, 0}, {std::nan(""), 1}}}).is_identity());
}

TEST_CASE("points go into their frame and back without a bit lost", "[frame]") {
  for (const auto& [radius, middle] : {std::pair{1.0, Vec2(5e6, -3e5)},
                                       {1.0, Vec2(1e9, 0.1)},
                                       {1e-150, Vec2(0, 0)},
                                       {1e150, Vec2(3e150, 1e148)},
                                       {3e-40, Vec2(1e-31, -7e-30)},
                                       {1e-3, Vec2(1.0, 0)}}) {
    INFO(radius << " at " << middle.transpose());
    const Input input = ring(radius, middle);
    const Placement frame = frame_of(input);
    CHECK_FALSE(frame.is_identity());
    const Input local = place(input, frame.inverse());
    CHECK(place(local, frame).points == input.points);
    for (const Vec2& p : local.points) CHECK(p.norm() < 40.0 * (frame.scale == 1.0 ? radius : 1.0));
    CHECK(mean_chord(local) * frame.scale == Approx(mean_chord(input)).epsilon(1e-15));
  }
}

TEST_CASE("a prescribed curvature goes with its drawing", "[frame]") {
  Input input = ring(1e20, {0, 0});
  input.options.resize(input.points.size());
  input.options[2].curvature = 1e-20;
  const Placement frame = frame_of(input);
  CHECK(*place(input, frame.inverse()).options[2].curvature == Approx(1e-20 * frame.scale));
}

TEST_CASE("a placed segment has placed jets, and its exact form says so", "[frame]") {
  const Placement placement{4.0, {100.0, -7.0}};
  for (const SegmentPtr& segment : one_of_each()) {
    const SegmentPtr placed = place(segment, placement);
    INFO("form " << segment->exact().index());
    CHECK(placed->exact().index() == segment->exact().index());
    for (const double t : {0.0, 0.3, 0.7, 1.0}) {
      const Jet before = segment->jet(t, 4), after = placed->jet(t, 4);
      CHECK((after.d[0] - placement(before.d[0])).norm() < 1e-12);
      for (std::size_t k = 1; k <= 4; ++k) CHECK((after.d[k] - 4.0 * before.d[k]).norm() <= 1e-13 * before.d[k].norm());
    }
  }
}
