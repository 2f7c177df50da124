#pragma once

#include <functional>
#include <string_view>

namespace kappabench {

/// Runs `verb` in a child process and returns its exit status; if it crashes, says so in one line that names `what`,
/// and returns ran_and_failed. For code from outside that runs in this program: a plugin that crashes takes its own fit
/// along, and not the message.
[[nodiscard]] int in_child(std::string_view what, const std::function<int()>& verb);

}  // namespace kappabench
