#include "experiments/study/verdicts.hpp"

#include <fmt/format.h>

#include <utility>

namespace kappabench::study {

std::string share(double agree, double cases) {
  return fmt::format("{:.0f} of {:.0f} ({:.4g} %)", agree, cases, cases > 0.0 ? 100.0 * agree / cases : 0.0);
}

std::string verdict_for_one(bool there, bool holds) {
  return !there ? "not reproduced" : holds ? "reproduced" : "contradicted";
}

std::string verdict_for_all(double counterexamples, double cases) {
  if (!(cases > 0.0)) return "not reproduced";
  return counterexamples > 0.0 ? "contradicted" : "reproduced";
}

std::string verdict_in_general(double agree, double cases) {
  if (!(cases > 0.0)) return "not reproduced";
  return agree >= 0.95 * cases ? "reproduced" : agree < 0.5 * cases ? "contradicted" : "not reproduced";
}

std::string verdict_often(double agree, double cases) {
  if (!(cases > 0.0)) return "not reproduced";
  return 3.0 * agree >= 2.0 * cases ? "reproduced" : 2.0 * agree < cases ? "contradicted" : "not reproduced";
}

}  // namespace kappabench::study
