#pragma once

#include <functional>
#include <span>
#include <vector>

#include "datasets/drawing.hpp"
#include "metrics/metric.hpp"
#include "reports/store/model.hpp"
#include "schemes/api/registry.hpp"

namespace kappabench::python {

/// The table that the verb `compare` prints: every curve of every drawing by every scheme, measured. The fits share
/// `threads` threads of this process. Whatever a scheme throws is a row, outcome "failed". `checked` is called from the
/// calling thread now and then; what it throws ends the work and is thrown.
[[nodiscard]] store::TableRecord compare(const std::vector<Drawing>& drawings, const std::vector<SchemePtr>& schemes,
                                         const std::vector<const Metric*>& metrics, int threads,
                                         const std::function<void()>& checked);

}  // namespace kappabench::python
