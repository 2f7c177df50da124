#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "datasets/analytic.hpp"
#include "datasets/random_points.hpp"
#include "datasets/random_source.hpp"
#include "tests/catch.hpp"
#include "tests/unit/datasets/scratch.hpp"

using namespace kappabench;
using Catch::Matchers::Contains;

namespace {

std::string refused(std::string_view name) {
  return refusal([&] { return open_drawings(name); });
}

double shortest_chord(const Input& input) {
  double shortest = 1e300;
  for (std::size_t i = 0; i + (input.closed ? 0 : 1) < input.points.size(); ++i) {
    shortest = std::min(shortest, (input.points[(i + 1) % input.points.size()] - input.points[i]).norm());
  }
  return shortest;
}

}  // namespace

TEST_CASE("the random source is the one of the C++ standard", "[datasets]") {
  // The standard fixes the 10000th output of a default-seeded mt19937_64; its default seed is 5489.
  RandomSource random(5489);
  double last = 0.0;
  for (int i = 0; i < 10'000; ++i) last = random.uniform(0.0, 1.0);
  CHECK(last == static_cast<double>(9981545732273789042ULL >> 11U) * 0x1.0p-53);
}

TEST_CASE("normal numbers have mean 0 and variance 1", "[datasets]") {
  RandomSource random(3);
  constexpr int n = 100'000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
  }
  CHECK(std::abs(sum / n) < 5.0 / std::sqrt(n));  // five standard errors
  CHECK(std::abs(squares / n - 1.0) < 5.0 * std::sqrt(2.0 / n));
}

TEST_CASE("random families: seeded, distinct, with the points asked for", "[datasets]") {
  for (const RandomKind kind : random_kinds()) {
    for (const bool closed : {false, true}) {
      for (const int n : {1, 2, 3, 4, 7, 50, 1000}) {
        CAPTURE(name(kind), closed, n);
        const Input input = random_input(kind, n, 42, closed);
        CHECK(input.size() == n);
        CHECK(input.closed == closed);
        CHECK(std::ranges::all_of(input.points, [](const Vec2& p) { return p.allFinite(); }));
        CHECK(input.points == random_input(kind, n, 42, closed).points);
        if (n >= 3) {
          CHECK(input.points != random_input(kind, n, 43, closed).points);
          CHECK(shortest_chord(input) > 0.0);
          CHECK(mean_chord(input) == Approx(1.0).epsilon(1e-8));
        }
      }
    }
  }
  CHECK_THROWS_AS(random_input(RandomKind::walk, 0, 1, false), std::invalid_argument);
}

TEST_CASE("random families: the same numbers as ever", "[datasets]") {
  // Third point of each family for n = 12, seed = 2022, as computed once; they may change only on purpose.
  struct Expected {
    RandomKind kind;
    bool closed;
    double x;
    double y;
  };
  const std::vector<Expected> expected{{RandomKind::walk, false, -1.8890835838392377, 0.50368010718375444},
                                       {RandomKind::walk, true, -0.70569892227649689, 1.8245947929099202},
                                       {RandomKind::star, false, 0.56459133140742779, 1.4639920806512237},
                                       {RandomKind::star, true, 0.5649574613198638, 1.4649414597079158},
                                       {RandomKind::zigzag, false, 0.66055157408118248, 0.36220537405461073},
                                       {RandomKind::zigzag, true, 0.54898820538073778, 1.4235329870134592},
                                       {RandomKind::uneven, false, 2.4474488133564591, 0.089967784471809864},
                                       {RandomKind::uneven, true, 2.3056147806346416, 0.11261830199509859},
                                       {RandomKind::near_collinear, false, -1.9901906149461865, 0.19273786153644323},
                                       {RandomKind::near_collinear, true, 0.57644543144851923, 1.0019431281834841},
                                       {RandomKind::spiral, false, -0.8239491693675518, -0.94827248435467482},
                                       {RandomKind::spiral, true, -1.0842382097616792, -1.3324156599119306}};
  for (const Expected& e : expected) {
    CAPTURE(name(e.kind), e.closed);
    const Vec2 point = random_input(e.kind, 12, 2022, e.closed).points[2];
    CHECK(std::abs(point.x() - e.x) <= 0x1.0p-30);
    CHECK(std::abs(point.y() - e.y) <= 0x1.0p-30);
  }
}

TEST_CASE("random names", "[datasets]") {
  const std::vector<Drawing> drawings = open_drawings("random:star:n=9,seed=4,closed=true,count=3");
  REQUIRE(drawings.size() == 3);
  CHECK(drawings[1].id == "random:star:n=9,seed=5,closed=true");
  CHECK(drawings[1].curves[0].points == random_input(RandomKind::star, 9, 5, true).points);
  CHECK(open_drawings(drawings[2].id)[0].curves[0].points == drawings[2].curves[0].points);
  CHECK(open_drawings("random:walk")[0].curves[0].size() == 12);

  CHECK_THAT(refused("random:blob"), Contains("no random family \"blob\"; known are walk, star"));
  CHECK_THAT(refused("random:walk:n=0"), Contains("n = \"0\"; give an integer from 1"));
  CHECK_THAT(refused("random:walk:n=2.5"), Contains("n = \"2.5\"; give an integer"));
  CHECK_THAT(refused("random:walk:seed=-1"), Contains("seed = \"-1\"; give an integer from 0"));
  CHECK_THAT(refused("random:walk:closed=1"), Contains("closed = \"1\"; give true or false"));
  CHECK_THAT(refused("random:walk:size=4"), Contains("unknown option \"size\"; known are n, seed"));
  CHECK_THAT(refused("random:walk:n=4,n=5"), Contains("\"n\" is given twice; "));
  CHECK_THAT(refused("random:walk:n"), Contains("\"n\" is no option; write key=value"));
  CHECK_THAT(refused("random:walk:n=1000000,count=1000"), Contains("more than 10^8 points; "));
  CHECK_THAT(refused("random:walk:n=4:seed=5"), Contains("write random:KIND:n=12,seed=1"));
}

