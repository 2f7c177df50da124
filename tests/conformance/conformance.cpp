// What every scheme must do, whatever it is: run over all schemes and all built-in drawings, so that a new scheme is
// checked without a line of test code.
#include <algorithm>
#include <cmath>
#include <random>

#include "datasets/datasets.hpp"
#include "datasets/random_points.hpp"
#include "tests/catch.hpp"
#include "tests/sanitized.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

/// Points of the longest curves to look at.
constexpr std::size_t most_points = sanitized ? 12 : 100000;

/// Calls `check` for every scheme at its defaults and every curve of the built-in drawings.
template <class Check>
void for_all_fits(Check check) {
  const std::vector<Drawing> drawings = builtin_drawings();
  REQUIRE(drawings.size() >= 12);
  for (const SchemeInfo& info : all_schemes().list()) {
    const SchemePtr scheme = all_schemes().create(info.id);
    for (const Drawing& drawing : drawings)
      for (std::size_t i = 0; i < drawing.curves.size(); ++i) {
        if (drawing.curves[i].points.size() > most_points) continue;
        INFO(info.id << " on " << drawing.id << ", curve " << i);
        check(info, scheme->fit(drawing.curves[i]));
      }
  }
}

bool same_curves(const Curve& a, const Curve& b) {
  if (a.size() != b.size()) return false;
  for (int k = 0; k < a.size(); ++k)
    for (const double t : {0.0, 0.3, 1.0})
      if (a.segment(k).jet(t, 0).position() != b.segment(k).jet(t, 0).position()) return false;
  return true;
}

/// The angle that rounding may turn a tangent by: one unit in the last place of the drawing's coordinates, seen over
/// the shorter of the two legs at a joint (a segment may have shrunk to almost nothing there).
double tangent_rounding(const Input& input, const Jet& before, const Jet& after) {
  double extent = 0.0;
  for (const Vec2& p : input.points) extent = std::max(extent, p.cwiseAbs().maxCoeff());
  return 16.0 * 0x1p-52 * extent / std::min(speed(before), speed(after));
}

/// Largest distance between corresponding points of two curves that have the same segments.
double distance(const Curve& a, const Curve& b) {
  double largest = 0.0;
  for (int k = 0; k < a.size(); ++k)
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
      largest = std::max(largest, (a.segment(k).jet(t, 0).position() - b.segment(k).jet(t, 0).position()).norm());
  return largest;
}

/// A fit either has a curve that is finite everywhere, or says why there is none.
void check_outcome(const Fit& fit) {
  if (fit.report.outcome == Outcome::converged) REQUIRE(fit.curve.has_value());
  if (fit.report.outcome != Outcome::converged) CHECK_FALSE(fit.report.message.empty());
  CHECK(fit.report.message.find('\n') == std::string::npos);
  if (!fit.curve) return;
  for (const Jet& jet : sample(*fit.curve, 9, max_jet_order).jets)
    for (const Vec2& d : jet.d) REQUIRE(d.allFinite());
}

/// A converged curve passes through every point, at a node, to 1e-10 chords.
void check_interpolation(const Fit& fit) {
  if (fit.report.outcome != Outcome::converged) return;
  const double chord = mean_chord(fit.input);
  std::vector<bool> reached(fit.input.points.size(), false);
  for (const Node& node : fit.curve->nodes()) {
    const auto point = static_cast<std::size_t>(node.point);
    const Vec2 at = fit.curve->segment(node.segment).jet(node.t, 0).position();
    CHECK((at - fit.input.points[point]).norm() <= 1e-10 * chord);
    reached[point] = true;
  }
  CHECK(std::ranges::all_of(reached, [](bool r) { return r; }));
}

/// Segments follow one another without a gap, with the tangents that their joints claim.
void check_joints(const Fit& fit) {
  if (fit.report.outcome != Outcome::converged) return;
  const Curve& curve = *fit.curve;
  const double chord = mean_chord(fit.input);
  CHECK(curve.closed() == fit.input.closed);
  for (const Joint& joint : curve.joints()) {
    const Jet before = curve.segment(joint.segment).jet(1.0, 2);
    const Jet after = curve.segment(curve.next(joint.segment)).jet(0.0, 2);
    CHECK((before.position() - after.position()).norm() <= 1e-10 * chord);
    if (joint.claimed == Continuity::g0) continue;
    const double turn = std::atan2(cross(before.d[1], after.d[1]), before.d[1].dot(after.d[1]));
    CHECK(std::abs(turn) <= 1e-7 + tangent_rounding(fit.input, before, after));
  }
}

