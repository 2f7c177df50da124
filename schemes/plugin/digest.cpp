#include "schemes/plugin/digest.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <stdexcept>

namespace kappabench {

std::string digest_of_files(std::span<const std::filesystem::path> files) {
  std::uint64_t state = 0xcbf29ce484222325ULL;  // FNV-1a
  const auto add = [&state](std::string_view bytes) {
    for (const char c : bytes) state = (state ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  };
  for (const std::filesystem::path& file : files) {
    std::ifstream stream(file, std::ios::binary);
    std::array<char, 65536> buffer{};
    std::uintmax_t size = 0;
    while (stream.read(buffer.data(), buffer.size()) || stream.gcount() > 0) {
      add({buffer.data(), static_cast<std::size_t>(stream.gcount())});
      size += static_cast<std::uintmax_t>(stream.gcount());
    }
    if (stream.bad() || !stream.eof()) throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
    add(fmt::format("{} bytes\n", size));  // so that no byte moves from one file to the next unseen
  }
  return fmt::format("{:016x}", state);
}

}  // namespace kappabench
