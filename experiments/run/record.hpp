#pragma once

#include <span>
#include <string>

#include "metrics/metric.hpp"
#include "reports/store/model.hpp"
#include "schemes/api/scheme.hpp"

namespace kappabench {

/// The fit of one curve as the store keeps it: input, report, exact form, samples for figures, and what the
/// metrics say of it. Without a curve only input and report are filled.
[[nodiscard]] store::CurveRecord record_of(const Scheme& scheme, const Fit& fit,
                                           std::span<const Metric* const> metrics);

}  // namespace kappabench
