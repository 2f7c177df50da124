// What a curve claims is checked by Scheme::fit, whoever made it: here curves that lie, and curves that do not.
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

/// Says that it converged, whatever curve it was given.
class Says final : public Scheme {
 public:
  explicit Says(Curve curve)
      : Scheme({.id = "says",
                .title = "",
                .citation = "",
                .traits = {.fewest_open_points = 2, .similarity_invariant = false}},
               Parameters::parse({}, "")),
        curve_(std::move(curve)) {}

 private:
  [[nodiscard]] Fit solve(const Input& input) const override {
    return {.input = input, .curve = curve_, .report = {.outcome = Outcome::converged}};
  }
  Curve curve_;
};

SegmentPtr bezier(const std::vector<Vec2>& points) { return std::make_shared<PolynomialSegment>(points); }

/// The curve from (0, 0) through (1, 0) to (2, 0), two segments that meet in the middle.
Curve two(const std::vector<Vec2>& a, const std::vector<Vec2>& b, Continuity claim) {
  return {{bezier(a), bezier(b)}, {{0, claim}}, {{0, 0, 0.0}, {1, 1, 0.0}, {2, 1, 1.0}}, false};
}

const Input three{.points = {{0, 0}, {1, 0}, {2, 0}}};

Report judged(const Curve& curve, const Input& input = three) { return Says(curve).fit(input).report; }

void check_sound(const Curve& curve) {
  const Report report = judged(curve);
  CHECK(report.outcome == Outcome::converged);
  CHECK(report.message.empty());
}

void check_missed(const Curve& curve, std::string_view said, const Input& input = three) {
  const Report report = judged(curve, input);
  CHECK(report.outcome == Outcome::not_converged);
  CHECK_THAT(report.message, ContainsSubstring(std::string(said)));
  CHECK(report.message.find('\n') == std::string::npos);
}

}  // namespace

TEST_CASE("a curve keeps its claim or is not converged", "[soundness]") {
  using enum Continuity;
  // y = x (1 - x) and its mirror image: one tangent, curvatures -1/sqrt 2 and +1/sqrt 2.
  const std::vector<Vec2> hill{{0, 0}, {0.5, 0.5}, {1, 0}}, valley{{1, 0}, {1.5, -0.5}, {2, 0}};
  check_sound(two(hill, valley, g1));
  check_sound(two(hill, valley, c1));
  check_sound(two(hill, valley, g1_equal_magnitude));
  check_missed(two(hill, valley, g2), "claims G2, but the curvature times the mean chord jumps from -0.707");
  check_missed(two(hill, valley, c2), "the second derivative jumps by 4 mean chords");
  const std::vector<Vec2> other_hill{{1, 0}, {1.5, 0.5}, {2, 0}};
  check_sound(two(hill, other_hill, g0));
  check_missed(two(hill, other_hill, g1), "the direction turns from -0.785398163 to 0.785398163 rad");
  const std::vector<Vec2> faster{{1, 0}, {1.6, -0.6}, {2, 0}};
  check_sound(two(hill, faster, g1));
  check_missed(two(hill, faster, c1), "the first derivative jumps");
  const Curve gap({bezier(hill), bezier({{1, 1e-9}, {1.5, -0.5}, {2, 0}})}, {{0, g0}},
                  {{0, 0, 0.0}, {1, 0, 1.0}, {2, 1, 1.0}}, false);
  check_missed(gap, "its sides are apart by 1e-09 mean chords");
}

TEST_CASE("a turn of pi is no smooth joint", "[soundness]") {
  const Input back{.points = {{0, 0}, {1, 0}, {0.5, 0}}};
  const auto retraced = [](Continuity claim) {
    return Curve({bezier({{0, 0}, {1, 0}}), bezier({{1, 0}, {0.5, 0}})}, {{0, claim}},
                 {{0, 0, 0.0}, {1, 1, 0.0}, {2, 1, 1.0}}, false);
  };
  CHECK(judged(retraced(Continuity::g0), back).outcome == Outcome::converged);
  check_missed(retraced(Continuity::g1), "by 3.14", back);
  check_missed(retraced(Continuity::g2), "by 3.14", back);
}

TEST_CASE("a segment that rests at the joint has the tangent of its next derivative", "[soundness]") {
  check_sound(two({{0, 0}, {1, 0}, {1, 0}}, {{1, 0}, {1, 0}, {2, 0}}, Continuity::g1));
  check_missed(two({{0, 0}, {1, 0}, {1, 0}}, {{1, 0}, {1, 0}, {2, 0}}, Continuity::g2), "the curvature");
  check_missed(two({{0, 0}, {1, 0}, {1, 0}}, {{1, 0}, {1, 0}, {1, 1}, {2, 0}}, Continuity::g1), "the direction");
}

