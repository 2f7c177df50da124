#include "schemes/api/input.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace kappabench {

std::string_view name(PointType type) {
  switch (type) {
    case PointType::regular:
      return "regular";
    case PointType::cusp:
      return "cusp";
    case PointType::loop:
      return "loop";
    case PointType::inflection:
      return "inflection";
  }
  throw std::logic_error("name(PointType): not a value of the enumeration");
}

const PointOptions& Input::options_of(int i) const {
  static const PointOptions none{};
  return options.empty() ? none : options[static_cast<std::size_t>(i)];
}

double mean_chord(const Input& input) {
  const std::size_t n = input.points.size();
  if (n < 2) return 0.0;
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < n; ++i) length += (input.points[i + 1] - input.points[i]).norm();
  if (!input.closed) return length / static_cast<double>(n - 1);
  return (length + (input.points.front() - input.points.back()).norm()) / static_cast<double>(n);
}

double largest_coordinate(const Input& input) {
  double largest = 0.0;
  for (const Vec2& p : input.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

double rounding_of(const Input& input) {
  return std::max(input.known_to, std::numeric_limits<double>::epsilon() * largest_coordinate(input));
}

}  // namespace kappabench
