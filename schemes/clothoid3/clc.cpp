#include "schemes/clothoid3/clc.hpp"

#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "schemes/segments/clothoid.hpp"

namespace kappabench::clothoid3 {

namespace {

using std::numbers::pi;

/// x modulo a full turn, in [0, 2 pi).
double full_turn(double x) {
  const double r = std::fmod(x, 2.0 * pi);
  return r < 0.0 ? r + 2.0 * pi : r;
}

/// Both clothoids for one heading of the line.
struct Trial {
  double length0, length1;
  Vec2 inner0, inner1;  ///< where the line starts and ends
  double sine;          ///< signed, from the line to the heading
  bool forward;
};

class Search {
 public:
  Search(const CurveElement& from, const CurveElement& to, const Rules& rules) : from_(from), to_(to), rules_(rules) {}

  /// Curvature falls linearly over the length 2 turning / |curvature|.
  [[nodiscard]] Trial at(double heading) const {
    const double k0 = from_.curvature, k1 = to_.curvature;
    const double length0 = 2.0 * full_turn(std::copysign(1.0, k0) * (heading - from_.heading)) / std::abs(k0);
    const double length1 = 2.0 * full_turn(std::copysign(1.0, k1) * (to_.heading - heading)) / std::abs(k1);
    Trial trial{length0, length1, from_.point, to_.point, 0.0, false};
    if (length0 >= rules_.least_length)
      trial.inner0 += clothoid_displacement(from_.heading, k0, -k0 / length0, length0);
    if (length1 >= rules_.least_length) trial.inner1 += clothoid_displacement(to_.heading, k1, k1 / length1, -length1);
    const Vec2 line = (trial.inner1 - trial.inner0).normalized(), along(std::cos(heading), std::sin(heading));
    trial.sine = cross(line, along);
    trial.forward = line.dot(along) > 0.0;
    return trial;
  }

  /// The published search. nullopt if no heading makes the line run forwards.
  [[nodiscard]] std::optional<double> scan() const {
    const double side = std::copysign(1.0, from_.curvature);
    std::optional<double> best;
    double least = 10.0;
    const auto consider = [&](double heading) {
      const Trial trial = at(heading);
      if (!trial.forward || !(std::abs(trial.sine) < least)) return;
      best = heading;
      least = std::abs(trial.sine);
    };
    for (int k = 0; k < 32; ++k) consider(from_.heading + k * side * 2.0 * pi / 32.0);
    double step = side * pi / 32.0;
    for (int round = 0; best && round < 16; ++round, step *= 0.5) {
      const double middle = *best;
      consider(middle - step);
      consider(middle + step);
    }
    return best;
  }

  /// The heading without kink, if the scan ended beside one.
  [[nodiscard]] double polished(double heading) const {
    constexpr double reach = 1e-5;  // the scan's last steps are pi / 2^20
    const Trial low = at(heading - reach), high = at(heading + reach);
    if (!low.forward || !high.forward || !(low.sine * high.sine < 0.0)) return heading;
    std::uintmax_t evaluations = 60;
    const auto [a, b] = boost::math::tools::toms748_solve([this](double x) { return at(x).sine; }, heading - reach,
                                                          heading + reach, low.sine, high.sine,
                                                          boost::math::tools::eps_tolerance<double>(52), evaluations);
    const double root = 0.5 * (a + b);
    return std::abs(at(root).sine) < std::abs(at(heading).sine) ? root : heading;
  }

 private:
  const CurveElement& from_;
  const CurveElement& to_;
  const Rules& rules_;
};

}  // namespace

std::optional<ClothoidLineClothoid> clothoid_line_clothoid(const CurveElement& from, const CurveElement& to,
                                                           const Rules& rules) {
  const Search search(from, to, rules);
  const auto found = search.scan();
  if (!found) return std::nullopt;
  const double heading = rules.compat ? *found : search.polished(*found);
  const Trial trial = search.at(heading);
  ClothoidLineClothoid result{{}, std::abs(trial.sine)};
  if (trial.length0 >= rules.least_length)
    result.pieces.push_back({from.point, from.heading, from.curvature, -from.curvature / trial.length0, trial.length0});
  const Vec2 line = trial.inner1 - trial.inner0;
  result.pieces.push_back({trial.inner0, std::atan2(line.y(), line.x()), 0.0, 0.0, line.norm()});
  if (trial.length1 >= rules.least_length)
    result.pieces.push_back({trial.inner1, to.heading - 0.5 * to.curvature * trial.length1, 0.0,
                             to.curvature / trial.length1, trial.length1});
  return result;
}

}  // namespace kappabench::clothoid3
