#include "experiments/program/write_file.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>

#include "experiments/program/errors.hpp"
#include "reports/atomic_file.hpp"

namespace kappabench {

void write_file(const std::filesystem::path& file, std::string_view text) {
  std::error_code error;
  if (file.empty()) {
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (!written) throw UsageError("standard output cannot be written; is the disk full?");
  } else if (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error)) {
    // A device or a pipe cannot be replaced.
    std::ofstream stream(file, std::ios::binary);
    if (!(stream << text << std::flush)) throw UsageError(fmt::format("{}: cannot be written", file.string()));
  } else {
    replace_file(file, text);
  }
}

}  // namespace kappabench
