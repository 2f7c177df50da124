#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "experiments/study/quantity.hpp"
#include "schemes/api/registry.hpp"

namespace kappabench::wang {

/// What every experiment on Wang et al. 2024 needs.

inline constexpr std::string_view paper = "pkappa-2024-wang";

/// The scheme with these options: "mode=global,continuity=c1", or "" for the defaults.
[[nodiscard]] inline SchemePtr pkappa(const Registry& registry, std::string_view options) {
  return registry.parse(options.empty() ? std::string("pkappa") : fmt::format("pkappa:{}", options));
}

/// Which of the random curves of a cell a row tells of.
inline const study::Key curve_number{"curve"};

}  // namespace kappabench::wang
