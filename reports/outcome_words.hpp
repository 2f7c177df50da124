#pragma once

#include <string>

#include "reports/store/model.hpp"

namespace kappabench {

/// "not_converged" becomes "not converged".
[[nodiscard]] std::string spaced(std::string words);

/// The outcome of a cell and the warnings of its curves, each once: "converged", "not converged, long span".
[[nodiscard]] std::string outcome_words(const store::CellRecord& cell);

}  // namespace kappabench
