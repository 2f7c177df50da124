#pragma once

#include <span>
#include <string>

#include "schemes/api/scheme.hpp"

namespace kappabench {

/// A fit as one JSON object of format "kappabench-curve", version 2, as CURVE_JSON.md says: the report with its
/// counters, the defining numbers of every segment, each with as many digits as read back to the same bits, so that any
/// program can rebuild the curve exactly, and the nodes with their marks. A segment without defining numbers is
/// sampled. A number that is not finite is null, bytes that are not UTF-8 are replaced. Without a curve the lists are
/// empty.
[[nodiscard]] std::string curve_json(const Scheme& scheme, const Fit& fit);

/// The fits of a drawing, an array with one object, and one line, for each; what `read_curves` reads.
[[nodiscard]] std::string curves_json(const Scheme& scheme, std::span<const Fit> fits);

}  // namespace kappabench
