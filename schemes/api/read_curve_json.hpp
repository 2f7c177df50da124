#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "schemes/api/fit.hpp"
#include "schemes/api/parameters.hpp"

namespace kappabench {

/// What one object of format "kappabench-curve" says (CURVE_JSON.md), as it stands there; what it leaves out is empty.
struct CurveRecord {
  std::string scheme{};
  std::map<std::string, ParameterValue> parameters{};
  std::optional<bool> closed{};
  std::vector<SegmentPtr> segments{};
  std::optional<std::vector<Node>> nodes{};
  std::optional<std::vector<Joint>> joints{};
  Report report{.outcome = Outcome::converged};
};

/// The curves of a text, an array of objects or one object alone, of version 1 or 2. Every number is checked: counts,
/// finite where it must be, ranges; unknown fields are ignored. Throws std::invalid_argument with one line, "mine.json:
/// curve 1: segments[3].weights[0]: -1; weights are positive numbers", the text being called `source`.
[[nodiscard]] std::vector<CurveRecord> read_curves(std::string_view json, std::string_view source);

/// What holds where a record says nothing.
struct CurveDefaults {
  bool closed = false;
  std::span<const Vec2> points{};       ///< nodes: where the curve passes nearest to each (find_nodes)
  Continuity claimed = Continuity::g0;  ///< of every joint
};

/// The curve of a record that has segments. Throws std::invalid_argument if nodes or joints name no segment.
[[nodiscard]] Curve curve_of(const CurveRecord& record, const CurveDefaults& defaults);

}  // namespace kappabench
