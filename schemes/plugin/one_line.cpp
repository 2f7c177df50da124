#include "schemes/plugin/one_line.hpp"

#include <algorithm>
#include <vector>

namespace kappabench {

namespace {

/// Bytes of the UTF-8 character that the text begins with; 0 if it begins with none.
std::size_t character(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = byte(0) < 0x80 ? 1 : byte(0) < 0xC2 ? 0 : byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 4;
  if (length == 0 || length > text.size() || byte(0) > 0xF4) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  // Neither overlong forms, nor surrogates, nor beyond the last plane.
  if ((byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xED && byte(1) > 0x9F)) return 0;
  if ((byte(0) == 0xF0 && byte(1) < 0x90) || (byte(0) == 0xF4 && byte(1) > 0x8F)) return 0;
  return length;
}

bool is_control(std::string_view one) {
  const auto first = static_cast<unsigned char>(one[0]);
  return first < 0x20 || first == 0x7F || (first == 0xC2 && static_cast<unsigned char>(one[1]) < 0xA0);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

constexpr std::size_t lines_kept = 3;

}  // namespace

std::string one_line(std::string_view text, std::size_t most_bytes) {
  std::string line;
  for (text = trimmed(text); !text.empty();) {
    const std::size_t length = character(text);
    const std::string_view one = text.substr(0, std::max<std::size_t>(length, 1));
    const std::string_view shown = length == 0 ? "?" : is_control(one) ? " " : one;
    if (line.size() + shown.size() > most_bytes) return line + "...";
    line += shown;
    text.remove_prefix(one.size());
  }
  return line;
}

std::string one_line_of_tail(std::string_view text, std::size_t most_bytes) {
  std::string joined;
  std::size_t lines = 0;
  while (lines < lines_kept && !text.empty()) {
    const std::size_t stop = text.find_last_of('\n');
    const std::string line = one_line(stop == std::string_view::npos ? text : text.substr(stop + 1), most_bytes);
    text = stop == std::string_view::npos ? std::string_view{} : text.substr(0, stop);
    if (line.empty()) continue;
    if (lines > 0 && line.size() + joined.size() + 3 > most_bytes) break;
    joined = lines++ == 0 ? line : line + " / " + joined;
  }
  return joined;
}

}  // namespace kappabench
