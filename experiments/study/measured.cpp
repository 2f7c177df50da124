#include "experiments/study/measured.hpp"

#include <algorithm>

namespace kappabench {

std::optional<double> measured(const store::CurveRecord& curve, const Column& column) {
  const auto found = std::ranges::find(curve.measurements, column.name, &store::MeasurementRecord::column);
  if (found == curve.measurements.end()) return std::nullopt;
  return found->value;
}

long counted(const store::CurveRecord& curve, const std::string& counter) {
  const auto found = curve.counters.find(counter);
  return found == curve.counters.end() ? 0 : found->second;
}

}  // namespace kappabench
