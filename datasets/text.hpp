#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kappabench {

// What the readers of this folder share: text in, places for messages out.

/// Where something was read. Line 0 means the file as a whole.
struct Place {
  std::string file;
  std::size_t line = 0;
};

/// Throws DataError "file:line: what; instead".
[[noreturn]] void refuse(const Place& place, std::string_view what, std::string_view instead);

/// `text` in quotation marks for a message: control characters replaced, long text shortened.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// The whole of a file ("-" is standard input) as UTF-8 text without a byte order mark. Throws DataError if it cannot
/// be read, is empty, or holds NUL bytes or anything else that is no UTF-8.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

/// How messages call a file: its path, or "standard input".
[[nodiscard]] std::string name_for_messages(const std::filesystem::path& file);

struct Line {
  std::size_t number;  ///< from 1
  std::string_view text;
};

/// The lines of `text` without their ends (LF or CR LF).
[[nodiscard]] std::vector<Line> lines_of(std::string_view text);

[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The parts between spaces and tabs.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view text);

/// The parts between `separator`s, untrimmed; n separators give n + 1 parts.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// A finite decimal number that is all of `text`, independent of the locale. `what` names it in the message.
/// Throws DataError.
[[nodiscard]] double parse_number(std::string_view text, std::string_view what, const Place& place);

/// A decimal integer from `least` to `most` that is all of `text`. Throws DataError.
[[nodiscard]] long parse_integer(std::string_view text, std::string_view what, long least, long most,
                                 const Place& place);

/// "true" or "false". Throws DataError.
[[nodiscard]] bool parse_flag(std::string_view text, std::string_view what, const Place& place);

/// The first character of `text`, which is shortened by it; nothing if that is no valid UTF-8.
[[nodiscard]] std::optional<char32_t> take_utf8(std::string_view& text);

}  // namespace kappabench
