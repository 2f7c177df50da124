#pragma once

#include <cstdint>

#include "experiments/papers/intrinsic-2022-yoshida/inputs.hpp"
#include "reports/store/model.hpp"

namespace kappabench::yoshida {

/// The automatic family on random G2 data: viable ones of every kind, which it must solve, and others, which it must
/// refuse.

/// Data number `from` to `to` - 1 of a kind: sums, a row for every failure, and the time of each solution ("solve").
void measure_kind(Kind kind, std::uint64_t seed, long from, long to, store::CellRecord& cell);

/// Data outside the viable region: refused? And does any family of Fig. 6 find a monotone curve?
void measure_infeasible(std::uint64_t seed, long n, store::CellRecord& cell);

/// Of the cells of kinds, whose dataset is the kind's name.
[[nodiscard]] store::TableRecord kind_table(const store::ExperimentRecord& record);
[[nodiscard]] store::TableRecord kind_seconds_table(const store::ExperimentRecord& record);
[[nodiscard]] store::TableRecord kind_failure_table(const store::ExperimentRecord& record);

}  // namespace kappabench::yoshida
