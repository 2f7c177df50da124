#include "experiments/python/binding/fitted.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace kappabench::python {

const Curve& curve_in(const Fitted& fitted) {
  if (!fitted.fit.curve)
    throw std::invalid_argument(
        fmt::format("no curve: {}; {}", name(fitted.fit.report.outcome), fitted.fit.report.message));
  return *fitted.fit.curve;
}

}  // namespace kappabench::python
