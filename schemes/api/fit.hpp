#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "schemes/api/input.hpp"
#include "schemes/curve/curve.hpp"

namespace kappabench {

enum class Outcome {
  converged,
  not_converged,      ///< there may be a curve, but it misses the scheme's own equations: see residual
  unsupported_input,  ///< the scheme says what it cannot take
  failed,             ///< numerical trouble without a usable curve
  timed_out,          ///< given by the driver, never by a scheme
  crashed             ///< given by the driver, never by a scheme
};

/// "converged", "not_converged", ...
[[nodiscard]] std::string_view name(Outcome outcome);

/// How a fit went. `residual` is scale-free (lengths over the mean chord); each scheme's README defines it.
struct Report {
  Outcome outcome = Outcome::failed;
  std::string message{};  ///< one line; empty when there is nothing to say
  int iterations = 0;
  double residual = 0.0;
  double seconds = 0.0;                    ///< wall time of the fit alone, filled in by Scheme::fit
  std::vector<double> trace{};             ///< residual before the first and after each iteration
  std::map<std::string, long> counters{};  ///< named by the scheme: "pinned", "fixed_point_sweeps", ...
  /// Of a curve that is legal but wild, found by Scheme::fit: names, and how many spans (schemes/api/warnings.hpp).
  std::map<std::string, long> warnings{};
};

/// A curve, if there is one, and how it came about. Guarantee: `curve` is present when the outcome is `converged`, and
/// then keeps what it claims (schemes/api/soundness.hpp); absent when it is `unsupported_input`, `failed`, `timed_out`
/// or `crashed`.
struct Fit {
  Input input;
  std::optional<Curve> curve;
  Report report;
};

}  // namespace kappabench
