// Every combination of pkappa's options interpolates and keeps its continuity, on every drawing that is not too long.

#include <algorithm>
#include <cstdlib>

#include "datasets/datasets.hpp"
#include "metrics/continuity.hpp"
#include "tests/catch.hpp"
#include "tests/sanitized.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

constexpr std::size_t short_drawing = sanitized ? 4 : 5;

/// With KAPPABENCH_PKAPPA_ALL set, all drawings; else the short ones.
std::size_t most_points() { return std::getenv("KAPPABENCH_PKAPPA_ALL") != nullptr ? 1000 : short_drawing; }

void check(const Fit& fit) {
  REQUIRE(fit.curve.has_value());
  CHECK(fit.report.residual <= 1e-10);
  // As printed, without weights, an edge may vanish and with it the tangent; such a fit says that it failed.
  if (fit.report.outcome != Outcome::converged) return;
  const double chord = mean_chord(fit.input);
  for (const JointJump& jump : joint_jumps(*fit.curve, fit.input)) {
    INFO("joint " << jump.joint.segment);
    CHECK(jump.gap <= 1e-10);
    const Jet before = fit.curve->segment(jump.joint.segment).jet(1.0, 2);
    const Jet after = fit.curve->segment(fit.curve->next(jump.joint.segment)).jet(0.0, 2);
    const double shorter = std::min(before.d[1].norm(), after.d[1].norm());
    CHECK(jump.angle * shorter <= 1e-10 * chord);
    const bool parametric = jump.joint.claimed == Continuity::c1 || jump.joint.claimed == Continuity::c2;
    if (parametric) CHECK((before.d[1] - after.d[1]).norm() <= 1e-10 * chord);
    if (jump.joint.claimed == Continuity::c2) CHECK((before.d[2] - after.d[2]).norm() <= 1e-10 * chord);
    if (jump.joint.claimed == Continuity::g2) CHECK(jump.curvature <= 1e-10 + jump.curvature_uncertainty);
  }
}

}  // namespace

TEST_CASE("pkappa: every option combination interpolates and is as continuous as it says") {
  for (const Drawing& drawing : builtin_drawings()) {
    for (const Input& input : drawing.curves) {
      if (input.points.size() > most_points() || input.points.size() < 3) continue;
      for (const std::string continuity : {"c1", "g1", "c2", "g2"})
        for (const std::string mode : {"local", "global", "paper"})
          for (const std::string quadrature : {"gauss", "simpson201"}) {
            const std::string id = "pkappa:continuity=" + continuity + ",mode=" + mode + ",quadrature=" + quadrature;
            const Fit fit = scheme(id)->fit(input);
            if (fit.report.outcome == Outcome::unsupported_input) continue;
            INFO(id << " on " << drawing.id);
            check(fit);
          }
    }
  }
}
