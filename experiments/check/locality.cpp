#include <fmt/format.h>

#include <algorithm>

#include "experiments/check/all_claims.hpp"
#include "experiments/check/same_curve.hpp"

namespace kappabench::check {

namespace {

// Arc lengths before a span are summed over all spans before it: some 2^10 roundings at the most.
constexpr double roundings = 0x1p-42;

/// How many spans `span` is away from the point: 1 for the two beside it. On a closed curve the shorter way round.
int distance(const std::vector<Span>& all, std::size_t span, int point, bool closed) {
  const int n = static_cast<int>(all.size()), k = static_cast<int>(span);
  int least = n + 1;
  for (int m = 0; m < n; ++m) {
    const Span& start = all[static_cast<std::size_t>(m)];
    if (start.from == point) {  // the point is where span m starts
      const int ahead = k - m;
      least = std::min(least, ahead >= 0 ? ahead + 1 : -ahead);
      if (closed) least = std::min(least, ahead >= 0 ? n - ahead : n + ahead + 1);
    }
    if (!closed && m + 1 == n && start.to == point) least = std::min(least, n - k);
  }
  return least;
}

void move_point(const SchemeUnderTest& subject, const Trial& trial, const std::vector<Span>& original, int point,
                const Vec2& by, Notes& notes) {
  const Input& input = trial.shown.input;
  const double chord = mean_chord(input);
  const int claimed = subject.traits().locality;
  const Input edited =
      kappabench::apply(input, Move{point, input.points[static_cast<std::size_t>(point)] + chord * by});
  const Case shown =
      changed(trial.shown, fmt::format("point {} moved by ({}, {}) chords", point, by.x(), by.y()), edited);
  const Fit other = subject.fit(edited);
  notes.count("moves");
  const auto deviations = other.curve ? span_deviations(original, spans(*other.curve), input.closed) : std::nullopt;
  if (!deviations) {
    notes.count("without a curve");
    return;
  }
  const double allowed = roundings * std::max(1.0, largest_coordinate(edited) / chord);
  for (std::size_t k = 0; k < original.size(); ++k) {
    const int spans_away = distance(original, k, point, input.closed);
    if (spans_away <= claimed) continue;
    notes.count("spans beyond");
    const double found = (*deviations)[k] / chord;
    if (deviates(subject, other, found, allowed))
      notes.refute(
          {fmt::format("{}: span {} to {}", shown.name, original[k].from, original[k].to),
           fmt::format("is {} spans away and moves by {:.3g} chords; claimed is {} spans, allowed beyond {:.2g}",
                       spans_away, found, claimed, allowed),
           fit_command(shown, subject.text())});
  }
}

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  const int claimed = subject.traits().locality;
  // Long enough for spans beyond the claim on both sides.
  const int n = std::max(20, 2 * claimed + 8);
  for (const int seed : {1, 2})
    for (const bool closed : {false, true}) {
      if (closed ? !subject.traits().closed : !subject.traits().open) continue;
      const Case shown = random_star(n, seed, closed);
      const Trial trial{shown, subject.fit(shown.input)};
      if (!trial.fit.curve) continue;
      const std::vector<Span> original = spans(*trial.fit.curve);
      for (int point = 0; point < n; point += std::max(1, n / 10))
        for (const Vec2& by : {Vec2(0.1, 0.0), Vec2(-0.06, 0.25)})
          move_point(subject, trial, original, point, by, notes);
    }
  notes.say(fmt::format("{} spans", claimed));
  return notes.finding();
}

bool says(const SchemeTraits& traits) { return traits.locality >= 0; }

}  // namespace

Claim locality_claim() {
  return {"locality", "a move of a point changes nothing beyond the claimed spans", says, test};
}

}  // namespace kappabench::check
