#pragma once

#include "schemes/fpc/cascade.hpp"

namespace kappabench::fpc {

/// What Algorithm 1 of Chen 2019 ended with. Its lambdas are unknowns of their own; those that the state's weights
/// stand for are the ones that it was about to take.
struct Published {
  Solution solution;
  bool singular = false;  ///< it ended without success where the linear system for the joints is singular
};

/// Algorithm 1: from lambda = 1, solve for the joints (Eq. (19)), then update lambda (Eq. (17)), at most `most` times,
/// until the residual, here with the lambdas that the joints were solved with, is within `accuracy`.
[[nodiscard]] Published iterate_published(const CubicChain& chain, int most);

}  // namespace kappabench::fpc
