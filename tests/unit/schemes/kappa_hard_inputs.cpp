// Inputs that need more than Newton: straight runs, near-coincident points, uneven triples, near-collinear runs and
// long chains. A few of each kind here; the bars of schemes/kappa/README.md are the hidden test at the end.

#include <chrono>
#include <cstdint>
#include <numbers>

#include "tests/catch.hpp"
#include "tests/unit/schemes/kappa_inputs.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// A track: two straights tangent to two half circles, `straight` and `bend` chords each, turned.
Input track(int straight, int bend, double length, double radius, double turn) {
  Input input{.points = {}, .closed = true, .options = {}, .ids = {}};
  for (const double side : {1.0, -1.0}) {
    for (int i = 0; i < straight; ++i)
      input.points.emplace_back(side * length * (static_cast<double>(i) / straight - 0.5), -side * radius);
    for (int i = 0; i < bend; ++i)
      input.points.push_back(Vec2(side * 0.5 * length, 0.0) +
                             side * radius * direction(std::numbers::pi * (static_cast<double>(i) / bend - 0.5)));
  }
  for (Vec2& p : input.points) p = p.x() * direction(turn) + p.y() * direction(turn + 0.5 * std::numbers::pi);
  return input;
}

Input random_track(std::uint64_t seed) {
  Random random(seed * 7001 + 5);
  const int straight = 8 + random.index(140), bend = 7 + random.index(150);
  const double length = random.uniform(0.5, 10.0), radius = random.uniform(0.3, 3.0), turn = random.uniform(0.0, 6.0);
  return track(straight, bend, length, radius, turn);
}

/// Three points with a chord ratio of 1 to 1e8.
Input triple(std::uint64_t seed) {
  Random random(seed * 7013 + 7);
  Input input{.points = {Vec2(0, 0), Vec2(1, 0)}, .closed = random.index(2) == 1, .options = {}, .ids = {}};
  const double ratio = std::pow(10.0, random.uniform(0.0, 8.0)), angle = random.uniform(-3.0, 3.0);
  input.points.emplace_back(Vec2(1.0, 0.0) + ratio * direction(angle));
  return input;
}

Input ring(std::uint64_t seed, int n, double spread) {
  Random random(seed * 7009 + 9);
  Input input{.points = {}, .closed = true, .options = {}, .ids = {}};
  for (int i = 0; i < n; ++i)
    input.points.push_back((n / (2.0 * std::numbers::pi) + random.uniform(-0.5, 0.5) * spread) *
                           direction(2.0 * std::numbers::pi * i / n));
  return input;
}

Input walk(std::uint64_t seed, int n) {
  Random random(seed * 7011 + 10);
  Input input{.points = {}, .closed = false, .options = {}, .ids = {}};
  Vec2 p = Vec2::Zero();
  double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
  for (int i = 0; i < n; ++i) {
    input.points.push_back(p);
    heading += 0.9 * random.normal();
    p += std::pow(10.0, random.uniform(-1.5, 0.5)) * direction(heading);
  }
  return input;
}

void check_solved(const char* scheme, const Input& input) {
  const Fit result = fit(scheme, input);
  INFO(scheme << ", " << input.points.size() << " points: " << result.report.message);
  CHECK(result.report.outcome == Outcome::converged);
  CHECK(result.report.residual <= 1e-12);
}

template <class Make>
int unsolved(const char* scheme, std::uint64_t from, std::uint64_t to, const Make& make) {
  int count = 0;
  for (std::uint64_t seed = from; seed < to; ++seed)
    count += fit(scheme, make(seed)).report.outcome != Outcome::converged;
  return count;
}

}  // namespace

TEST_CASE("straights tangent to arcs are solved", "[kappa]") {
  for (const char* scheme : {"kappa", "ekappa:a=0.8", "ekappa:a=0.95", "ekappa-trig:a=0.8"}) {
    check_solved(scheme, track(20, 24, 5.0, 1.0, 0.3));
    check_solved(scheme, track(60, 30, 9.0, 0.7, 1.1));
    check_solved(scheme, track(5, 60, 2.0, 1.5, 0.0));
  }
}

TEST_CASE("three points with uneven chords are solved", "[kappa]") {
  for (const char* scheme : {"kappa", "ekappa:a=0.8", "ekappa-trig:a=0.8"})
    for (std::uint64_t seed = 0; seed < 30; ++seed) check_solved(scheme, triple(seed));
}

TEST_CASE("a near-collinear run of five points is solved", "[kappa]") {
  const Input input{
      .points = {Vec2(0, 0.00017024732738275242), Vec2(1.0695133341324827, -0.00067750914523820966),
                 Vec2(2.4652712731099595, -0.00026784498896298094), Vec2(3.4948980039737023, 0.00095357447336555531),
                 Vec2(4.8995424379199077, 6.1138686724915509e-05)},
      .closed = false,
      .options = {},
      .ids = {}};
  check_solved("kappa", input);
}

TEST_CASE("rings and walks of a thousand points are solved", "[kappa]") {
  for (const double spread : {1.0, 6.0}) check_solved("kappa", ring(3, 1000, spread));
  check_solved("kappa", walk(3, 1000));
}

TEST_CASE("bars of the kappa family", "[.bars]") {
  for (const char* scheme : {"ekappa:a=0.8", "ekappa:a=0.95", "ekappa-trig:a=0.8"}) {
    INFO(scheme);
    CHECK(unsolved(scheme, 1000, 1050, random_track) == 0);
  }
  for (const char* scheme : {"kappa", "ekappa:a=0.8", "ekappa-trig:a=0.8"}) {
    INFO(scheme);
    CHECK(unsolved(scheme, 1000, 2000, triple) == 0);
  }
  for (const double spread : {1.0, 6.0})
    CHECK(unsolved("kappa", 1000, 1010, [&](std::uint64_t seed) { return ring(seed, 10000, spread); }) == 0);
  CHECK(unsolved("kappa", 1000, 1010, [](std::uint64_t seed) { return walk(seed, 10000); }) == 0);
}
