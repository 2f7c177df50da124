// Local editing changes what it says and nothing else; the whole curve at once knows no order.

#include "schemes/pkappa/pkappa.hpp"
#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"
#include "tests/unit/schemes/kappa_inputs.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

Input wave(int n, bool closed) {
  Input input{.points = {}, .closed = closed, .options = {}, .ids = {}};
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    if (closed)
      input.points.push_back((1.0 + 0.3 * std::sin(3.0 * angle)) * Vec2(std::cos(angle), std::sin(angle)));
    else
      input.points.emplace_back(i + 0.2 * std::sin(5.0 * i), std::sin(1.3 * i));
  }
  return input;
}

bool same(const Segment& a, const Segment& b) {
  const auto p = dynamic_cast<const PolynomialSegment&>(a).control_points();
  const auto q = dynamic_cast<const PolynomialSegment&>(b).control_points();
  return std::equal(p.begin(), p.end(), q.begin(), q.end());
}

/// The segments that differ, bit for bit, as indices of `after`; both curves have as many segments.
std::vector<int> changed(const Curve& before, const Curve& after) {
  REQUIRE(before.size() == after.size());
  std::vector<int> list;
  for (int i = 0; i < after.size(); ++i)
    if (!same(before.segment(i), after.segment(i))) list.push_back(i);
  return list;
}

void check_interpolation(const Fit& fit) {
  REQUIRE(fit.report.outcome == Outcome::converged);
  CHECK(fit.report.residual <= 1e-10);
  CHECK(fit.curve->nodes().size() == fit.input.points.size());
}

SchemePtr pkappa(const std::string& options) { return scheme("pkappa:" + options); }

}  // namespace

TEST_CASE("pkappa: a move changes three segments, two near an open end, and no other bit") {
  for (const std::string continuity : {"c1", "g1", "c2", "g2"}) {
    INFO(continuity);
    const SchemePtr scheme = pkappa("continuity=" + continuity);
    const Fit open = scheme->fit(wave(9, false));
    check_interpolation(open);
    const auto move = [](const Fit& fit, int point) {
      return Edit{Move{point, fit.input.points[static_cast<std::size_t>(point)] + Vec2(0.05, -0.08)}};
    };
    const std::vector<std::vector<int>> expected{{0, 1},    {0, 1},    {0, 1, 2}, {1, 2, 3}, {2, 3, 4},
                                                 {3, 4, 5}, {4, 5, 6}, {5, 6},    {5, 6}};
    for (int point = 0; point < 9; ++point) {
      const Fit moved = scheme->refit(open, move(open, point));
      check_interpolation(moved);
      CHECK(changed(*open.curve, *moved.curve) == expected[static_cast<std::size_t>(point)]);
    }
    const Fit ring = scheme->fit(wave(8, true));
    check_interpolation(ring);
    CHECK(changed(*ring.curve, *scheme->refit(ring, move(ring, 4)).curve) == std::vector<int>{3, 4, 5});
    CHECK(changed(*ring.curve, *scheme->refit(ring, move(ring, 0)).curve) == std::vector<int>{0, 1, 7});
  }
}

