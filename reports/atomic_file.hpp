#pragma once

#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace kappabench {

/// A file that could not be written; what() is one line with the file and the system's reason.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Puts `bytes` into `target` so that a reader sees the earlier file or the whole new one, never a part: written
/// under a temporary name in the same folder, flushed to the disk, renamed. The folder must exist.
/// Throws FileError (no such folder, no permission, full disk); the earlier file is then as it was and the
/// temporary one is gone.
void replace_file(const std::filesystem::path& target, std::string_view bytes);

}  // namespace kappabench
