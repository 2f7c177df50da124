#include "schemes/clothoid3/refine.hpp"

#include <algorithm>
#include <cmath>

#include "schemes/clothoid3/clc.hpp"

namespace kappabench::clothoid3 {

namespace {

struct Pair {
  double first, second;
};

/// "max-linear" growth: both at least a times the smaller one.
Pair grown(const Pair& k, double a) {
  const double least = a * std::min(std::abs(k.first), std::abs(k.second));
  return {std::copysign(std::max(std::abs(k.first), least), k.first),
          std::copysign(std::max(std::abs(k.second), least), k.second)};
}

/// The span with trial curvatures at its ends.
class Trials {
 public:
  Trials(const CurveElement& from, const CurveElement& to, Pieces pieces, const Rules& rules)
      : from_(from), to_(to), pieces_(pieces), rules_(rules) {}

  [[nodiscard]] bool accept(const Pair& k) const {
    CurveElement from = from_, to = to_;
    from.curvature = k.first;
    to.curvature = k.second;
    if (pieces_ == Pieces::clc) {
      const auto span = clothoid_line_clothoid(from, to, rules_);
      return span && span->misalignment < allowed_misalignment;
    }
    const auto span = three_arcs(from, to);
    return span && good(*span, k.first, k.second, rules_);
  }

  /// The published search for the factor: growing steps until one is accepted, then halving ones.
  [[nodiscard]] Pair search() const {
    const Pair original{from_.curvature, to_.curvature};
    if (accept(original)) return original;
    double a = 1.0, step = 1.0;
    bool hit = false;
    Pair last = original;
    for (int k = 0; k < 16; ++k) {
      const Pair trial = grown(original, a);
      if (accept(trial)) {
        hit = true;
        last = trial;
        step *= 0.5;
        a -= step;
      } else {
        a += step;
        if (!hit) step *= 2.0;
      }
    }
    if (pieces_ == Pieces::clc) {
      last = grown(original, a);
      for (int k = 0; k < 100 && !accept(last); ++k) last = grown(original, a += step);
    }
    return a < 1.0 ? original : last;
  }

 private:
  const CurveElement& from_;
  const CurveElement& to_;
  Pieces pieces_;
  const Rules& rules_;
};

void raise(double& kept, double proposed) {
  if (std::abs(proposed) > std::abs(kept)) kept = proposed;
}

}  // namespace

bool good(const ThreeArcs& span, double curvature0, double curvature1, const Rules& rules) {
  const auto& [first, middle, last] = span.arcs;
  if (curvature0 * curvature1 < 0.0) {
    const auto sign = [](double x) { return (x > 0.0) - (x < 0.0); };
    const int slope = sign(first.curvature_rate);
    return slope != 0 && sign(middle.curvature_rate) == slope && sign(last.curvature_rate) == slope;
  }
  const double most = std::min(std::abs(curvature0), std::abs(curvature1)) + rules.least_curvature;
  return std::abs(middle.curvature) <= most && std::abs(last.curvature) <= most;
}

void refine(std::vector<PointElement>& elements, bool closed, Pieces pieces, const Rules& rules) {
  const std::size_t n = elements.size(), spans = closed ? n : n - 1;
  // The spans at open ends start from what the inner ones left.
  for (const bool of_ends : {false, true}) {
    std::vector<double> kept;
    kept.reserve(n);
    for (const PointElement& element : elements) kept.push_back(element.at.curvature);
    for (std::size_t i = 0; i < spans; ++i) {
      const bool at_end = !closed && (i == 0 || i + 1 == spans);
      const PointElement &from = elements[i], &to = elements[(i + 1) % n];
      const bool flat =
          std::abs(from.at.curvature) <= rules.least_curvature || std::abs(to.at.curvature) <= rules.least_curvature;
      if (at_end != of_ends || flat || (from.given_curvature && to.given_curvature)) continue;
      const Pair proposed = Trials(from.at, to.at, pieces, rules).search();
      raise(kept[i], proposed.first);
      raise(kept[(i + 1) % n], proposed.second);
    }
    for (std::size_t i = 0; i < n; ++i)
      if (!elements[i].given_curvature) elements[i].at.curvature = kept[i];
  }
}

}  // namespace kappabench::clothoid3
