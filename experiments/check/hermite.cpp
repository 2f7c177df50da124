#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "experiments/check/all_claims.hpp"

namespace kappabench::check {

namespace {

// Solvers stop at residuals of about 1e-12; two digits are theirs, as of positions.
constexpr double allowed = 1e-10;

struct Ends {
  Input input;

  [[nodiscard]] std::string words() const {
    std::string text;
    for (std::size_t i = 0; i < 2; ++i) {
      text += fmt::format("{} {},{},{}", i == 0 ? "--from" : " --to", input.points[i].x(), input.points[i].y(),
                          *input.options[i].tangent * 180.0 / std::numbers::pi);
      if (input.options[i].curvature) text += fmt::format(",{}", *input.options[i].curvature);
    }
    return text;
  }
};

/// Directions at both ends against a chord of length 2.
Ends ends(double before, double after) {
  const Vec2 from(1.0, -2.0), chord = 2.0 * Vec2(std::cos(0.3), std::sin(0.3));
  Ends result;
  result.input.points = {from, from + chord};
  result.input.options = {{.tangent = 0.3 + before}, {.tangent = 0.3 + after}};
  return result;
}

/// `alike` are curvatures that some smooth curve with these tangents has: those of the fit without them, a tenth more.
Ends with_curvatures(Ends given, const Curve& alike) {
  given.input.options[0].curvature = 1.1 * curvature(alike.segment(0).jet(0.0, 2));
  given.input.options[1].curvature = 1.1 * curvature(alike.segment(alike.size() - 1).jet(1.0, 2));
  return given;
}

double angle_off(const Jet& jet, double wanted) {
  return std::abs(std::remainder(tangent_angle(jet) - wanted, 2.0 * std::numbers::pi));
}

/// What is missed, in words; empty if nothing.
std::string missed(const Ends& given, const Curve& curve) {
  const std::array<Jet, 2> jets{curve.segment(0).jet(0.0, 2), curve.segment(curve.size() - 1).jet(1.0, 2)};
  const double chord = mean_chord(given.input);
  for (std::size_t i = 0; i < 2; ++i) {
    const char* where = i == 0 ? "start" : "end";
    const double gap = (jets[i].position() - given.input.points[i]).norm() / chord;
    if (!(gap <= allowed)) return fmt::format("the {} is missed by {:.3g} chords", where, gap);
    const double angle = angle_off(jets[i], *given.input.options[i].tangent);
    if (!(angle <= allowed)) return fmt::format("the direction at the {} is off by {:.3g} rad", where, angle);
    const auto wanted = given.input.options[i].curvature;
    const double found = curvature(jets[i]);
    if (wanted && !(std::abs(found - *wanted) <= allowed * std::max(1.0 / chord, std::abs(*wanted))))
      return fmt::format("the curvature at the {} is {:.12g}; given is {:.12g}", where, found, *wanted);
  }
  return {};
}

Fit look(const SchemeUnderTest& subject, const Ends& given, bool must_converge, Notes& notes) {
  Fit fit = subject.fit(given.input);
  notes.count("fits");
  const auto refute = [&](const std::string& numbers) {
    notes.refute(
        {"two points", numbers, fmt::format("kappabench hermite {} --scheme {}", given.words(), subject.text())});
  };
  const bool converged = fit.report.outcome == Outcome::converged && fit.curve;
  if (!converged && must_converge)
    refute(fmt::format("{}: {}", kappabench::name(fit.report.outcome), fit.report.message));
  if (converged)
    if (const std::string what = missed(given, *fit.curve); !what.empty()) refute(what);
  return fit;
}

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  const Continuity claimed = subject.traits().continuity;
  const bool to_curvatures = claimed == Continuity::g2 || claimed == Continuity::c2;
  for (const double before : {-1.0, -0.4, 0.2, 0.9})
    for (const double after : {-0.8, -0.3, 0.5, 1.0}) {
      const Ends given = ends(before, after);
      const Fit fit = look(subject, given, true, notes);
      // Curvatures may ask for what a scheme has not; what it calls converged must meet them.
      if (fit.curve && to_curvatures)
        static_cast<void>(look(subject, with_curvatures(given, *fit.curve), false, notes));
    }
  return notes.finding();
}

bool says(const SchemeTraits& traits) { return traits.hermite; }

}  // namespace

Claim hermite_claim() {
  return {"hermite", "two points: tangents, and curvatures if G2 is claimed, are met", says, test};
}

}  // namespace kappabench::check
