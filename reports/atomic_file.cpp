#include "reports/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace kappabench {
namespace {

[[noreturn]] void fail(const std::filesystem::path& target, int reason) {
  throw FileError(fmt::format("{}: cannot be written: {} (an earlier file of that name is untouched)", target.string(),
                              std::generic_category().message(reason)));
}

/// 0, or the errno of the first call that failed.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(file) == 0 ? 0 : errno;
}

}  // namespace

void replace_file(const std::filesystem::path& target, std::string_view bytes) {
  std::filesystem::path partial = target;
  partial.replace_filename(fmt::format(".{}.partial-{}", target.filename().string(), ::getpid()));
  const int file = ::open(partial.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail(target, errno);
  int reason = write_all(file, bytes);
  if (::close(file) != 0 && reason == 0) reason = errno;  // some file systems report a full disk only here
  if (reason == 0 && ::rename(partial.c_str(), target.c_str()) != 0) reason = errno;
  if (reason != 0) {
    ::unlink(partial.c_str());
    fail(target, reason);
  }
}

}  // namespace kappabench
