#pragma once

#include <map>
#include <string>

namespace kappabench {

/// Where results come from: commit and whether the tree had changes, compiler and flags, versions of the libraries,
/// processor and its threads. Part of every results file.
[[nodiscard]] std::map<std::string, std::string> provenance();

}  // namespace kappabench
