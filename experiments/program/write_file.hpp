#pragma once

#include <filesystem>
#include <string_view>

namespace kappabench {

/// Writes `text` to standard output if `file` is empty, to a device or pipe as it is, and otherwise so that an
/// earlier file is whole until the new one is. Throws UsageError or FileError when it cannot be written.
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace kappabench
