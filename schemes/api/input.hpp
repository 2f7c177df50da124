#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "schemes/curve/vec.hpp"

namespace kappabench {

/// Chen 2019: what the curve does at a point.
enum class PointType { regular, cusp, loop, inflection };

[[nodiscard]] std::string_view name(PointType type);

/// What a user may say about one point; a scheme reads what it knows and ignores the rest, so that one
/// drawing serves every scheme.
struct PointOptions {
  std::optional<PointType> type;
  std::optional<double> a;          ///< Miura 2022: magnitude of the curvature extremum
  std::optional<double> h;          ///< Chen 2019: shape at an inflection
  std::optional<double> alpha;      ///< Chen 2019: loop size before the point
  std::optional<double> beta;       ///< Chen 2019: loop size after the point
  std::optional<double> tangent;    ///< direction angle, radians
  std::optional<double> curvature;  ///< signed, 1/length

  [[nodiscard]] bool operator==(const PointOptions&) const = default;
};

/// A number of PointOptions: its name in files, and the value of one unit of files, where angles are in degrees.
struct PointNumber {
  std::string_view name;
  std::optional<double> PointOptions::*member;
  double file_unit = 1.0;
};

/// All of them: who reads, writes or compares point options goes through this list (and `type`).
inline constexpr std::array<PointNumber, 6> point_numbers{
    {{"a", &PointOptions::a},
     {"h", &PointOptions::h},
     {"alpha", &PointOptions::alpha},
     {"beta", &PointOptions::beta},
     {"tangent", &PointOptions::tangent, std::numbers::pi / 180.0},
     {"curvature", &PointOptions::curvature}}};
static_assert(sizeof(PointOptions) ==
                  sizeof(std::optional<PointType>) + point_numbers.size() * sizeof(std::optional<double>),
              "a member of PointOptions is missing from the list");

/// A sequence of points to interpolate, closed or open. `ids` are stable names of the points: they
/// survive insertion and erasure of others. `options` is empty (nobody said anything) or one for each point.
struct Input {
  std::vector<Vec2> points;
  bool closed = false;
  std::vector<PointOptions> options;
  std::vector<int> ids;  ///< empty means 0, 1, 2, ...
  /// A length that the coordinates are known to, if that is more than their own rounding: a drawing that was moved near
  /// the origin has rounded where it came from.
  double known_to = 0.0;

  [[nodiscard]] int size() const { return static_cast<int>(points.size()); }
  [[nodiscard]] const PointOptions& options_of(int i) const;
  [[nodiscard]] int id_of(int i) const { return ids.empty() ? i : ids[static_cast<std::size_t>(i)]; }
};

/// Mean distance between consecutive points (with the closing chord, if closed): the length to which
/// tolerances are relative. 0 for fewer than two points.
[[nodiscard]] double mean_chord(const Input& input);

/// The largest |coordinate|. 0 without points.
[[nodiscard]] double largest_coordinate(const Input& input);

/// What the coordinates are rounded to, a length: one unit in the last place of the largest, or `known_to`.
[[nodiscard]] double rounding_of(const Input& input);

}  // namespace kappabench
