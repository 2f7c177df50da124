// The equations, their derivatives, and that they get solved.

#include <cstdlib>

#include "schemes/curve/exact_curvature.hpp"
#include "schemes/fpc/published_iteration.hpp"
#include "schemes/fpc/windows.hpp"
#include "tests/catch.hpp"
#include "tests/unit/schemes/fpc_inputs.hpp"

using namespace kappabench;
using namespace kappabench::fpc;
using namespace kappabench::test;

namespace {

/// A state anywhere, not a solution.
State some_state(const CubicChain& chain, std::uint64_t seed) {
  Random random(seed);
  State state;
  REQUIRE(System(chain).solve_joints(std::vector<double>(chain.joints(), 0.3), state));
  System(chain).solve_weights(state);
  for (std::size_t k = 0; k < chain.joints(); ++k)
    state.shift(chain, k, 0.1 * chain.size[k] * Vec2(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)));
  for (double& w : state.log_weight) w += random.uniform(-0.5, 0.5);
  return state;
}

/// What the equations say at each segment: both parts of the gap, and the weight gap.
std::vector<Right3> equations(const System& system, const State& state, double softness) {
  Values values;
  system.evaluate(state, softness, values);
  std::vector<Right3> all(values.segment.size(), Right3::Zero());
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k < system.chain().joints()) all[k].head<2>() = values.segment[k].gap;
    all[k](2) = values.segment[k].weight_gap;
  }
  return all;
}

/// Largest relative jump of |curvature| at a joint and largest angle there, as the curve's own derivatives have them.
struct Mismatch {
  double curvature = 0.0, angle = 0.0;
};

Mismatch mismatch_of(const Curve& curve) {
  Mismatch worst;
  for (const Joint& joint : curve.joints()) {
    const Jet before = curve.segment(joint.segment).jet(1.0, 2);
    const Jet behind = curve.segment(curve.next(joint.segment)).jet(0.0, 2);
    const double k0 = curvature(before), k1 = curvature(behind);
    const double jump = std::abs(std::abs(k0) - std::abs(k1)) / std::max(std::abs(k0), std::abs(k1));
    worst.curvature = std::max(worst.curvature, jump);
    worst.angle =
        std::max(worst.angle, std::abs(std::atan2(cross(before.d[1], behind.d[1]), before.d[1].dot(behind.d[1]))));
    CHECK((joint.claimed == Continuity::g2) == (k0 * k1 > 0.0));
    CHECK((joint.claimed == Continuity::g1_equal_magnitude) == (k0 * k1 < 0.0));
  }
  return worst;
}

bool near_node(const Fit& fit, int segment, double t, PointType type, double tolerance) {
  return std::ranges::any_of(fit.curve->nodes(), [&](const Node& node) {
    return node.segment == segment && fit.input.options_of(node.point).type == type && std::abs(node.t - t) < tolerance;
  });
}

}  // namespace

TEST_CASE("fpc: Newton's matrix holds the derivatives of the equations") {
  for (const bool closed : {true, false})
    for (std::uint64_t seed = 0; seed < 20; ++seed)
      for (const double softness : {0.0, 0.1}) {
        Input input = random_input(Family::star, seed);
        input.closed = closed;
        input = with_random_types(input, seed);
        const CubicChain chain = chain_of(input);
        const System system(chain);
        const State state = some_state(chain, seed);
        const std::size_t m = chain.segments();
        Values values;
        system.evaluate(state, softness, values);
        Block3 matrix;
        std::vector<Right3> right;
        system.linearise(values, softness, matrix, right);

        Random random(seed);
        std::vector<Right3> way(m);  // joints over their strides
        for (Right3& w : way) w = 1e-5 * Right3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        if (!closed) way.back().head<2>().setZero();
        State there = state, back = state;
        for (std::size_t k = 0; k < m; ++k) {
          if (k < chain.joints()) {
            there.shift(chain, k, values.segment[k].stride * way[k].head<2>());
            back.shift(chain, k, -values.segment[k].stride * way[k].head<2>());
          }
          there.log_weight[k] += way[k](2);
          back.log_weight[k] -= way[k](2);
        }
        const std::vector<Right3> ahead = equations(system, there, softness);
        const std::vector<Right3> behind = equations(system, back, softness);
        for (std::size_t k = 0; k < m; ++k) {
          Right3 predicted = matrix.diagonal[k] * way[k];
          if (k > 0 || closed) predicted += matrix.lower[k] * way[chain.before(k)];
          if (k + 1 < m || closed) predicted += matrix.upper[k] * way[chain.next(k)];
          const double row = k < chain.joints() ? chain.size[k] / values.segment[k].stride : 1.0;
          Right3 seen = 0.5 * (ahead[k] - behind[k]);
          seen.head<2>() *= row;
          const double size = 1e-5 * (matrix.diagonal[k].norm() + matrix.lower[k].norm() + matrix.upper[k].norm());
          CHECK((predicted - seen).norm() < 1e-5 * size);
        }
      }
}

