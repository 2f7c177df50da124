#include "datasets/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace kappabench {
namespace {

void refuse_repeated(std::string_view key, const Place& place) {
  refuse(place, fmt::format("{} is given twice", key), "give it once");
}

}  // namespace

std::string point_keys_text() {
  std::string text = "type";
  for (const PointNumber& number : point_numbers) text += fmt::format(", {}", number.name);
  return text;
}

const PointNumber* find_number_key(std::string_view key) {
  const auto found = std::ranges::find(point_numbers, key, &PointNumber::name);
  return found == point_numbers.end() ? nullptr : &*found;
}

PointType parse_type(std::string_view text, const Place& place) {
  for (const PointType type : {PointType::regular, PointType::cusp, PointType::loop, PointType::inflection}) {
    if (text == name(type)) return type;
  }
  refuse(place, fmt::format("type = {} is unknown", in_quotes(text)), "give regular, cusp, loop or inflection");
}

void set_option(PointOptions& options, std::string_view key, std::string_view value, const Place& place) {
  if (key == "type") {
    if (options.type) refuse_repeated(key, place);
    options.type = parse_type(value, place);
    return;
  }
  const PointNumber* number = find_number_key(key);
  if (number == nullptr) {
    refuse(place, fmt::format("unknown key {}", in_quotes(key)), fmt::format("known are {}", point_keys_text()));
  }
  std::optional<double>& target = options.*(number->member);
  if (target) refuse_repeated(key, place);
  target = parse_number(value, key, place) * number->file_unit;
}

MetadataMember find_metadata(std::string_view key) {
  for (const auto& [known, member] : metadata_keys) {
    if (known == key) return member;
  }
  return nullptr;
}

void set_metadata(Drawing& drawing, std::string_view key, std::string_view value, const Place& place) {
  const MetadataMember member = find_metadata(key);
  if (member == nullptr) throw std::logic_error(fmt::format("set_metadata: '{}' is no key of metadata", key));
  std::string& target = drawing.*member;
  if (!target.empty()) refuse_repeated(key, place);
  if (key == "stands-in-for" && value == "-") return;
  target = value;
}

void read_metadata_comment(Drawing& drawing, std::string_view comment, const Place& place) {
  comment.remove_prefix(1);
  const std::size_t colon = comment.find(':');
  if (colon == comment.npos) return;
  const std::string_view key = trimmed(comment.substr(0, colon));
  if (find_metadata(key) != nullptr) set_metadata(drawing, key, trimmed(comment.substr(colon + 1)), place);
}

void drop_unsaid_options(Input& curve) {
  if (std::ranges::all_of(curve.options, [](const PointOptions& o) { return o == PointOptions{}; })) {
    curve.options.clear();
  }
}

}  // namespace kappabench
