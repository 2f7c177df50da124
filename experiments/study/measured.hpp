#pragma once

#include <optional>
#include <string>

#include "metrics/metric.hpp"
#include "reports/store/model.hpp"

namespace kappabench {

/// The measurement, or nothing when the curve has none (no curve, or the metric was not asked for).
[[nodiscard]] std::optional<double> measured(const store::CurveRecord& curve, const Column& column);

/// A counter of the report; 0 when the scheme does not have it.
[[nodiscard]] long counted(const store::CurveRecord& curve, const std::string& counter);

}  // namespace kappabench
