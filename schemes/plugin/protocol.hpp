#pragma once

#include <string>
#include <string_view>

#include "schemes/api/scheme.hpp"

namespace kappabench {

/// The line that asks for a fit (README.md), its end included.
[[nodiscard]] std::string question_of(const Input& input, const Parameters& parameters);

/// The fit that a program's answer tells of: curve JSON, where nodes are found and joints claim what the traits of the
/// scheme say unless it tells. Throws std::exception with one line that names the scheme's manifest for what is no
/// such answer.
[[nodiscard]] Fit fit_of_answer(std::string_view line, const Input& input, const SchemeInfo& info);

}  // namespace kappabench
