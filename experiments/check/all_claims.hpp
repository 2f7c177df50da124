#pragma once

#include <vector>

#include "experiments/check/claim.hpp"

namespace kappabench::check {

// One file each, or one a family.
[[nodiscard]] Claim solves_claim();
[[nodiscard]] Claim outcome_claim();
[[nodiscard]] Claim points_claim();
[[nodiscard]] Claim interpolation_claim();
[[nodiscard]] Claim continuity_claim();
[[nodiscard]] Claim jets_claim();
[[nodiscard]] Claim marks_claim();
[[nodiscard]] Claim locality_claim();
[[nodiscard]] Claim similarity_claim();
[[nodiscard]] Claim mirror_claim();
[[nodiscard]] Claim reversal_claim();
[[nodiscard]] Claim cyclic_shift_claim();
[[nodiscard]] Claim far_claim();
[[nodiscard]] Claim determinism_claim();
[[nodiscard]] Claim threads_claim();
[[nodiscard]] Claim refit_claim();
[[nodiscard]] Claim hermite_claim();
[[nodiscard]] Claim growth_claim();

/// All of them, in the order of the page.
[[nodiscard]] std::vector<Claim> all_claims();

}  // namespace kappabench::check
