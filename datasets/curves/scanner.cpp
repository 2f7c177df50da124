#include "datasets/curves/scanner.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace kappabench {

namespace {

constexpr std::string_view blanks = " \t\r\n\f";
constexpr std::string_view digits = "0123456789";

std::size_t span_of(std::string_view text, std::string_view characters, std::size_t from = 0) {
  return std::min(text.find_first_not_of(characters, from), text.size());
}

/// The length of the number that the text starts with; 0 if it starts with none. An "e" without digits is none of it.
std::size_t number_length(std::string_view text) {
  const std::size_t start = text.empty() || (text[0] != '-' && text[0] != '+') ? 0 : 1;
  std::size_t end = span_of(text, digits, start);
  std::size_t count = end - start;
  if (end < text.size() && text[end] == '.') {
    const std::size_t after = span_of(text, digits, end + 1);
    count += after - end - 1;
    end = after;
  }
  if (count == 0) return 0;
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    std::size_t exponent = end + 1;
    if (exponent < text.size() && (text[exponent] == '-' || text[exponent] == '+')) ++exponent;
    if (const std::size_t after = span_of(text, digits, exponent); after > exponent) end = after;
  }
  return end;
}

}  // namespace

void Scanner::skip_blanks() {
  const std::string_view skipped = rest_.substr(0, span_of(rest_, blanks));
  place_.line += static_cast<std::size_t>(std::ranges::count(skipped, '\n'));
  rest_.remove_prefix(skipped.size());
}

bool Scanner::done() {
  skip_blanks();
  return rest_.empty();
}

void Scanner::skip_separator() {
  skip_blanks();
  if (take(',')) skip_blanks();
}

bool Scanner::take(char c) {
  if (peek() != c) return false;
  rest_.remove_prefix(1);
  return true;
}

std::string_view Scanner::word() {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto end = std::ranges::find_if_not(rest_, letter);
  const std::string_view found = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
  rest_.remove_prefix(found.size());
  return found;
}

bool Scanner::at_number() const { return number_length(rest_) > 0; }

double Scanner::number(std::string_view what) {
  const std::size_t length = number_length(rest_);
  if (length == 0)
    refuse(place_, fmt::format("{} where {} is needed", next(), what), "give a decimal number like -1.5e3");
  const double value = parse_number(rest_.substr(0, length), what, place_);
  rest_.remove_prefix(length);
  return value;
}

bool Scanner::flag(std::string_view what) {
  if (peek() != '0' && peek() != '1') refuse(place_, fmt::format("{} where {} is needed", next(), what), "give 0 or 1");
  const bool value = peek() == '1';
  rest_.remove_prefix(1);
  return value;
}

std::string Scanner::next() const { return rest_.empty() ? "the end" : in_quotes(rest_); }

}  // namespace kappabench
