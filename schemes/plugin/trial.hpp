#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace kappabench {

/// Runs `work` in a child process and returns what it returned, or what became of the child: "crashed while it was
/// tried (Segmentation fault)", "took longer than 20 s". Nothing that `work` does changes this process.
[[nodiscard]] std::string trial(std::chrono::seconds most, const std::function<std::string()>& work);

}  // namespace kappabench
