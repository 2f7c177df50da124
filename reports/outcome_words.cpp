#include "reports/outcome_words.hpp"

#include <algorithm>

namespace kappabench {

std::string spaced(std::string words) {
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string outcome_words(const store::CellRecord& cell) {
  std::string words = cell.outcome;
  for (const auto& curve : cell.curves)
    for (const auto& warning : curve.warnings)
      if (words.find(warning.first) == std::string::npos) words += ", " + warning.first;
  return spaced(words);
}

}  // namespace kappabench
