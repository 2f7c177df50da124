#include "experiments/check/same_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "metrics/transformed.hpp"

namespace kappabench::check {

namespace {

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

bool same_jets(const Segment& a, const Segment& b, double t) {
  const Jet one = a.jet(t, max_jet_order), other = b.jet(t, max_jet_order);
  for (std::size_t k = 0; k < one.d.size(); ++k)
    if (!same_bits(one.d[k].x(), other.d[k].x()) || !same_bits(one.d[k].y(), other.d[k].y())) return false;
  return true;
}

bool same_node(const Node& a, const Node& b) {
  return a.point == b.point && a.segment == b.segment && same_bits(a.t, b.t) && a.marks == b.marks;
}

bool same_joint(const Joint& a, const Joint& b) { return a.segment == b.segment && a.claimed == b.claimed; }

std::string difference(const Curve& a, const Curve& b) {
  if (a.size() != b.size()) return fmt::format("{} and {} segments", a.size(), b.size());
  for (int k = 0; k < a.size(); ++k)
    for (const double t : {0.0, 0.3, 0.7, 1.0})
      if (!same_jets(a.segment(k), b.segment(k), t)) {
        const Vec2 p = a.segment(k).jet(t, 0).position(), q = b.segment(k).jet(t, 0).position();
        return fmt::format("segment {}, t = {}: ({}, {}) and ({}, {})", k, t, p.x(), p.y(), q.x(), q.y());
      }
  if (!std::ranges::equal(a.nodes(), b.nodes(), same_node)) return "the nodes differ";
  if (!std::ranges::equal(a.joints(), b.joints(), same_joint)) return "the joints differ";
  return {};
}

}  // namespace

std::string difference(const Fit& a, const Fit& b) {
  if (a.report.outcome != b.report.outcome)
    return fmt::format("{} and {}", kappabench::name(a.report.outcome), kappabench::name(b.report.outcome));
  if (a.curve.has_value() != b.curve.has_value()) return "one of them has no curve";
  if (a.curve)
    if (std::string place = difference(*a.curve, *b.curve); !place.empty()) return place;
  if (a.report.iterations != b.report.iterations)
    return fmt::format("{} and {} iterations", a.report.iterations, b.report.iterations);
  if (a.report.counters != b.report.counters) return "the counters differ";
  if (a.report.message != b.report.message) return "the messages differ";
  return {};
}

double deviation(const Expected& pair) {
  return kappabench::deviation(pair.spans, pair.computed, pair.closed) / pair.chord;
}

double sensitivity(const SchemeUnderTest& subject, const Fit& fit) {
  const double chord = mean_chord(fit.input), step = half_the_digits * chord;
  double largest = 0.0;
  // Two starts: a jump need not lie on every side.
  for (const double start : {0.0, std::numbers::pi}) {
    const Fit other = subject.fit(perturbed(fit.input, step, start));
    if (!other.curve) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, deviation({spans(*fit.curve), spans(*other.curve), fit.input.closed, step}));
  }
  return largest;
}

bool deviates(const SchemeUnderTest& subject, const Fit& at, double found, double allowed) {
  if (found <= allowed) return false;
  const double factor = sensitivity(subject, at);
  return factor < at_a_jump && !(found <= allowed * std::max(1.0, factor));
}

void judge(const SchemeUnderTest& subject, const Same& same, Notes& notes, double allowed) {
  notes.count("fits");
  const std::string command = fit_command(same.shown, subject.text());
  const Fit& fit = same.fit;
  // Two outcomes at a jump are no more a contradiction than two curves.
  if (!fit.curve || fit.report.outcome != same.original.fit.report.outcome) {
    if (sensitivity(subject, same.original.fit) < at_a_jump)
      notes.refute({same.shown.name,
                    fmt::format("{} ({}); the original is {}", kappabench::name(fit.report.outcome), fit.report.message,
                                kappabench::name(same.original.fit.report.outcome)),
                    command});
    return;
  }
  if (deviates(subject, same.original.fit, same.found, allowed))
    notes.refute(
        {same.shown.name, fmt::format("deviates by {:.3g} chords; allowed are {:.2g}", same.found, allowed), command});
}

}  // namespace kappabench::check