TEST_CASE("points are met at nodes, each at one", "[soundness]") {
  const SegmentPtr line = bezier({{0, 0}, {2, 0}});
  const auto with = [&](std::vector<Node> nodes) { return Curve({line}, {}, std::move(nodes), false); };
  check_sound(with({{0, 0, 0.0}, {1, 0, 0.5}, {2, 0, 1.0}}));
  check_missed(with({{0, 0, 0.0}, {2, 0, 1.0}}), "no node at point 1");
  check_missed(with({{0, 0, 0.0}, {1, 0, 0.5 + 1e-9}, {2, 0, 1.0}}), "passes point 1 at 2e-09 mean chords");
  check_missed(with({{0, 0, 0.0}, {1, 0, 0.5}, {2, 0, 1.0}, {3, 0, 1.0}}), "names point 3; the points are 0 to 2");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check_missed(Curve({bezier({{0, 0}, {1, nan}, {2, 0}})}, {}, {{0, 0, 0.0}, {1, 0, 0.5}, {2, 0, 1.0}}, false),
               "segment 0 is not finite");
  check_missed(with({{0, 0, 0.0}, {1, 0, 0.5}, {2, 0, 1.0}}), "the curve is open, the input closed",
               {.points = three.points, .closed = true});
}

TEST_CASE("what rounding explains depends on where the drawing lies, and ends at what can be seen", "[soundness]") {
  // Two parabolas whose curvatures at the joint differ by `jump`, in relation to 0.707.
  const auto judged_at = [](double offset, double jump) {
    std::vector<Vec2> a{{0, 0}, {0.5, -0.5}, {1, 0}}, b{{1, 0}, {1.5, 0.5}, {2, 2 + jump}};
    for (std::vector<Vec2>* points : {&a, &b})
      for (Vec2& p : *points) p += Vec2(offset, offset);
    const Report report = judged(two(a, b, Continuity::g2), {.points = {a[0], b[0], b[2]}});
    UNSCOPED_INFO(report.message);
    return report.outcome;
  };
  CHECK(judged_at(0.0, 0.0) == Outcome::converged);
  CHECK(judged_at(0.0, 1e-10) == Outcome::not_converged);
  CHECK(judged_at(1e6, 1e-9) == Outcome::converged);
  CHECK(judged_at(1e6, 1e-6) == Outcome::not_converged);
  CHECK(judged_at(1e9, 1e-6) == Outcome::converged);
  CHECK(judged_at(1e15, 0.25) == Outcome::not_converged);  // rounding would explain it
}

TEST_CASE("wild spans are told, tame ones are not", "[soundness]") {
  const auto of_span = [](const std::vector<Vec2>& points) {
    const Report report = judged(Curve({bezier(points)}, {}, {{0, 0, 0.0}, {1, 0, 1.0}}, false),
                                 {.points = {points.front(), points.back()}});
    CHECK(report.outcome == Outcome::converged);
    CHECK(report.message.empty() == report.warnings.empty());
    return report.warnings;
  };
  using Warnings = std::map<std::string, long>;
  CHECK(of_span({{0, 0}, {1, 1}, {2, -1}, {3, 0}}) == Warnings{});
  CHECK(of_span({{0, 0}, {-1, 1}, {2, 1}, {1, 0}}) == Warnings{});  // a round arch
  CHECK(of_span({{0, 0}, {0, 5}, {1, 5}, {1, 0}}) == Warnings{{"long_span", 1}});
  CHECK(of_span({{0, 0}, {4, 2}, {-3, 2}, {1, 0}}) == Warnings{{"self_crossing_span", 1}, {"long_span", 1}});
  // Two loops of 2 pi in one span, as a clothoid spiral would do: two segments that meet at no point.
  const Curve loops({bezier({{0, 0}, {4, 2}, {-3, 2}, {1, 0}}), bezier({{1, 0}, {5, -2}, {-2, -2}, {2, 0}})},
                    {{0, Continuity::g0}}, {{0, 0, 0.0}, {1, 1, 1.0}}, false);
  CHECK(judged(loops, {.points = {{0, 0}, {2, 0}}}).warnings.contains("winding_span"));
  // The loop that a user put at a point lies between two nodes of that point.
  const Curve loop({bezier({{0, 0}, {0.3, 0}, {0.7, 0}, {1, 0}}), bezier({{1, 0}, {2, 0}, {0, 2}, {1, 0}}),
                    bezier({{1, 0}, {1.3, 0}, {1.7, 0}, {2, 0}})},
                   {{0, Continuity::g0}, {1, Continuity::g0}}, {{0, 0, 0.0}, {1, 0, 1.0}, {1, 2, 0.0}, {2, 2, 1.0}},
                   false);
  CHECK(judged(loop).warnings.empty());
}
