#pragma once

#include <Eigen/Core>
#include <string>

#include "schemes/api/registry.hpp"

namespace kappabench {

/// What a plugin and the program must agree on to exchange C++ values, as words "name=value" with blanks between. Made
/// where it is included: each side says how it was compiled itself.
[[nodiscard]] inline std::string plugin_stamp() {
  // Raised when an interface changes in a way that no size shows.
  constexpr int interface_version = 1;
#if defined(__SANITIZE_ADDRESS__)
  const std::string sanitizer = "address";
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
  const std::string sanitizer = "address";
#else
  const std::string sanitizer = "none";
#endif
#else
  const std::string sanitizer = "none";
#endif
#ifdef _GLIBCXX_RELEASE
  const std::string library = "libstdc++-" + std::to_string(_GLIBCXX_RELEASE);
#else
  const std::string library = "other";
#endif
#ifdef __clang__
  const std::string compiler = "clang-" + std::to_string(__clang_major__);
#else
  const std::string compiler = "gcc-" + std::to_string(__GNUC__);
#endif
  const auto sizes = {sizeof(Input),  sizeof(Report),     sizeof(Curve),      sizeof(Fit),
                      sizeof(Scheme), sizeof(SchemeInfo), sizeof(Parameters), sizeof(Registry)};
  std::string stamp = "interface=" + std::to_string(interface_version) + " compiler=" + compiler +
                      " library=" + library + " eigen-alignment=" + std::to_string(EIGEN_MAX_ALIGN_BYTES) +
                      " sanitizer=" + sanitizer + " sizes=";
  for (const std::size_t size : sizes) stamp += std::to_string(size) + ",";
  return stamp;
}

}  // namespace kappabench
