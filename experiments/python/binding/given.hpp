#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "experiments/python/binding/fitted.hpp"
#include "schemes/api/input.hpp"

namespace kappabench::python {

/// The curves of a text of curve JSON, to be judged against `points`, which go through all of them; without any,
/// against the places of their nodes, or where there are none, against the ends of their segments. What misses these
/// points or its own claims is `not_converged`. `registry` is asked for the parameters of schemes that it knows, for
/// labels. Throws std::invalid_argument as read_curves does, and for nodes that leave out a point.
[[nodiscard]] std::vector<Fitted> given_curves(std::string_view json, std::string_view source, const Registry& registry,
                                               const std::optional<Input>& points);

/// Was the curve read? Then its scheme is but a name and cannot fit.
[[nodiscard]] bool is_given(const Scheme& scheme);

}  // namespace kappabench::python
