#include <fmt/format.h>

#include <algorithm>

#include "experiments/check/all_claims.hpp"

namespace kappabench::check {

namespace {

// Solvers stop at residuals of about 1e-12 chords; two digits are theirs. Coordinates are rounded besides.
double allowed_miss(const Input& input) {
  return 1e-10 * mean_chord(input) + 64.0 * 0x1p-52 * largest_coordinate(input);
}

void look(const SchemeUnderTest& subject, const Trial& trial, Notes& notes) {
  const Fit& fit = trial.fit;
  const double allowed = allowed_miss(fit.input);
  std::vector<bool> met(fit.input.points.size(), false);
  const auto refute = [&](std::size_t point, const std::string& numbers) {
    notes.refute(
        {fmt::format("{}, point {}", trial.shown.name, point), numbers, fit_command(trial.shown, subject.text())});
  };
  for (const Node& node : fit.curve->nodes()) {
    notes.count("nodes");
    const auto point = static_cast<std::size_t>(node.point);
    if (node.point < 0 || point >= met.size()) {
      refute(point, fmt::format("a node names it; the input has {} points", met.size()));
      continue;
    }
    met[point] = true;
    const double miss = (fit.curve->segment(node.segment).jet(node.t, 0).position() - fit.input.points[point]).norm();
    if (!(miss <= allowed)) refute(point, fmt::format("missed by {:.3g}; allowed is {:.2g}", miss, allowed));
  }
  for (std::size_t point = 0; point < met.size(); ++point)
    if (!met[point]) refute(point, "has no node; every point has one");
}

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  for (const Trial* trial : subject.curves()) {
    notes.count("curves");
    look(subject, *trial, notes);
  }
  return notes.finding();
}

}  // namespace

Claim interpolation_claim() { return {"interpolation", "every point has a node, and nodes lie there", always, test}; }

}  // namespace kappabench::check
