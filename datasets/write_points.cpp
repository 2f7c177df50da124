#include "datasets/write_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "datasets/fields.hpp"

namespace kappabench {
namespace {

std::string digits(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("write_points: a number is not finite; give finite numbers");
  return fmt::format("{:.17g}", value);
}

/// The file's number for `value`: the neighbour of value / unit that the reader maps back to `value`, if there is one.
double in_file_units(double value, double unit) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double near = value / unit;
  for (const double candidate : {near, std::nextafter(near, -infinity), std::nextafter(near, infinity)}) {
    if (candidate * unit == value) return candidate;
  }
  return near;
}

void write_metadata(std::ostream& out, const Drawing& drawing) {
  for (const auto& [key, member] : metadata_keys) {
    std::string value = drawing.*member;
    std::ranges::replace_if(
        value, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    if (!value.empty()) out << "# " << key << ": " << value << '\n';
  }
}

void write_options(std::ostream& out, const PointOptions& options) {
  if (options.type) out << " type=" << name(*options.type);
  for (const PointNumber& number : point_numbers)
    if (const auto& value = options.*number.member)
      out << ' ' << number.name << '=' << digits(in_file_units(*value, number.file_unit));
}

void write_curve(std::ostream& out, const Input& curve) {
  if (curve.points.empty()) throw std::invalid_argument("write_points: a curve without points; give at least one");
  out << (curve.closed ? "closed\n" : "open\n");
  for (int i = 0; i < curve.size(); ++i) {
    const Vec2& point = curve.points[static_cast<std::size_t>(i)];
    out << digits(point.x()) << ' ' << digits(point.y());
    if (!curve.options.empty()) write_options(out, curve.options[static_cast<std::size_t>(i)]);
    out << '\n';
  }
}

}  // namespace

void write_points(std::ostream& out, const Drawing& drawing) {
  write_metadata(out, drawing);
  for (std::size_t i = 0; i < drawing.curves.size(); ++i) {
    if (i > 0) out << '\n';
    write_curve(out, drawing.curves[i]);
  }
}

}  // namespace kappabench
