#include <fmt/format.h>

#include <utility>

#include "experiments/check/all_claims.hpp"
#include "experiments/check/same_curve.hpp"

namespace kappabench::check {

namespace {

struct NamedEdit {
  std::string name;
  Edit edit;
};

/// Every kind of edit, at the ends and inside; each is made to what the ones before left.
NamedEdit next_edit(int k, const Input& input) {
  const auto at = [&](int i) { return input.points[static_cast<std::size_t>(i)]; };
  const auto middle = [&](int i) -> Vec2 { return 0.5 * (at(i - 1) + at(i)); };
  const int n = input.size(), inside = n / 2;
  const Vec2 by = mean_chord(input) * Vec2(0.05, 0.02);
  const auto move = [&](int i) { return NamedEdit{fmt::format("point {} moved", i), Move{i, at(i) + by}}; };
  switch (k) {
    case 0:
      return move(inside);
    case 1:
      return move(0);
    case 2:
      return move(n - 1);
    case 3:
      return {fmt::format("a point inserted before {}", inside), Insert{inside, middle(inside) + by, {}}};
    case 4:
      return {"a point inserted before the first", Insert{0, at(0) - 0.5 * (at(1) - at(0)) + by, {}}};
    case 5:
      return {"a point inserted after the last", Insert{n, at(n - 1) - 0.4 * (at(n - 2) - at(n - 1)) + by, {}}};
    case 6:
      return {fmt::format("point {} erased", inside), Erase{inside}};
    case 7:
      return {"the first point erased", Erase{0}};
    default:
      return {"the last point erased", Erase{n - 1}};
  }
}
constexpr int edits = 9;

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  for (const Trial* trial : subject.short_curves()) {
    if (trial->fit.input.size() < 8) continue;  // enough to erase three
    Fit fit = trial->fit;
    for (int k = 0; k < edits; ++k) {
      const NamedEdit next = next_edit(k, fit.input);
      const Trial cold{
          changed(trial->shown, fmt::format("edit {}: {}", k + 1, next.name), kappabench::apply(fit.input, next.edit)),
          subject.fit(kappabench::apply(fit.input, next.edit))};
      Fit warm = tried_refit(subject.scheme(), fit, next.edit);
      if (!cold.fit.curve) break;
      const double found = warm.curve ? deviation({spans(*cold.fit.curve), spans(*warm.curve), cold.fit.input.closed,
                                                   mean_chord(cold.fit.input)})
                                      : 0.0;
      judge(subject, {cold, cold.shown, warm, found}, notes);
      if (!warm.curve) break;
      fit = std::move(warm);
    }
  }
  return notes.finding();
}

bool says(const SchemeTraits& traits) { return traits.refit_is_fit; }

}  // namespace

Claim refit_claim() { return {"refit", "after each kind of edit, the curve of a fit from scratch", says, test}; }

}  // namespace kappabench::check