TEST_CASE("fpc: the derivative by softness") {
  const CubicChain chain = chain_of(with_random_types(random_input(Family::star, 3), 3));
  const System system(chain);
  const State state = some_state(chain, 3);
  const double softness = 0.07, step = 1e-5;
  Values values;
  system.evaluate(state, softness, values);
  std::vector<Right3> response;
  system.by_softness(values, softness, response);
  const auto more = equations(system, state, softness * std::exp(step));
  const auto less = equations(system, state, softness * std::exp(-step));
  for (std::size_t k = 0; k < response.size(); ++k)
    CHECK((response[k] + (more[k] - less[k]) / (2.0 * step)).norm() < 1e-8);
}

TEST_CASE("fpc: every pair of neighbouring types") {
  for (const PointType first : all_types)
    for (const PointType second : all_types)
      for (const bool closed : {true, false}) {
        INFO(name(first) << " beside " << name(second) << (closed ? ", closed" : ", open"));
        const PointType rest = PointType::regular;
        Input input{.points = {{0, 0}, {4, -1}, {5.5, 3}, {2, 5}, {-1, 3.2}, {-2, 1}},
                    .closed = closed,
                    .options = {},
                    .ids = {}};
        for (const PointType type : {rest, first, second, second, first, rest}) input.options.push_back({.type = type});
        const Fit result = fit("fpc", input);
        REQUIRE(result.report.outcome == Outcome::converged);
        CHECK(result.report.residual <= 1e-12);
        const Mismatch mismatch = mismatch_of(*result.curve);
        CHECK(mismatch.curvature < 1e-10);
        CHECK(mismatch.angle < 1e-11);
        CHECK(largest_miss(result) < 1e-13);
        for (int k = 0; k < result.curve->size(); ++k) {
          for (const RootBracket& at : inflections(result.curve->segment(k)).at)
            CHECK((near_node(result, k, at.mid(), PointType::inflection, 1e-9) ||
                   near_node(result, k, at.mid(), PointType::cusp, 1e-5)));
          for (const double t : cusps(result.curve->segment(k))) CHECK(near_node(result, k, t, PointType::cusp, 1e-5));
        }
        int loops = 0;
        for (const PointOptions& options : input.options) loops += options.type == PointType::loop;
        CHECK(result.curve->nodes().size() == input.points.size() + static_cast<std::size_t>(loops));
      }
}

TEST_CASE("fpc: random typed inputs of six families are solved") {
  const char* more = std::getenv("KAPPABENCH_FPC_SEEDS");
  const std::uint64_t seeds = more == nullptr ? 60 : std::strtoull(more, nullptr, 10);
  int all = 0, solved = 0;
  for (const Family family : families)
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const Input input = with_random_types(random_input(family, seed), seed);
      const Fit result = fit("fpc", input);
      REQUIRE(result.curve.has_value());
      ++all;
      solved += result.report.outcome == Outcome::converged;
      if (result.report.outcome == Outcome::converged) {
        CHECK(result.report.residual <= 1e-12);
        CHECK(largest_miss(result) <= 1e-10);
      } else {
        CHECK_THAT(result.report.message, ContainsSubstring("not solved"));
      }
    }
  WARN("solved " << solved << " of " << all);
  CHECK(solved >= 0.99 * all);
}

TEST_CASE("fpc: the published iteration arrives at the same curve, with a trace") {
  const Fit published = fit("fpc:iteration=published,max_iterations=200", five_points());
  const Fit newton = fit("fpc", five_points());
  REQUIRE(published.report.outcome == Outcome::converged);
  CHECK(published.report.iterations > 20);
  CHECK(published.report.trace.size() == static_cast<std::size_t>(published.report.iterations) + 1);
  CHECK(published.report.trace.back() <= 1e-12);
  CHECK(newton.report.iterations < 15);
  for (int k = 0; k < 5; ++k)
    CHECK(
        (published.curve->segment(k).jet(0.5, 0).position() - newton.curve->segment(k).jet(0.5, 0).position()).norm() <
        1e-11);
  const Fit short_of = fit("fpc:iteration=published,max_iterations=5", five_points());
  CHECK(short_of.report.outcome == Outcome::not_converged);
  CHECK(short_of.report.iterations == 5);
  CHECK(short_of.curve.has_value());
}

