#pragma once

#include <map>
#include <string>

#include "schemes/api/registry.hpp"

namespace kappabench {

/// Where results come from: when and by which command, commit and whether the tree had changes, compiler and flags,
/// versions of all libraries, operating system, processor and its threads. Part of every results file and of no cell's
/// key: "date" and "command" alone differ between runs of one program on one machine.
[[nodiscard]] std::map<std::string, std::string> provenance(const Registry& registry);

/// "kappabench 0.1.0, commit 0123abcd", with a word if the tree had changes.
[[nodiscard]] std::string version_text();

}  // namespace kappabench
