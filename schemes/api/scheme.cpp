#include "schemes/api/scheme.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <utility>

#include "schemes/api/frame.hpp"
#include "schemes/api/soundness.hpp"
#include "schemes/api/timed_outside.hpp"
#include "schemes/api/warnings.hpp"

namespace kappabench {

Scheme::Scheme(SchemeInfo info, Parameters parameters) : info_(std::move(info)), parameters_(std::move(parameters)) {}

std::string reason_unsupported(const SchemeTraits& traits, const Input& input) {
  if (input.closed && !traits.closed) return "closed curves are not supported; open the curve";
  if (!input.closed && !traits.open) return "open curves are not supported; close the curve";
  const int fewest = input.closed ? traits.fewest_closed_points : traits.fewest_open_points;
  if (input.size() < fewest)
    return fmt::format("{} point{}; {} curve needs at least {}", input.size(), input.size() == 1 ? "" : "s",
                       input.closed ? "a closed" : "an open", fewest);
  for (int i = 0; i < input.size(); ++i)
    if (!input.points[static_cast<std::size_t>(i)].allFinite())
      return fmt::format("point {} is not finite; every coordinate must be a number", i);
  if (traits.repeats_allowed) return {};

  // Closer than this, relative to the mean chord, the direction of a leg is mostly rounding.
  const double coincident = 1e-9 * mean_chord(input);
  const int legs = input.closed ? input.size() : input.size() - 1;
  for (int i = 0; i < legs; ++i) {
    const int next = (i + 1) % input.size();
    const double leg =
        (input.points[static_cast<std::size_t>(next)] - input.points[static_cast<std::size_t>(i)]).norm();
    if (!std::isfinite(leg)) return fmt::format("points {} and {} are too far apart; rescale the drawing", i, next);
    if (leg <= coincident)
      return fmt::format("points {} and {} coincide; {}", i, next,
                         next == 0 ? "a closed curve must not repeat its first point" : "remove one of them");
  }
  return {};
}

namespace {

Fit unsupported(const Input& input, std::string reason) {
  return {.input = input,
          .curve = std::nullopt,
          .report = {.outcome = Outcome::unsupported_input, .message = std::move(reason)}};
}

/// Holds a curve against its claims and notes where it is wild, both curve and input in the drawing's own frame.
void judge(Report& report, const Curve& curve, const Input& input) {
  if (report.outcome != Outcome::converged && report.outcome != Outcome::not_converged) return;
  std::string message = report.outcome == Outcome::converged ? unsoundness(curve, input) : "";
  if (!message.empty()) {
    report.outcome = Outcome::not_converged;
    report.message = "misses its claim: " + message;
  }
  for (const Warning& warning : warnings_of(curve)) {
    report.warnings[warning.name] = warning.spans;
    if (report.message.empty()) report.message = warning.first;
  }
}

/// Runs an author's part in the drawing's own frame, times it, and judges the curve where it lies in the plane, seen
/// from that frame again: large coordinates cost the curve their rounding, but no evaluation.
template <class Solve>
Fit solved(const Input& input, const Placement& frame, Solve solve) {
  const bool at_home = frame.is_identity();
  const Input local = at_home ? Input{} : place(input, frame.inverse());
  const auto start = std::chrono::steady_clock::now();
  Fit fit = solve(at_home ? input : local);
  if (!is_timed_outside(fit.report))
    fit.report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (fit.curve) {
    if (at_home) {
      judge(fit.report, *fit.curve, input);
    } else {
      fit.curve = place(*fit.curve, frame);
      judge(fit.report, place(*fit.curve, frame.inverse()), local);
    }
  }
  if (!at_home) fit.input = input;
  return fit;
}

}  // namespace

Fit Scheme::fit(const Input& input) const {
  if (std::string reason = reason_unsupported(info_.traits, input); !reason.empty())
    return unsupported(input, std::move(reason));
  return solved(input, frame_for(input), [&](const Input& local) { return solve(local); });
}

Fit Scheme::refit(const Fit& fit, const Edit& edit) const {
  const Input edited = apply(fit.input, edit);
  if (std::string reason = reason_unsupported(info_.traits, edited); !reason.empty())
    return unsupported(edited, std::move(reason));
  const Placement frame = frame_for(edited), inward = frame.inverse();
  return solved(edited, frame, [&](const Input&) {
    return frame.is_identity() ? resolve(fit, edit) : resolve(place(fit, inward), place(edit, inward));
  });
}

Placement Scheme::frame_for(const Input& input) const {
  return info_.traits.similarity_invariant ? frame_of(input) : Placement{};
}

Fit Scheme::resolve(const Fit& fit, const Edit& edit) const { return solve(apply(fit.input, edit)); }

}  // namespace kappabench
