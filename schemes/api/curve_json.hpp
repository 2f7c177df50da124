#pragma once

#include <string>

#include "schemes/api/scheme.hpp"

namespace kappabench {

/// A fit as one JSON object of format "kappabench-curve", version 1 (README.md): the report with its counters, and the
/// defining numbers of every segment with 17 significant digits, so that any program can rebuild the curve exactly. A
/// number that is not finite is null. Without a curve the lists are empty.
[[nodiscard]] std::string curve_json(const Scheme& scheme, const Fit& fit);

}  // namespace kappabench
