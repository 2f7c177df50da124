#include "schemes/api/fit.hpp"

#include <stdexcept>

namespace kappabench {

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::converged:
      return "converged";
    case Outcome::not_converged:
      return "not_converged";
    case Outcome::unsupported_input:
      return "unsupported_input";
    case Outcome::failed:
      return "failed";
    case Outcome::timed_out:
      return "timed_out";
    case Outcome::crashed:
      return "crashed";
  }
  throw std::logic_error("name(Outcome): not a value of the enumeration");
}

}  // namespace kappabench
