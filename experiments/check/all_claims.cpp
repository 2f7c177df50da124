#include "experiments/check/all_claims.hpp"

namespace kappabench::check {

std::vector<Claim> all_claims() {
  return {solves_claim(),   outcome_claim(),      points_claim(),   interpolation_claim(), continuity_claim(),
          jets_claim(),     marks_claim(),        locality_claim(), similarity_claim(),    mirror_claim(),
          reversal_claim(), cyclic_shift_claim(), far_claim(),      determinism_claim(),   threads_claim(),
          refit_claim(),    hermite_claim(),      growth_claim()};
}

}  // namespace kappabench::check
