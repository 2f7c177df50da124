#include "datasets/curves/transform.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "datasets/curves/scanner.hpp"
#include "schemes/curve/vec.hpp"

namespace kappabench {

namespace {

using Arguments = std::vector<double>;

/// x, y become a x + c y + e, b x + d y + f.
AffineMap matrix(double a, double b, double c, double d, double e, double f) {
  AffineMap map = AffineMap::Identity();
  map.linear() << a, c, b, d;
  map.translation() << e, f;
  return map;
}

AffineMap translation(double x, double y) { return matrix(1.0, 0.0, 0.0, 1.0, x, y); }

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// Quarter turns are exact: what is upright stays so.
AffineMap rotation(double degrees) {
  const double turns = std::remainder(degrees, 360.0) / 90.0;
  if (turns == std::round(turns)) {
    constexpr std::array<double, 4> cosines{1.0, 0.0, -1.0, 0.0}, sines{0.0, 1.0, 0.0, -1.0};
    const auto i = static_cast<std::size_t>(static_cast<int>(turns) + 4) % 4;
    return matrix(cosines[i], sines[i], -sines[i], cosines[i], 0.0, 0.0);
  }
  const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
  return matrix(c, s, -s, c, 0.0, 0.0);
}

/// A kind of transform: its name, how many numbers it takes, and what they mean.
struct Kind {
  std::string_view name, numbers;
  bool (*takes)(std::size_t count);
  AffineMap (*map)(const Arguments& a);
};

const std::array<Kind, 6> kinds{{
    {"matrix", "6", [](std::size_t n) { return n == 6; },
     [](const Arguments& a) { return matrix(a[0], a[1], a[2], a[3], a[4], a[5]); }},
    {"translate", "1 or 2", [](std::size_t n) { return n == 1 || n == 2; },
     [](const Arguments& a) { return translation(a[0], a.size() == 2 ? a[1] : 0.0); }},
    {"scale", "1 or 2", [](std::size_t n) { return n == 1 || n == 2; },
     [](const Arguments& a) { return matrix(a[0], 0.0, 0.0, a.back(), 0.0, 0.0); }},
    {"rotate", "1 or 3", [](std::size_t n) { return n == 1 || n == 3; },
     [](const Arguments& a) {
       if (a.size() == 1) return rotation(a[0]);
       return AffineMap(translation(a[1], a[2]) * rotation(a[0]) * translation(-a[1], -a[2]));
     }},
    {"skewX", "1", [](std::size_t n) { return n == 1; },
     [](const Arguments& a) { return matrix(1.0, 0.0, std::tan(radians(a[0])), 1.0, 0.0, 0.0); }},
    {"skewY", "1", [](std::size_t n) { return n == 1; },
     [](const Arguments& a) { return matrix(1.0, std::tan(radians(a[0])), 0.0, 1.0, 0.0, 0.0); }},
}};

const Kind& kind_of(Scanner& scanner) {
  const Place place = scanner.place();
  const std::string shown = scanner.next();
  const std::string_view name = scanner.word();
  for (const Kind& kind : kinds)
    if (kind.name == name) return kind;
  refuse(place, fmt::format("{} is no transform", shown), "known are matrix, translate, scale, rotate, skewX, skewY");
}

AffineMap next_map(Scanner& scanner) {
  const Kind& kind = kind_of(scanner);
  const Place place = scanner.place();
  (void)scanner.done();
  if (!scanner.take('(')) refuse(place, fmt::format("{} without (", kind.name), "write it like translate(10 20)");
  constexpr std::size_t most = 6;
  Arguments numbers;
  while (!scanner.done() && scanner.peek() != ')' && numbers.size() <= most) {
    numbers.push_back(scanner.number(kind.name));
    scanner.skip_separator();
  }
  if (!kind.takes(numbers.size()))
    refuse(place, fmt::format("{} of {} numbers", kind.name, numbers.size()),
           fmt::format("{} takes {}", kind.name, kind.numbers));
  if (!scanner.take(')')) refuse(place, fmt::format("{} without )", kind.name), "write it like translate(10 20)");
  return kind.map(numbers);
}

}  // namespace

AffineMap parse_transform(std::string_view text, const Place& place) {
  AffineMap map = AffineMap::Identity();
  if (trimmed(text) == "none") return map;  // CSS's word for it
  Scanner scanner(text, place);
  for (scanner.skip_separator(); !scanner.done(); scanner.skip_separator()) map = map * next_map(scanner);
  if (!map.matrix().allFinite())
    refuse(place, fmt::format("transform {} is not finite", in_quotes(text)), "give numbers of usual size");
  return map;
}

}  // namespace kappabench
