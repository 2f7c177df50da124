#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/catch.hpp"
#include "tests/schemes.hpp"
#include "tests/unit/metrics/curves.hpp"

using namespace kappabench;
using namespace kappabench::test;

/// A metric measures a curve, not the way it is written down: read backwards, in a mirror, from another start, larger,
/// smaller or somewhere else, every column says the same, up to rounding.

namespace {

struct Drawn {
  const char* name;
  std::string scheme;
  Input input;
};

Input drawing(bool closed, const std::vector<Vec2>& points, const std::vector<std::pair<int, PointType>>& types = {}) {
  Input input{points, closed, {}, {}};
  if (types.empty()) return input;
  input.options.resize(points.size());
  for (const auto& [i, type] : types) {
    auto& options = input.options[static_cast<std::size_t>(i)];
    options.type = type;
    if (type == PointType::loop) options.alpha = options.beta = 0.36;
  }
  return input;
}

/// A letter R; a blob without symmetry; an open zigzag; a clover of four cusps; two loops between two ends.
std::vector<Drawn> drawings() {
  const Input letter = drawing(
      false, {{14, 4}, {18, 50}, {20, 92}, {48, 98}, {68, 80}, {54, 58}, {24, 50}, {52, 40}, {72, 10}, {90, 6}});
  const Input blob = drawing(true, {{0, 0}, {2, 0.3}, {2.6, 1.9}, {1.1, 2.2}, {-0.7, 1.3}});
  const Input zigzag = drawing(false, {{0, 0}, {1, 1.2}, {2.3, 0.4}, {3.1, 1.7}, {4.6, 1.1}, {5, -0.6}});
  const Input clover =
      drawing(true,
              {{50, 62},
               {60, 92},
               {92, 88},
               {90, 60},
               {62, 50},
               {90, 40},
               {88, 10},
               {60, 10},
               {50, 38},
               {40, 10},
               {10, 12},
               {10, 40},
               {38, 50},
               {10, 60},
               {12, 90},
               {40, 92}},
              {{0, PointType::cusp}, {4, PointType::cusp}, {8, PointType::cusp}, {12, PointType::cusp}});
  const Input loops =
      drawing(false, {{0, 0}, {36, 34}, {60, 4}, {84, 31}, {120, 0}}, {{1, PointType::loop}, {3, PointType::loop}});
  std::vector<Drawn> all;
  for (const SchemeInfo& scheme : all_schemes().list()) {
    all.push_back({"letter", scheme.id, letter});
    all.push_back({"blob", scheme.id, blob});
    all.push_back({"zigzag", scheme.id, zigzag});
  }
  all.push_back({"clover", "fpc", clover});
  all.push_back({"loops", "fpc", loops});
  return all;
}

/// The same drawing, written down otherwise.
struct Rewritten {
  const char* name;
  double scale = 1.0;
  double offset = 0.0;  ///< in mean chords, to the right and half as far up
  bool mirror = false;
  bool reverse = false;
  int first = 0;  ///< the point to start from, if the curve is closed

  [[nodiscard]] Input operator()(const Input& input) const {
    Input result = input;
    const Vec2 shift = offset * mean_chord(input) * Vec2(1.0, 0.5);
    for (Vec2& p : result.points) p = scale * (Vec2(p.x(), mirror ? -p.y() : p.y()) + shift);
    const auto arrange = [this, &input](auto& list) {
      if (list.empty()) return;
      if (input.closed) std::rotate(list.begin(), list.begin() + first, list.end());
      if (reverse) std::reverse(list.begin(), list.end());
    };
    arrange(result.points);
    arrange(result.options);
    return result;
  }

  /// What rounding may do to a column. Coordinates are rounded to 2^-53 of their size; curvature is a second
  /// derivative, the worst columns hold squares of a third, and schemes that iterate stop a few digits earlier: 1e6
  /// times that.
  [[nodiscard]] double tolerance() const { return 1e6 * 0x1p-53 * std::max(1.0, offset); }
};

bool same(double a, double b, double tolerance) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  if (std::isinf(a) || std::isinf(b)) return a == b;
  return std::abs(a - b) <= tolerance * std::max({1.0, std::abs(a), std::abs(b)});
}

void check_that_columns_stay(const Drawn& drawn, const Rewritten& rewritten) {
  const SchemePtr by = scheme(drawn.scheme);
  const Fit fit = by->fit(drawn.input);
  const Fit other = by->fit(rewritten(drawn.input));
  INFO(drawn.name << " by " << drawn.scheme << ", " << rewritten.name);
  REQUIRE(fit.curve);
  REQUIRE(other.curve);
  for (const Metric& metric : all_metrics()) {
    if (metric.refits) continue;
    const std::vector<Measurement> expected = metric.measure(*by, fit);
    const std::vector<Measurement> found = metric.measure(*by, other);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const double unit = expected[i].unit == "1/length" ? rewritten.scale : 1.0;
      INFO(expected[i].column << ": " << expected[i].value << " and " << unit * found[i].value);
      CHECK(same(expected[i].value, unit * found[i].value, rewritten.tolerance()));
    }
  }
}

}  // namespace

TEST_CASE("no metric depends on how a curve is written down", "[metrics][invariance_of_metrics]") {
  const std::vector<Rewritten> ways{
      {.name = "reversed", .reverse = true},
      {.name = "mirrored", .mirror = true},
      {.name = "from the third point", .first = 2},
      {.name = "mirrored, reversed, from the fourth point", .mirror = true, .reverse = true, .first = 3},
      {.name = "at scale 1e-6", .scale = 1e-6},
      {.name = "at scale 1e6", .scale = 1e6},
      {.name = "at scale 1e-150", .scale = 1e-150},
      {.name = "at scale 1e150", .scale = 1e150},
      {.name = "1e7 chords away", .offset = 1e7}};
  for (const Drawn& drawn : drawings())
    for (const Rewritten& way : ways) {
      const SchemeTraits traits = scheme(drawn.scheme)->info().traits;
      const bool another_curve =
          (way.reverse && !traits.reversal_invariant) || (way.first > 0 && !traits.cyclic_shift_invariant);
      if (!another_curve) check_that_columns_stay(drawn, way);
    }
}

TEST_CASE("so far out that rounding decides", "[.][metrics][invariance_of_metrics][far]") {
  for (const Drawn& drawn : drawings()) check_that_columns_stay(drawn, {.name = "far away", .offset = 1e9});
}
