#pragma once

#include "experiments/papers/intrinsic-2022-yoshida/inputs.hpp"
#include "experiments/run/uses.hpp"
#include "experiments/study/findings.hpp"
#include "experiments/study/notes.hpp"

namespace kappabench::yoshida {

/// The automatic family on random G2 data: viable ones of every kind, which it must solve, and others, which it must
/// refuse.

/// Sums over the data of a cell, for they can be very many.
inline const study::Quantity kind_data = study::count_of("data"), kind_monotone = study::count_of("monotone");
/// Of data outside the region.
inline const study::Quantity infeasible = study::count_of("infeasible"),
                             infeasible_refused = study::count_of("infeasible refused"),
                             infeasible_monotone = study::count_of("infeasible with a monotone curve");

/// Data number `from` to `to` - 1 of the `kind` in `uses`: sums, a row for every failure, and the time of each solution
/// ("solve").
void measure_kind(const Uses& uses, study::Notes& notes);

/// `data` data outside the viable region: refused? And does any family of Fig. 6 find a monotone curve?
void measure_infeasible(const Uses& uses, study::Notes& notes);

/// Of the cells of kinds, whose dataset is the kind's name.
[[nodiscard]] study::Table kind_table(const study::Findings& found);
[[nodiscard]] study::Table kind_seconds_table(const study::Findings& found);
[[nodiscard]] study::Table kind_failure_table(const study::Findings& found);

}  // namespace kappabench::yoshida
