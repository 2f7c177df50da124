#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "schemes/numerics/interval.hpp"
#include "schemes/numerics/root_isolation.hpp"

namespace kappabench {

/// What interval arithmetic knows of a function on an interval of its argument.
struct Enclosure {
  Interval value;  ///< holds the function there
  Interval slope;  ///< holds its derivative there
  double noise;    ///< values up to this one count as zero where their sign stays open
};

using EnclosedFunction = std::function<Enclosure(const Interval&)>;

/// The sign changes on (0, 1), proved by bisection: a part where the value keeps clear of 0 has none, and one where the
/// slope does has at most one, which the signs at its ends decide (Moore 1966, ch. 7). Parts on which the function is
/// within its noise, as at a root that rounding puts on either side of an end, have no sign: what counts is whether the
/// signs before and after them differ.
/// Brackets are ascending and as narrow as the enclosures allow. nullopt if `most_parts` parts do not suffice, as where
/// the function is nearly zero throughout.
[[nodiscard]] std::optional<std::vector<RootBracket>> isolate_sign_changes(const EnclosedFunction& f,
                                                                           int most_parts = 4000);

/// Whether the function is proved to be larger than `bound` on all of [0, 1].
[[nodiscard]] bool stays_above(const EnclosedFunction& f, double bound, int most_parts = 400);

}  // namespace kappabench
