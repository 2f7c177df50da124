#include "schemes/api/scheme.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <utility>

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

/// Runs an author's solve or resolve behind the checks that all schemes share, and times it.
template <class Solve>
Fit checked(const SchemeTraits& traits, const Input& input, Solve solve) {
  if (std::string reason = reason_unsupported(traits, input); !reason.empty())
    return {.input = input,
            .curve = std::nullopt,
            .report = {.outcome = Outcome::unsupported_input, .message = std::move(reason)}};
  const auto start = std::chrono::steady_clock::now();
  Fit fit = solve();
  fit.report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return fit;
}

}  // namespace

Fit Scheme::fit(const Input& input) const {
  return checked(info_.traits, input, [&] { return solve(input); });
}

Fit Scheme::refit(const Fit& fit, const Edit& edit) const {
  return checked(info_.traits, apply(fit.input, edit), [&] { return resolve(fit, edit); });
}

Fit Scheme::resolve(const Fit& fit, const Edit& edit) const { return solve(apply(fit.input, edit)); }

}  // namespace kappabench