TEST_CASE("fpc: the published iteration and Newton agree on random inputs") {
  const char* more = std::getenv("KAPPABENCH_FPC_SEEDS");
  const std::uint64_t seeds = more == nullptr ? 15 : std::strtoull(more, nullptr, 10);
  int all = 0, solved = 0, early = 0, other = 0;
  for (const Family family : families)
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const Input input = with_random_types(random_input(family, seed), seed);
      const Fit published = fit("fpc:iteration=published,max_iterations=2000", input), newton = fit("fpc", input);
      ++all;
      if (published.report.outcome != Outcome::converged || newton.report.outcome != Outcome::converged) continue;
      ++solved;
      early += published.report.iterations <= 50;
      double apart = 0.0;
      if (published.curve->size() == newton.curve->size())
        for (int k = 0; k < newton.curve->size(); ++k)
          apart = std::max(apart, (published.curve->segment(k).jet(0.0, 0).position() -
                                   newton.curve->segment(k).jet(0.0, 0).position())
                                      .norm());
      other += apart > 1e-6 * mean_chord(input);
    }
  WARN("published iteration: " << solved << " of " << all << ", " << early << " within 50 steps; " << other
                               << " at another curve than Newton");
  CHECK(solved >= 0.9 * all);
  CHECK(other <= 0.01 * all);
}

TEST_CASE("fpc: far from the origin and in other units") {
  const Input near = with_random_types(random_input(Family::star, 8), 8);
  Input far = near;
  for (Vec2& p : far.points) p = 1e-3 * p + Vec2(40.0, -7.0);
  const Fit a = fit("fpc", near), b = fit("fpc", far);
  REQUIRE(a.report.outcome == Outcome::converged);
  REQUIRE(b.report.outcome == Outcome::converged);
  for (int k = 0; k < a.curve->size(); ++k) {
    const Vec2 expected = 1e-3 * a.curve->segment(k).jet(0.3, 0).position() + Vec2(40.0, -7.0);
    CHECK((b.curve->segment(k).jet(0.3, 0).position() - expected).norm() < 1e-12);
  }
}

TEST_CASE("fpc: very small and very large units") {
  const Input near = with_random_types(random_input(Family::star, 8), 8);
  const Fit a = fit("fpc", near);
  for (const int exponent : {-300, 300}) {
    Input scaled = near;
    for (Vec2& p : scaled.points) p *= std::exp2(exponent);
    const Fit b = fit("fpc", scaled);
    REQUIRE(b.report.outcome == Outcome::converged);
    for (int k = 0; k < a.curve->size(); ++k)
      CHECK(std::exp2(-exponent) * b.curve->segment(k).jet(0.3, 0).position() ==
            a.curve->segment(k).jet(0.3, 0).position());
  }
}

TEST_CASE("fpc: reversing the points changes a curve with regular points") {
  Input back = five_points();
  std::reverse(back.points.begin(), back.points.end());
  const Fit there = fit("fpc", five_points()), other = fit("fpc", back);
  REQUIRE(other.report.outcome == Outcome::converged);
  // Segment k of the one belongs to point k, segment 4 - k of the other to the same.
  const double ends_apart =
      (there.curve->segment(0).jet(1.0, 0).position() - other.curve->segment(4).jet(0.0, 0).position()).norm();
  CHECK(ends_apart > 1e-3);
  CHECK_FALSE(scheme("fpc")->info().traits.reversal_invariant);

  // Without regular points it does not.
  Input cusps_there = five_points(std::vector<PointType>(5, PointType::cusp)), cusps_back = cusps_there;
  std::reverse(cusps_back.points.begin(), cusps_back.points.end());
  const Fit c = fit("fpc", cusps_there), d = fit("fpc", cusps_back);
  CHECK((c.curve->segment(0).jet(1.0, 0).position() - d.curve->segment(4).jet(0.0, 0).position()).norm() < 1e-11);
}

TEST_CASE("fpc: a cusp at the centre of an S shrinks to its point") {
  // The half-turn about the middle point maps the input to its reverse; a cusp cannot be such a symmetric segment.
  Input input{.points = {{-4, -1}, {-2, 1}, {0, 0}, {2, -1}, {4, 1}}, .closed = false, .options = {}, .ids = {}};
  input.options.resize(5);
  for (std::size_t i = 1; i < 4; ++i) input.options[i].type = PointType::cusp;
  const Fit result = fit("fpc", input);
  REQUIRE(result.report.outcome == Outcome::converged);
  CHECK(result.report.counters.at("at_inflection") == 1);
  CHECK(result.curve->size() == 2);
  CHECK(largest_miss(result) < 1e-12);
  CHECK(mismatch_of(*result.curve).angle < 1e-6);
}

TEST_CASE("fpc: a long chain is the same in windows and as a whole") {
  Random random(12);
  Input input{.points = {}, .closed = true, .options = {}, .ids = {}};
  const int n = 300;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + random.uniform(-0.3, 0.3)) / n;
    input.points.emplace_back(Vec2(std::cos(angle), std::sin(angle)) * (50.0 + random.uniform(-0.8, 0.8)));
  }
  const CubicChain chain = chain_of(with_random_types(input, 12));
  const Solution windows = solve_in_windows(chain), whole = solve_chain(chain, nullptr, false);
  REQUIRE(windows.converged);
  REQUIRE(whole.converged);
  for (std::size_t k = 0; k < chain.segments(); ++k) CHECK((windows.state.y[k] - whole.state.y[k]).norm() < 1e-9);
}
