#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "datasets/drawing.hpp"
#include "metrics/metric.hpp"
#include "schemes/api/registry.hpp"

namespace kappabench {

/// All that the result of a cell depends on. Equal Uses mean equal results, so that a finished cell need not be
/// computed again; what a cell computes sees nothing but its Uses (see CellJob).
struct Uses {
  std::string work;                  ///< what is computed
  int version = 1;                   ///< of the work: raise it when results change
  std::vector<SchemePtr> schemes{};  ///< every scheme that is fitted with; the first is the one that the cell is about
  std::vector<Drawing> drawings{};
  std::vector<const Metric*> metrics{};     ///< every metric whose code is used
  std::uint64_t seed = 0;                   ///< of random inputs
  std::map<std::string, double> numbers{};  ///< counts and other constants of the work, by name
  std::map<std::string, std::string> words{};
};

/// 16 hexadecimal digits that change with every part of `uses`: versions and parameters of schemes, points with all
/// their options, versions of metrics, the work, its version, seed and constants. Titles and sources of drawings change
/// nothing.
[[nodiscard]] std::string key_of(const Uses& uses);

}  // namespace kappabench
