#include "datasets/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iostream>

#include "datasets/datasets.hpp"

namespace kappabench {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

std::string all_of(std::istream& in, const Place& place) {
  std::string text;
  std::array<char, 1 << 16> block;
  while (in.read(block.data(), block.size()) || in.gcount() > 0) {
    const std::string_view part(block.data(), static_cast<std::size_t>(in.gcount()));
    text += part;
    // A NUL byte already decides that this is no text: do not read an endless device to its end.
    if (part.find('\0') != part.npos) break;
  }
  if (in.bad()) refuse(place, "reading failed", "check the file and the disk");
  return text;
}

void check_utf8(std::string_view text, Place place) {
  for (const Line& line : lines_of(text)) {
    place.line = line.number;
    std::string_view rest = line.text;
    while (!rest.empty()) {
      const auto character = take_utf8(rest);
      if (!character) refuse(place, "not UTF-8", "points are read from UTF-8 text, not from binary files");
      if (*character == 0) refuse(place, "a NUL byte", "points are read from UTF-8 text, not from binary files");
    }
  }
}

std::string_view without_plus(std::string_view text) {
  return text.size() > 1 && text[0] == '+' && text[1] != '-' ? text.substr(1) : text;
}

}  // namespace

void refuse(const Place& place, std::string_view what, std::string_view instead) {
  const std::string line = place.line == 0 ? "" : fmt::format(":{}", place.line);
  std::string message = fmt::format("{}{}: {}; {}", place.file, line, what, instead);
  // One line whatever was quoted: a path or the words of a library may have line breaks.
  std::ranges::replace_if(
      message, [](char c) { return c >= 0 && c < ' '; }, ' ');
  throw DataError(message);
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string shown;
  std::string_view rest = text;
  while (!rest.empty() && shown.size() < longest) {
    const std::string_view before = rest;
    const auto character = take_utf8(rest);
    if (!character) rest.remove_prefix(1);
    const bool printable = character && *character >= 0x20 && *character != 0x7f;
    shown += printable ? before.substr(0, before.size() - rest.size()) : "?";
  }
  return fmt::format("\"{}{}\"", shown, rest.empty() ? "" : "...");
}

std::string name_for_messages(const std::filesystem::path& file) {
  return file == "-" ? "standard input" : file.string();
}

std::string read_text(const std::filesystem::path& file) {
  const Place place{name_for_messages(file), 0};
  std::string text;
  if (file == "-") {
    text = all_of(std::cin, place);
  } else {
    std::error_code error;
    if (std::filesystem::is_directory(file, error)) refuse(place, "a folder", "name a file");
    std::ifstream in(file, std::ios::binary);
    if (!in) {
      refuse(place, fmt::format("cannot be opened ({})", std::strerror(errno)), "name a file that can be read");
    }
    text = all_of(in, place);
  }
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  check_utf8(text, place);
  if (text.find_first_not_of(" \t\r\n\v\f") == text.npos) refuse(place, "empty", "at least one point is needed");
  return text;
}

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  std::size_t number = 1;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back({number++, line});
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t end = std::min(text.find_first_of(blanks), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return words;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(separator); end != text.npos; end = text.find(separator)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

double parse_number(std::string_view text, std::string_view what, const Place& place) {
  const std::string_view digits = without_plus(text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) {
    refuse(place, fmt::format("{} = {} does not fit a double", what, in_quotes(text)), "give a number of usual size");
  }
  if (error != std::errc{} || end != digits.data() + digits.size()) {
    refuse(place, fmt::format("{} = {} is not a number", what, in_quotes(text)), "give a decimal number like -1.5e3");
  }
  if (!std::isfinite(value)) {
    refuse(place, fmt::format("{} = {} is not finite", what, in_quotes(text)), "give a finite number");
  }
  return value;
}

long parse_integer(std::string_view text, std::string_view what, long least, long most, const Place& place) {
  const std::string_view digits = without_plus(text);
  long value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool whole = error == std::errc{} && end == digits.data() + digits.size();
  if (!whole || value < least || value > most) {
    refuse(place, fmt::format("{} = {}", what, in_quotes(text)),
           fmt::format("give an integer from {} to {}", least, most));
  }
  return value;
}

bool parse_flag(std::string_view text, std::string_view what, const Place& place) {
  if (text == "true") return true;
  if (text == "false") return false;
  refuse(place, fmt::format("{} = {}", what, in_quotes(text)), "give true or false");
}

std::optional<char32_t> take_utf8(std::string_view& text) {
  if (text.empty()) return std::nullopt;
  const auto lead = static_cast<unsigned char>(text[0]);
  // The number of bytes is in the leading ones of the first; RFC 3629 ends at U+10FFFF and has no surrogates.
  const std::size_t length = lead < 0x80 ? 1 : lead >= 0xF0 && lead < 0xF5 ? 4 : lead >= 0xE0 ? 3 : 2;
  if ((lead >= 0x80 && lead < 0xC2) || lead > 0xF4 || text.size() < length) return std::nullopt;
  char32_t character = length == 1 ? lead : lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0U) != 0x80U) return std::nullopt;
    character = (character << 6U) | (next & 0x3FU);
  }
  constexpr std::array<char32_t, 5> shortest{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = character >= 0xD800 && character < 0xE000;
  if (character < shortest[length] || surrogate || character > 0x10FFFF) return std::nullopt;
  text.remove_prefix(length);
  return character;
}

}  // namespace kappabench
