#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace kappabench {

/// A digest of the bytes of files, in this order: 16 hexadecimal digits that change when a file does. No protection
/// against somebody who wants two files to look alike. Throws std::runtime_error if one cannot be read.
[[nodiscard]] std::string digest_of_files(std::span<const std::filesystem::path> files);

}  // namespace kappabench
