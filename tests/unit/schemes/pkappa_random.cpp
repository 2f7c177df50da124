// Random curves of 10 points. KAPPABENCH_PKAPPA_SEEDS=1000 runs as many of each kind and prints the counts;
// KAPPABENCH_PKAPPA_KIND=star runs one kind only.

#include <cstdlib>
#include <iostream>

#include "schemes/pkappa/segment_energy.hpp"
#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"
#include "tests/sanitized.hpp"
#include "tests/unit/schemes/kappa_inputs.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

enum class Kind { walk, uneven_walk, square, star };

Input random_ten(Kind kind, std::uint64_t seed, bool closed) {
  Random random(seed * 7368787 + static_cast<std::uint64_t>(kind) * 104729 + 5);
  Input input{.points = {}, .closed = closed, .options = {}, .ids = {}};
  Vec2 at = Vec2::Zero();
  double angle = 0.0;
  const bool uneven = kind == Kind::uneven_walk;
  for (int i = 0; i < 10; ++i) {
    const double turn = 2.0 * std::numbers::pi * (i + random.uniform(0.0, 0.5)) / 10;
    if (kind == Kind::square) at = {random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)};
    if (kind == Kind::star) at = random.uniform(1.0, 1.6) * Vec2(std::cos(turn), std::sin(turn));
    input.points.push_back(at);
    // Turns to 72 (129) degrees, chords log-normal with deviation 0.4 (0.8).
    angle += random.uniform(-1.0, 1.0) * (uneven ? 2.25 : 1.25);
    at += std::exp((uneven ? 0.8 : 0.4) * random.normal()) * Vec2(std::cos(angle), std::sin(angle));
  }
  return input;
}

/// The largest E_p of a segment, in units of the mean chord.
template <int Degree>
std::vector<double> energies(const Fit& fit) {
  pkappa::SegmentEnergy<Degree> energy(pkappa::fine_gauss_rule());
  std::vector<double> e;
  for (const Node& node : fit.curve->nodes()) {
    if (node.t <= 0.0 || node.t >= 1.0) continue;
    const auto& segment = dynamic_cast<const PolynomialSegment&>(fit.curve->segment(node.segment));
    pkappa::ControlPolygon<Degree> control;
    for (int j = 0; j <= Degree; ++j) control.col(j) = segment.control_points()[static_cast<std::size_t>(j)];
    e.push_back(mean_chord(fit.input) * energy.terms(control, node.t).parabola);
  }
  return e;
}

struct Count {
  int failures = 0, not_converged = 0;
  double mean = 0.0;
};

Count count(Kind kind, bool closed, const std::string& mode, const std::string& continuity, int seeds) {
  const SchemePtr pkappa = scheme("pkappa:mode=" + mode + ",continuity=" + continuity);
  Count result;
  int segments = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    const Fit fit = pkappa->fit(random_ten(kind, static_cast<std::uint64_t>(seed), closed));
    REQUIRE(fit.curve.has_value());
    CHECK(fit.report.residual <= 1e-10);
    const bool quartic = continuity == "c1" || continuity == "g1";
    const std::vector<double> e = quartic ? energies<4>(fit) : energies<5>(fit);
    const bool high = std::ranges::any_of(e, [](double x) { return !(x < 0.1); });
    result.not_converged += fit.report.outcome != Outcome::converged;
    if (high || fit.report.outcome != Outcome::converged)
      UNSCOPED_INFO("seed " << seed << ": " << fit.report.message << ", largest E_p " << *std::ranges::max_element(e));
    result.failures += high || fit.report.outcome != Outcome::converged;
    for (const double x : e) {
      result.mean += x;
      ++segments;
    }
  }
  result.mean /= segments;
  return result;
}

}  // namespace

TEST_CASE("pkappa: random curves of ten points") {
  const char* wanted = std::getenv("KAPPABENCH_PKAPPA_SEEDS");
  const int seeds = wanted != nullptr ? std::atoi(wanted) : test::cases(2);
  const std::pair<Kind, const char*> kinds[] = {
      {Kind::walk, "walk"}, {Kind::uneven_walk, "uneven walk"}, {Kind::square, "square"}, {Kind::star, "star"}};
  const char* only = std::getenv("KAPPABENCH_PKAPPA_KIND");
  for (const auto& [kind, word] : kinds)
    for (const bool closed : {false, true}) {
      if (only != nullptr && std::string(only) != word) continue;
      for (const std::string continuity : {"c1", "g1", "c2", "g2"}) {
        const std::string mode = closed ? "global" : "local";
        const Count c = count(kind, closed, mode, continuity, seeds);
        const bool gentle = closed ? kind == Kind::star : kind == Kind::walk || kind == Kind::star;
        INFO(word << (closed ? ", closed, " : ", open, ") << mode << " " << continuity);
        if (gentle) CHECK(c.failures == 0);
        if (wanted != nullptr)
          std::cout << word << (closed ? " closed " : " open ") << mode << " " << continuity << ": " << c.failures
                    << " failures (" << c.not_converged << " not converged) of " << seeds << ", mean E_p " << c.mean
                    << std::endl;
      }
    }
}
