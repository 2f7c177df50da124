#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "experiments/program/scratch_folder.hpp"
#include "tests/catch.hpp"

namespace kappabench::test {

inline std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct Ran {
  int status;
  std::string out, err;
};

/// Runs `kappabench <arguments>` in `folder` through the shell.
inline Ran run(const ScratchFolder& folder, const std::string& arguments) {
  const auto out = folder.path() / "stdout", err = folder.path() / "stderr";
  const std::string command = "cd '" + folder.path().string() + "' && '" KAPPABENCH_PROGRAM "' " + arguments + " >'" +
                              out.string() + "' 2>'" + err.string() + "'";
  const int status = std::system(command.c_str());
  return {WEXITSTATUS(status), contents(out), contents(err)};
}

inline void write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

/// Exit status 2 and a single line on stderr that holds `what`.
inline void refused(const Ran& ran, const std::string& what) {
  CHECK(ran.status == 2);
  CHECK_THAT(ran.err, ContainsSubstring(what));
  CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
}

}  // namespace kappabench::test
