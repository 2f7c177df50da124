#pragma once

#include <cerrno>
#include <cstdlib>  // with it comes POSIX's mkdtemp
#include <filesystem>
#include <string>
#include <system_error>

namespace kappabench {

/// A new, empty folder in the system's place for temporary files, gone with the object.
class ScratchFolder {
 public:
  /// Throws std::filesystem::filesystem_error when none can be made.
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "kappabench-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw std::filesystem::filesystem_error("no temporary folder", name, {errno, std::generic_category()});
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace kappabench
