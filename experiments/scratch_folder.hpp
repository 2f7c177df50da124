#pragma once

#include <filesystem>

namespace kappabench {

/// A new, empty folder in the system's place for temporary files, gone with the object.
class ScratchFolder {
 public:
  /// Throws std::filesystem::filesystem_error when none can be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace kappabench
