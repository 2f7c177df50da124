#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <variant>
#include <vector>

#include "experiments/check/all_claims.hpp"

namespace kappabench::check {

namespace {

constexpr std::size_t segments_of_a_kind = 40;
constexpr std::array parameters{0.0, 0.03, 0.27, 0.5, 0.71, 0.98, 1.0};

constexpr double room = 0.01;  // that differences need on both sides

struct Kind {
  std::string operator()(const PolynomialForm& form) const {
    return fmt::format("polynomial of degree {}", form.control_points.size() - 1);
  }
  std::string operator()(const RationalForm& form) const {
    return fmt::format("rational of degree {}", form.control_points.size() - 1);
  }
  std::string operator()(const TrigonometricForm&) const { return "trigonometric"; }
  std::string operator()(const ClothoidForm&) const { return "clothoid"; }
  std::string operator()(const IntrinsicForm&) const { return "intrinsic"; }
  std::string operator()(const EllipticArcForm&) const { return "elliptic arc"; }
  std::string operator()(const BlendForm& form) const {
    return fmt::format("blend of {} and {}", of(*form.from), of(*form.to));
  }
  std::string operator()(const ReparametrizedForm& form) const {
    return fmt::format("reparametrized {}", of(*form.of));
  }
  std::string operator()(const SampledForm&) const { return "sampled"; }
  std::string operator()(const OpaqueForm&) const { return "opaque"; }

  static std::string of(const Segment& segment) { return std::visit(Kind{}, segment.exact()); }
};

using Wide = Eigen::Matrix<long double, 2, 1>;

struct Derivative {
  Wide value;
  double error;  ///< an estimate
};

/// Where the segment may be less smooth than inside of its pieces: its ends, and the knots of a spline.
std::vector<double> breaks(const Segment& segment) {
  std::vector<double> result{0.0, 1.0};
  const ExactForm exact = segment.exact();
  if (const auto* form = std::get_if<IntrinsicForm>(&exact))
    result.insert(result.end(), form->knots.begin(), form->knots.end());
  if (const auto* form = std::get_if<SampledForm>(&exact)) result.insert(result.end(), form->t.begin(), form->t.end());
  return result;
}

double distance_to(const std::vector<double>& places, double t) {
  double least = 1.0;
  for (const double place : places) least = std::min(least, std::abs(place - t));
  return least;
}

/// The derivative of d^(order - 1) at t, by Ridders' method (Advances in Engineering Software 4, 1982): central
/// differences at steps that shrink by 1.4 from `step` on, Neville's extrapolation to step 0, and of its tableau the
/// entry that differs least from its forerunners.
Derivative difference(const Segment& segment, double t, double step, int order) {
  constexpr int rows = 16;
  constexpr double shrink = 1.4;
  const auto lower = [&](double at) {
    return segment.jet(at, order - 1).d[static_cast<std::size_t>(order - 1)].cast<long double>().eval();
  };
  std::array<std::array<Wide, rows>, rows> tableau;
  Derivative best{Wide::Zero(), std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < rows; ++i, step /= shrink) {
    const double after = t + step, before = t - step;
    tableau[0][i] = (lower(after) - lower(before)) / (static_cast<long double>(after) - before);
    long double power = shrink * shrink;
    for (std::size_t j = 1; j <= i; ++j, power *= shrink * shrink) {
      tableau[j][i] = (tableau[j - 1][i] * power - tableau[j - 1][i - 1]) / (power - 1.0L);
      const auto error = static_cast<double>(
          std::max((tableau[j][i] - tableau[j - 1][i]).norm(), (tableau[j][i] - tableau[j - 1][i - 1]).norm()));
      if (error < best.error) best = {tableau[j][i], error};
    }
  }
  return best;
}

/// Looks at the segments of a kind, the first of them.
class Looker {
 public:
  Looker(const SchemeUnderTest& subject, Notes& notes) : subject_(subject), notes_(notes) {}