/// Nodes have marks that the scheme lists, and a counter named as a mark counts them.
void check_marks(const SchemeInfo& info, const Fit& fit) {
  if (!fit.curve) return;
  for (const Node& node : fit.curve->nodes())
    for (const std::string& mark : node.marks)
      CHECK(std::ranges::find(info.marks, mark, &MarkSpec::name) != info.marks.end());
  for (const MarkSpec& mark : info.marks) {
    const auto counter = fit.report.counters.find(mark.name);
    if (counter == fit.report.counters.end()) continue;
    CHECK(counter->second ==
          std::ranges::count_if(fit.curve->nodes(), [&](const Node& n) { return n.has(mark.name); }));
  }
}

}  // namespace

TEST_CASE("every fit has a sound outcome, passes its points and is as continuous as it claims") {
  for_all_fits([](const SchemeInfo& info, const Fit& fit) {
    check_outcome(fit);
    check_interpolation(fit);
    check_joints(fit);
    check_marks(info, fit);
  });
}

TEST_CASE("the same input gives the same curve, bit for bit") {
  for (const SchemeInfo& info : all_schemes().list())
    for (const RandomKind kind : random_kinds()) {
      INFO(info.id << " on " << name(kind));
      const SchemePtr scheme = all_schemes().create(info.id);
      const Input input = random_input(kind, 17, 5, true);
      const Fit first = scheme->fit(input), second = scheme->fit(input);
      REQUIRE(first.curve.has_value() == second.curve.has_value());
      CHECK(first.report.iterations == second.report.iterations);
      if (first.curve) CHECK(same_curves(*first.curve, *second.curve));
    }
}

TEST_CASE("a similar drawing gives the similar curve, where the scheme claims so") {
  const double angle = 0.7, scale = 1e3;
  const Eigen::Matrix2d turn{{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}};
  for (const SchemeInfo& info : all_schemes().list()) {
    if (!info.traits.similarity_invariant) continue;
    const SchemePtr scheme = all_schemes().create(info.id);
    for (const bool closed : {false, true}) {
      INFO(info.id << (closed ? ", closed" : ", open"));
      const Input input = random_input(RandomKind::star, 12, 3, closed);
      Input moved = input;
      for (Vec2& p : moved.points) p = scale * (turn * p) + Vec2(40.0, -7.0);
      const Fit original = scheme->fit(input), similar = scheme->fit(moved);
      REQUIRE(original.report.outcome == Outcome::converged);
      REQUIRE(similar.report.outcome == Outcome::converged);
      REQUIRE(original.curve->size() == similar.curve->size());
      for (int k = 0; k < original.curve->size(); ++k)
        for (const double t : {0.0, 0.4, 1.0}) {
          const Vec2 expected = scale * (turn * original.curve->segment(k).jet(t, 0).position()) + Vec2(40.0, -7.0);
          CHECK((similar.curve->segment(k).jet(t, 0).position() - expected).norm() <= 1e-9 * scale);
        }
    }
  }
}

TEST_CASE("a refit is the fit of the edited input") {
  const Input input = random_input(RandomKind::star, 10, 9, true);
  for (const SchemeInfo& info : all_schemes().list()) {
    INFO(info.id);
    const SchemePtr scheme = all_schemes().create(info.id);
    const Fit before = scheme->fit(input);
    for (const Edit& edit :
         {Edit{Move{.point = 3, .to = input.points[3] + Vec2(0.05, 0.02)}},
          Edit{Insert{.before = 1, .at = 0.5 * (input.points[0] + input.points[1])}}, Edit{Erase{.point = 7}}}) {
      const Fit warm = scheme->refit(before, edit), cold = scheme->fit(apply(input, edit));
      if (!info.traits.refit_is_fit) continue;
      REQUIRE(warm.report.outcome == cold.report.outcome);
      if (warm.curve && warm.curve->size() == cold.curve->size()) CHECK(distance(*warm.curve, *cold.curve) <= 1e-9);
    }
  }
}
