#pragma once

#include <string>
#include <vector>

#include "schemes/api/scheme.hpp"

namespace kappabench::check {

/// An input to try, and how a person gets it.
struct Case {
  std::string name;    ///< in words: "random:star:n=5,seed=1,closed=true", "bird, curve 2", "..., point 3 moved"
  std::string points;  ///< what the command line calls it; empty if only its coordinates say it
  Input input;
};

/// "random:star:n=5,seed=1,closed=true" as the command line knows it.
[[nodiscard]] Case random_star(int n, int seed, bool closed);

/// What every scheme should solve: random stars and walks of 5 to 24 points, the shortest first, open and closed as the
/// traits say.
[[nodiscard]] std::vector<Case> benign_cases(const SchemeTraits& traits);

/// The curves of the built-in drawings of up to 64 points, the shortest first.
[[nodiscard]] std::vector<Case> drawn_cases(const SchemeTraits& traits);

/// Degenerate and hostile inputs: no points, NaN, coincident, folded back, legs of 1e-12 beside legs of 1e12, ...
[[nodiscard]] std::vector<Case> hostile_cases();

/// The same name with more words, and another input.
[[nodiscard]] Case changed(const Case& from, const std::string& how, Input input);

/// A line for the shell that fits the case with `scheme`, "ID[:key=value,...]".
[[nodiscard]] std::string fit_command(const Case& shown, const std::string& scheme);

}  // namespace kappabench::check