  void look(const Trial& trial) {
    const Curve& curve = *trial.fit.curve;
    for (int k = 0; k < curve.size(); ++k) {
      const std::string kind = Kind::of(curve.segment(k));
      if (std::size_t& seen = seen_[kind]; ++seen <= segments_of_a_kind)
        look(curve.segment(k), {fmt::format("{}, segment {} ({})", trial.shown.name, k, kind), "",
                                fit_command(trial.shown, subject_.text())});
    }
  }

  [[nodiscard]] std::string kinds() const {
    std::vector<std::string> names;
    for (const auto& entry : seen_) names.push_back(entry.first);
    return fmt::format("{}", fmt::join(names, ", "));
  }

 private:
  void look(const Segment& segment, const Refutation& place) {
    notes_.count("segments");
    std::array<Jet, parameters.size()> together{}, alone{};
    segment.jets(parameters, max_jet_order, together);
    for (std::size_t i = 0; i < parameters.size(); ++i) alone[i] = segment.jet(parameters[i], max_jet_order);
    const std::array<double, max_jet_order + 1> sizes = largest(alone);
    const std::vector<double> places = breaks(segment);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      compare_batch(together[i], alone[i], parameters[i], sizes, place);
      if (const double smooth = distance_to(places, parameters[i]); smooth >= room)
        differentiate(segment, alone[i], parameters[i], 0.9 * smooth, sizes, place);
    }
  }

  /// Sizes of each order over the segment: what rounding is relative to.
  static std::array<double, max_jet_order + 1> largest(const std::array<Jet, parameters.size()>& jets) {
    std::array<double, max_jet_order + 1> sizes{};
    for (const Jet& jet : jets)
      for (std::size_t k = 0; k < sizes.size(); ++k) sizes[k] = std::max(sizes[k], jet.d[k].norm());
    return sizes;
  }

  void compare_batch(const Jet& together, const Jet& alone, double t,
                     const std::array<double, max_jet_order + 1>& sizes, Refutation place) {
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      const double off = (together.d[k] - alone.d[k]).norm();
      // A sum of a hundred terms, in another order: some 2^10 roundings at the most.
      if (off <= 0x1p-42 * sizes[k]) continue;
      place.numbers =
          fmt::format("order {} at t = {}: jets() and jet() are {:.3g} apart, of {:.3g}", k, t, off, sizes[k]);
      notes_.refute(place);
    }
  }

  void differentiate(const Segment& segment, const Jet& jet, double t, double step,
                     const std::array<double, max_jet_order + 1>& sizes, Refutation place) {
    for (int order = 1; order <= max_jet_order; ++order) {
      notes_.count("derivatives");
      const auto k = static_cast<std::size_t>(order);
      const Derivative expected = difference(segment, t, step, order);
      const double off = static_cast<double>((jet.d[k].cast<long double>() - expected.value).norm());
      // Differences of doubles know half of their digits; a wrong formula is wrong in the first.
      if (off <= 10.0 * expected.error + 0x1p-26 * std::max(sizes[k], sizes[k - 1])) continue;
      place.numbers = fmt::format(
          "derivative {} at t = {} is ({:.9g}, {:.9g}); differences of derivative {} give "
          "({:.9g}, {:.9g}) to {:.1g}",
          order, t, jet.d[k].x(), jet.d[k].y(), order - 1, static_cast<double>(expected.value.x()),
          static_cast<double>(expected.value.y()), expected.error);
      notes_.refute(place);
    }
  }

  const SchemeUnderTest& subject_;
  Notes& notes_;
  std::map<std::string, std::size_t> seen_;
};

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  Looker looker(subject, notes);
  for (const Trial* trial : subject.curves()) looker.look(*trial);
  notes.say(looker.kinds());
  return notes.finding();
}

}  // namespace

Claim jets_claim() { return {"jets", "analytic derivatives, one at a time and in batches", always, test}; }

}  // namespace kappabench::check
