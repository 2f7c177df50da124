#pragma once

#include <string_view>

#include "datasets/drawing.hpp"

namespace kappabench {

// The readers behind read_drawing: text of one format into curves and metadata, the id left to the caller. `file` is
// what messages call the source. All throw DataError and are strict: what they do not know, they refuse. How many
// points a curve needs, and whether coincident ones are allowed, is for the schemes to say.

/// `#` comments (leading "# title: ..." and the other metadata keys), then for each curve an optional line `open`
/// (the default) or `closed` and a line "x y [key=value ...]" for each point. A blank line ends a curve.
[[nodiscard]] Drawing parse_plain(std::string_view text, std::string_view file);

/// The format of the authors of the epsilon-kappa paper: the number of closed curves, for each a count N and N lines
/// "x y"; then the number of open curves, laid out alike.
[[nodiscard]] Drawing parse_pts(std::string_view text, std::string_view file);

/// Columns as spreadsheets write them: separated by commas, semicolons or tabs (the first line tells; with the latter
/// two a comma is a decimal point), in quotes where need be, with empty cells at the end or not. Two columns x, y
/// without a header; or a header, in letters of any case, which may also be the comment before the first row: x, y and
/// any of curve, closed and the keys of a point. Other columns are ignored. A curve ends where the `curve` column
/// changes. Leading `#` comments as in plain text.
[[nodiscard]] Drawing parse_csv(std::string_view text, std::string_view file);

/// Metadata keys at the top and [[curve]] tables with `closed` and `points`, each [x, y] or {x = .., y = .., key = ..}.
[[nodiscard]] Drawing parse_toml(std::string_view text, std::string_view file);

}  // namespace kappabench