TEST_CASE("pkappa: an insertion or an erasure leaves the segments far from it") {
  for (const std::string continuity : {"c1", "g1", "c2", "g2"})
    for (const bool closed : {false, true}) {
      INFO(continuity << (closed ? ", closed" : ", open"));
      const SchemePtr scheme = pkappa("continuity=" + continuity);
      const Fit before = scheme->fit(wave(10, closed));
      const int last = before.input.size();
      for (int at = 0; at <= last; ++at) {
        const Input& input = before.input;
        const auto point = [&](int i) { return input.points[static_cast<std::size_t>((i + last) % last)]; };
        Vec2 added = 0.5 * (point(at - 1) + point(at));
        if (!closed && at == 0) added = 2.0 * point(0) - point(1);
        if (!closed && at == last) added = 2.0 * point(last - 1) - point(last - 2);
        INFO("before " << at);
        const Fit after = scheme->refit(before, Insert{.before = at, .at = added});
        check_interpolation(after);
        int kept = 0;
        for (int i = 0; i < before.curve->size(); ++i)
          for (int j : {i, i + 1})
            if (j < after.curve->size() && same(before.curve->segment(i), after.curve->segment(j))) {
              ++kept;
              break;
            }
        CHECK(kept >= before.curve->size() - 2);
      }
      for (int gone = 0; gone < last; ++gone) {
        INFO("without " << gone);
        const Fit after = scheme->refit(before, Erase{gone});
        check_interpolation(after);
        int kept = 0;
        for (int i = 0; i < after.curve->size(); ++i)
          for (int j : {i, i + 1})
            if (j < before.curve->size() && same(after.curve->segment(i), before.curve->segment(j))) {
              ++kept;
              break;
            }
        CHECK(kept >= before.curve->size() - 5);
      }
    }
}

TEST_CASE("pkappa: the whole curve at once is the same backwards, local construction is not") {
  Input input = wave(9, false);
  Input reversed = input;
  std::reverse(reversed.points.begin(), reversed.points.end());
  const auto difference = [&](const SchemePtr& scheme) {
    const Fit a = scheme->fit(input), b = scheme->fit(reversed);
    check_interpolation(a);
    check_interpolation(b);
    double largest = 0.0;
    for (int i = 0; i < a.curve->size(); ++i)
      for (const double t : {0.0, 0.3, 0.7, 1.0})
        largest = std::max(largest, (a.curve->segment(i).jet(t, 0).position() -
                                     b.curve->segment(a.curve->size() - 1 - i).jet(1.0 - t, 0).position())
                                        .norm());
    return largest / mean_chord(input);
  };
  for (const std::string continuity : {"c1", "g1", "c2"}) {
    INFO(continuity);
    CHECK(difference(pkappa("mode=global,continuity=" + continuity)) < 1e-3);
  }
  CHECK(difference(pkappa("mode=local")) > 1e-3);
}

TEST_CASE("pkappa: three points, straight lines and right angles") {
  for (const std::string mode : {"local", "global"})
    for (const std::string continuity : {"c1", "g1", "c2", "g2"}) {
      INFO(mode << " " << continuity);
      const SchemePtr scheme = pkappa("mode=" + mode + ",continuity=" + continuity);
      for (const Input& input :
           {Input{{{0, 0}, {1, 1}, {2, 0}}, false, {}, {}}, Input{{{0, 0}, {1, 1}, {2, 0}}, true, {}, {}},
            Input{{{0, 0}, {1, 0}, {2, 0}, {3.5, 0}}, false, {}, {}},
            Input{{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}}, false, {}, {}},
            Input{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true, {}, {}}}) {
        const Fit fit = scheme->fit(input);
        check_interpolation(fit);
      }
    }
}

TEST_CASE("pkappa: every optimiser finds the minimum of a window that has one") {
  const Input input{{{0, 0}, {1, 1}, {2.2, 0.1}}, false, {}, {}};
  const Fit own = pkappa("solver=lm")->fit(input);
  check_interpolation(own);
  for (const ParameterSpec& spec : own.curve ? pkappa("")->info().parameters : std::vector<ParameterSpec>{}) {
    if (spec.name != "solver") continue;
    for (const std::string& solver : spec.choices) {
      INFO(solver);
      const Fit other = pkappa("solver=" + solver)->fit(input);
      check_interpolation(other);
      for (int i = 0; i < own.curve->size(); ++i)
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
          CHECK((own.curve->segment(i).jet(t, 0).position() - other.curve->segment(i).jet(t, 0).position()).norm() <
                1e-3);
    }
  }
}

TEST_CASE("pkappa: the other optimisers are for windows") {
  CHECK_THROWS_WITH(pkappa("mode=global,solver=ceres"), ContainsSubstring("mode=local"));
}
