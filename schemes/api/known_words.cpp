#include "schemes/api/known_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace kappabench {

namespace {

/// Levenshtein's distance: how many characters to insert, erase or replace.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::vector<std::string> nearest_words(std::string_view word, std::span<const std::string> known) {
  constexpr std::size_t letters_a_slip = 2, most_slips = 2, longest = 64, shortest_part = 3;
  if (word.size() > longest) return {};
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    const bool slip = distance <= std::min(most_slips, std::max(word.size(), candidate.size()) / letters_a_slip);
    const bool part = word.size() >= shortest_part && candidate.find(word) != std::string::npos;
    if (slip || part) near.emplace_back(distance, candidate);
  }
  std::ranges::stable_sort(near, {}, &std::pair<std::size_t, std::string>::first);
  std::vector<std::string> words;
  words.reserve(near.size());
  for (auto& [distance, candidate] : near) words.push_back(std::move(candidate));
  return words;
}

std::string known_words(std::string_view word, std::span<const std::string> known) {
  const std::vector<std::string> near = nearest_words(word, known);
  const std::string hint = near.empty() ? "" : fmt::format("did you mean {}? ", fmt::join(near, " or "));
  return fmt::format("{}known are {}", hint, fmt::join(known, ", "));
}

}  // namespace kappabench
