#include "experiments/study/tally.hpp"

#include <fmt/format.h>

namespace kappabench::study {

std::string share(double agree, double cases) {
  return fmt::format("{:.0f} of {:.0f} ({:.4g} %)", agree, cases, cases > 0.0 ? 100.0 * agree / cases : 0.0);
}

}  // namespace kappabench::study
