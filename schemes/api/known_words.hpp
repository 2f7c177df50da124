#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kappabench {

/// Those of `known` that somebody who wrote `word` may have meant: two slips away (a letter too many, too few or wrong;
/// one if there are two or three letters), or `word` is a part of it, of three letters at least. Nearest first.
[[nodiscard]] std::vector<std::string> nearest_words(std::string_view word, std::span<const std::string> known);

/// What messages say after an unknown word: "did you mean kappa? known are kappa, ekappa"; "known are ..." if nothing
/// is near.
[[nodiscard]] std::string known_words(std::string_view word, std::span<const std::string> known);

}  // namespace kappabench
