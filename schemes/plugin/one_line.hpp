#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace kappabench {

/// Text from outside made fit for a message: one line, at most `most_bytes` of it, without control characters; bytes
/// that are not UTF-8 are '?'. What is cut off is "...".
[[nodiscard]] std::string one_line(std::string_view text, std::size_t most_bytes = 400);

/// The last lines of a text, those that are not blank, as one: "Traceback / ValueError: no such option".
[[nodiscard]] std::string one_line_of_tail(std::string_view text, std::size_t most_bytes = 400);

}  // namespace kappabench
