#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <optional>
#include <vector>

#include "schemes/numerics/binary_form.hpp"
#include "schemes/numerics/bounded.hpp"

namespace kappabench {

/// Certified isolation of the sign changes of a polynomial on the open interval (0, 1), by Descartes' rule and
/// bisection (Vincent, Collins and Akritas): no sign change among the coefficients means no root, one means exactly
/// one.

using Integer = boost::multiprecision::cpp_int;

/// Parameters between which lies exactly one sign change; lo == hi for one that is known exactly.
struct RootBracket {
  double lo;
  double hi;

  [[nodiscard]] double mid() const { return 0.5 * (lo + hi); }
};

/// In double precision with rigorous rounding bounds. nullopt when rounding leaves the answer open: multiple or
/// nearly multiple roots, a root at or very near 0, 1 or a bisection point, a zero polynomial.
/// Otherwise the brackets are certain, ascending and as narrow as the bounds allow (usually a few 1e-16).
[[nodiscard]] std::optional<std::vector<RootBracket>> isolate_sign_changes(const BinaryForm<Bounded>& form);

/// In exact arithmetic: always decides. Roots of even multiplicity are no sign changes and are left out, those of odd
/// multiplicity count once. Brackets are ascending, and at most 1e-15 wide unless two roots are closer than that.
/// The zero polynomial has none.
[[nodiscard]] std::vector<RootBracket> isolate_sign_changes(const BinaryForm<Integer>& form);

/// The product of the square-free factors of odd multiplicity, with its content removed: it changes sign exactly where
/// `form` does in (0, 1). Roots at 0 and 1 are divided out. Empty for the zero polynomial.
[[nodiscard]] BinaryForm<Integer> odd_part(const BinaryForm<Integer>& form);

}  // namespace kappabench
