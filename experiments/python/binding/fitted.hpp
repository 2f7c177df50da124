#pragma once

#include "schemes/api/registry.hpp"

namespace kappabench::python {

/// A scheme with its parameters chosen, as Python holds it.
struct ChosenScheme {
  SchemePtr scheme;
};

/// A fit with the scheme that made it: what a `Curve` of Python holds.
struct Fitted {
  SchemePtr scheme;
  Fit fit;
};

/// The curve; throws std::invalid_argument with one line, "no curve: failed; ...", if there is none.
[[nodiscard]] const Curve& curve_in(const Fitted& fitted);

}  // namespace kappabench::python