TEST_CASE("analytic points lie on their curves", "[datasets]") {
  const auto worst = [](AnalyticKind kind, Sampling sampling, const auto& residual) {
    double most = 0.0;
    for (const Vec2& p : analytic_input(kind, 25, sampling, 3).points) most = std::max(most, std::abs(residual(p)));
    return most;
  };
  const double grid = 0x1.0p-27;  // coordinates are rounded to 2^-30, gradients here are below 8
  for (const Sampling sampling : {Sampling::even, Sampling::uneven}) {
    CHECK(worst(AnalyticKind::circle, sampling, [](const Vec2& p) { return p.norm() - 1.0; }) < grid);
    CHECK(worst(AnalyticKind::ellipse, sampling,
                [](const Vec2& p) { return p.x() * p.x() / 4.0 + p.y() * p.y() - 1.0; }) < grid);
    CHECK(worst(AnalyticKind::superellipse, sampling,
                [](const Vec2& p) { return std::pow(p.x() / 2.0, 4) + std::pow(p.y(), 4) - 1.0; }) < grid);
    CHECK(worst(AnalyticKind::sine, sampling, [](const Vec2& p) { return p.y() - std::sin(p.x()); }) < grid);
    CHECK(worst(AnalyticKind::log_spiral, sampling, [](const Vec2& p) {
            const double turns = std::log(p.norm() / 0.2) / 0.2;
            return p.norm() * std::sin(turns - std::atan2(p.y(), p.x()));
          }) < grid);
    // (x^2 + y^2 - 2 x)^2 = x^2 + y^2
    CHECK(worst(AnalyticKind::limacon, sampling, [](const Vec2& p) {
            return std::pow(p.squaredNorm() - 2.0 * p.x(), 2) - p.squaredNorm();
          }) < 16.0 * grid);
  }
}

TEST_CASE("the clothoid ends at the Fresnel integrals", "[datasets]") {
  // C and S of Abramowitz and Stegun 7.3 at z = 2.5 / sqrt(pi), times sqrt(pi), by their power series.
  double x = 0.0;
  double y = 0.0;
  double term = 2.5;  // u^(2k+1) / (2^k k!)
  for (int k = 0; k < 60; ++k) {
    const double sign = (k / 2) % 2 == 0 ? 1.0 : -1.0;
    (k % 2 == 0 ? x : y) += sign * term / (2 * k + 1);
    term *= 2.5 * 2.5 / (2.0 * (k + 1));
  }
  const Input clothoid = analytic_input(AnalyticKind::clothoid, 9, Sampling::even, 1);
  CHECK((clothoid.points.back() - Vec2(x, y)).norm() < 1e-8);
  CHECK((clothoid.points.front() + Vec2(x, y)).norm() < 1e-8);
  CHECK(clothoid.points[4].norm() < 1e-8);
}

TEST_CASE("even sampling is even, uneven and noisy are not", "[datasets]") {
  const auto spread = [](Sampling sampling) {
    const Input circle = analytic_input(AnalyticKind::circle, 20, sampling, 1);
    double least = 1e300;
    double most = 0.0;
    for (std::size_t i = 0; i < 20; ++i) {
      const double chord = (circle.points[(i + 1) % 20] - circle.points[i]).norm();
      least = std::min(least, chord);
      most = std::max(most, chord);
    }
    return most / least;
  };
  CHECK(spread(Sampling::even) < 1.0 + 1e-5);
  CHECK(spread(Sampling::uneven) > 3.0);
  CHECK(spread(Sampling::noisy) > 1.01);
  CHECK(spread(Sampling::noisy) < 1.5);
}

TEST_CASE("analytic names", "[datasets]") {
  for (const AnalyticKind kind : analytic_kinds()) {
    for (const Sampling sampling : samplings()) {
      const std::string id = "analytic:" + std::string(name(kind)) + ":n=10,sampling=" + std::string(name(sampling));
      const Drawing drawing = open_drawings(id + ",seed=8").at(0);
      CHECK(drawing.id == id + ",seed=8");
      CHECK(drawing.curves[0].points == analytic_input(kind, 10, sampling, 8).points);
      CHECK(shortest_chord(drawing.curves[0]) > 0.0);
    }
  }
  CHECK_THAT(refused("analytic:parabola"), Contains("no analytic curve \"parabola\"; known are circle"));
  CHECK_THAT(refused("analytic:circle:n=1"), Contains("n = \"1\"; give an integer from 2"));
  CHECK_THAT(refused("analytic:circle:sampling=odd"), Contains("no sampling \"odd\"; known are even"));
  CHECK_THAT(refused("analytic:circle:closed=true"), Contains("unknown option \"closed\"; "));
  CHECK_THROWS_AS(analytic_input(AnalyticKind::circle, 1, Sampling::even, 1), std::invalid_argument);
}
