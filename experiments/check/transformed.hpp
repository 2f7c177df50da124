#pragma once

#include "metrics/transformed.hpp"
#include "schemes/curve/curve.hpp"

namespace kappabench::check {

/// The curve under the map. Its segments are opaque.
[[nodiscard]] Curve transformed(const Curve& curve, const Similarity& map);

}  // namespace kappabench::check
