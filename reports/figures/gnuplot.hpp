#pragma once

#include <filesystem>
#include <string>

namespace kappabench {

/// How a run of gnuplot went; `problem` is one line, empty when all is well.
struct Rendering {
  bool installed = true;
  std::string problem;
};

/// Runs `program script` inside `folder` as a child process, for at most a minute, with nothing on its output.
/// Anything gnuplot says on its error output counts as a problem. Never throws for what the child does.
[[nodiscard]] Rendering run_gnuplot(const std::filesystem::path& folder, const std::string& script,
                                    const std::string& program = "gnuplot");

/// "5.4.4": what the program says of itself when it is run in `folder`; empty if it says nothing.
[[nodiscard]] std::string gnuplot_version(const std::filesystem::path& folder, const std::string& program = "gnuplot");

}  // namespace kappabench
