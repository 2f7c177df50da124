#include "schemes/numerics/root_isolation_by_intervals.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>

namespace kappabench {
namespace {

using boost::numeric::intersect;
using boost::numeric::median;
using boost::numeric::width;
using boost::numeric::zero_in;

constexpr int first_depth = 3;  // from eight parts on, enclosures begin to hold something
constexpr int deepest = 44;

/// An argument with what is known of the function at it.
struct Place {
  double t;
  Enclosure at;
};

class Isolation {
 public:
  Isolation(const EnclosedFunction& f, int most_parts) : f_(f), left_(most_parts) {}

  [[nodiscard]] bool decides(const Place& from, const Place& to, int depth) {
    if (left_-- == 0) return false;
    if (depth >= first_depth) {
      const Enclosure on = f_({from.t, to.t});
      // The mean value theorem, from either end.
      const Interval step(0.0, to.t - from.t);
      const Interval value =
          intersect(on.value, intersect(from.at.value + on.slope * step, to.at.value - on.slope * step));
      if (const int sign = sign_of(value); sign != 0) {
        note(from.t, sign);
        note(to.t, sign);
        return true;
      }
      if (sign_of(on.slope) != 0) {
        note(from.t, sign_of(from.at.value));
        note(to.t, sign_of(to.at.value));
        return true;
      }
      // An end is as uncertain as rounding makes it.
      if (largest(value) <= std::max(on.noise, 4.0 * std::max(width(from.at.value), width(to.at.value)))) return true;
      if (depth == deepest) return false;
    }
    const double t = 0.5 * (from.t + to.t);
    const Place middle{t, f_(Interval(t))};
    return decides(from, middle, depth + 1) && decides(middle, to, depth + 1);
  }

  [[nodiscard]] const std::vector<RootBracket>& found() const { return found_; }

 private:
  /// The sign is certain at t, and nothing was certain between the last such place and this one, or all changed once.
  void note(double t, int sign) {
    if (sign == 0) return;
    if (sign_before_ != 0 && sign != sign_before_) found_.push_back(narrowed({t_before_, t}, sign_before_));
    sign_before_ = sign;
    t_before_ = t;
  }

  /// A fast search on the middles of the enclosures, then its end widened until both signs are certain.
  [[nodiscard]] RootBracket narrowed(RootBracket bracket, int sign_lo) const {
    const auto middle = [&](double t) { return median(f_(Interval(t)).value); };
    std::uintmax_t steps = 60;
    const double lo = middle(bracket.lo), hi = middle(bracket.hi);
    if (!(lo * hi < 0.0)) return bracket;
    const auto [a, b] = boost::math::tools::toms748_solve(middle, bracket.lo, bracket.hi, lo, hi,
                                                          boost::math::tools::eps_tolerance<double>(50), steps);
    RootBracket narrow = bracket;
    for (double around = 0x1p-52; around < 1.0; around *= 8.0) {
      const double left = a - around, right = b + around;
      if (left > narrow.lo && sign_of(f_(Interval(left)).value) == sign_lo) narrow.lo = left;
      if (right < narrow.hi && sign_of(f_(Interval(right)).value) == -sign_lo) narrow.hi = right;
      if ((narrow.lo > bracket.lo || left <= bracket.lo) && (narrow.hi < bracket.hi || right >= bracket.hi)) break;
    }
    return narrow;
  }

  const EnclosedFunction& f_;
  int left_;
  int sign_before_ = 0;
  double t_before_ = 0.0;
  std::vector<RootBracket> found_;
};

}  // namespace

std::optional<std::vector<RootBracket>> isolate_sign_changes(const EnclosedFunction& f, int most_parts) {
  Isolation isolation(f, most_parts);
  const Place start{0.0, f(Interval(0.0))}, end{1.0, f(Interval(1.0))};
  if (!isolation.decides(start, end, 0)) return std::nullopt;
  return isolation.found();
}

bool stays_above(const EnclosedFunction& f, double bound, int most_parts) {
  // The parts that are still open, the leftmost one last.
  std::vector<RootBracket> open{{0.0, 1.0}};
  for (int parts = 0; !open.empty(); ++parts) {
    if (parts == most_parts) return false;
    const RootBracket part = open.back();
    open.pop_back();
    if (f({part.lo, part.hi}).value.lower() > bound) continue;
    open.push_back({part.mid(), part.hi});
    open.push_back({part.lo, part.mid()});
  }
  return true;
}

}  // namespace kappabench
