#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "datasets/drawing.hpp"
#include "datasets/text.hpp"

namespace kappabench {

// The keys that the formats have in common.

/// For messages: every key of a point.
[[nodiscard]] std::string point_keys_text();

/// The numeric key of a point, as in files; nullptr if there is no such key.
[[nodiscard]] const PointNumber* find_number_key(std::string_view key);

/// Throws DataError unless `text` names a PointType.
[[nodiscard]] PointType parse_type(std::string_view text, const Place& place);

/// Reads "key=value" or a named cell into `options`. Throws DataError on an unknown or repeated key or a bad value.
void set_option(PointOptions& options, std::string_view key, std::string_view value, const Place& place);

/// The metadata of a drawing under its names in files.
using MetadataMember = std::string Drawing::*;
inline constexpr std::array<std::pair<std::string_view, MetadataMember>, 5> metadata_keys{
    {{"title", &Drawing::title},
     {"stands-in-for", &Drawing::stands_in_for},
     {"source", &Drawing::source},
     {"licence", &Drawing::licence},
     {"units", &Drawing::units}}};

/// nullptr if there is no such key.
[[nodiscard]] MetadataMember find_metadata(std::string_view key);

/// Sets a key that find_metadata knows; the value "-" of stands-in-for means none. Throws DataError if it is set
/// already.
void set_metadata(Drawing& drawing, std::string_view key, std::string_view value, const Place& place);

/// Reads a comment line "# key: value" if its key is one of the metadata keys; any other comment is for people.
void read_metadata_comment(Drawing& drawing, std::string_view comment, const Place& place);

/// Ends a curve whose reader pushed options for every point: without any said, Input wants them empty.
void drop_unsaid_options(Input& curve);

}  // namespace kappabench
