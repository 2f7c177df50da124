#include "datasets/random_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "datasets/key_values.hpp"
#include "datasets/random_source.hpp"

namespace kappabench {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

using Points = std::vector<Vec2>;

Vec2 polar(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

/// Radius of the circle on which n points are about 1 apart.
double unit_chord_radius(int n) { return std::max(1.0, n / turn); }

Points walk(RandomSource& random, int n, bool closed) {
  Points points;
  Vec2 at = Vec2::Zero();
  double angle = random.uniform(0.0, turn);
  for (int i = 0; i < n; ++i) {
    points.push_back(at);
    at += polar(random.uniform(0.5, 1.5), angle);
    angle += 0.6 * random.normal();
  }
  if (closed) {
    for (int i = 0; i < n; ++i) points[static_cast<std::size_t>(i)] -= at * (static_cast<double>(i) / n);
  }
  return points;
}

Points star(RandomSource& random, int n, bool /*closed*/) {
  const double radius = unit_chord_radius(n);
  Points points;
  for (int i = 0; i < n; ++i) {
    const double angle = turn * (i + random.uniform(-0.3, 0.3)) / n;
    points.push_back(polar(radius + random.uniform(-0.7, 0.7), angle));
  }
  return points;
}

Points zigzag(RandomSource& random, int n, bool closed) {
  const double step = 0.5;
  const double radius = 1.5 + step * n / turn;
  Points points;
  for (int i = 0; i < n; ++i) {
    const double along = step * (i + random.uniform(-0.3, 0.3));
    const double across = (i % 2 == 0 ? 1.0 : -1.0) * random.uniform(0.3, 1.5);
    points.push_back(closed ? polar(radius + across, turn * along / (step * n)) : Vec2(along, across));
  }
  return points;
}

Points uneven(RandomSource& random, int n, bool closed) {
  const double radius = unit_chord_radius(n);
  const double phase = random.uniform(0.0, turn);
  const double dent = random.uniform(0.1, 0.3);
  std::vector<double> along{0.0};
  for (int i = 0; i < n; ++i) along.push_back(along.back() + random.log_uniform(1e-3, 1.0));
  const double whole = closed ? along[static_cast<std::size_t>(n)] : along[static_cast<std::size_t>(n - 1)];
  const double scale = (closed ? turn : 0.75 * turn) / std::max(whole, 1e-3);
  Points points;
  for (int i = 0; i < n; ++i) {
    const double angle = scale * along[static_cast<std::size_t>(i)];
    points.push_back(polar(radius * (1.0 + dent * std::cos(2.0 * angle + phase)), angle));
  }
  return points;
}

Points near_collinear(RandomSource& random, int n, bool closed) {
  constexpr int run = 5;
  constexpr double deviation = 1e-3;
  const auto jitter = [&random] { return Vec2(deviation * random.normal(), deviation * random.normal()); };
  Points points;
  if (closed) {
    const int sides = std::max(3, n / run);
    const double radius = (static_cast<double>(n) / sides) / (2.0 * std::sin(turn / (2.0 * sides)));
    for (int i = 0; i < n; ++i) {
      const double along = static_cast<double>(i) * sides / n;
      const double corner = std::floor(along);
      const Vec2 from = polar(radius, turn * corner / sides);
      const Vec2 to = polar(radius, turn * (corner + 1.0) / sides);
      points.emplace_back(from + (along - corner) * (to - from) + jitter());
    }
    return points;
  }
  Vec2 at = Vec2::Zero();
  double angle = random.uniform(0.0, turn);
  for (int i = 0; i < n; ++i) {
    points.emplace_back(at + jitter());
    if (i % run == run - 1) angle += random.uniform(-turn / 3.0, turn / 3.0);
    at += polar(1.0, angle);
  }
  return points;
}

Points spiral(RandomSource& random, int n, bool closed) {
  constexpr double pitch = 2.0;
  constexpr double first_angle = 2.0;
  const int out = closed ? (n + 1) / 2 : n;
  Points points;
  for (int i = 0; i < n; ++i) {
    const bool back = i >= out;
    const double length = back ? n - 1 - i : i;
    // Archimedes: r = pitch angle / turn has the arc length pitch angle^2 / (2 turn), but for the very middle.
    const double angle = std::sqrt(first_angle * first_angle + 2.0 * turn * length / pitch);
    const double radius = pitch * angle / turn + (closed && !back ? pitch / 2.0 : 0.0);
    const Vec2 jitter(0.05 * random.normal(), 0.05 * random.normal());
    points.emplace_back(polar(radius, angle) + jitter);
  }
  return points;
}

Points points_of(RandomKind kind, RandomSource& random, int n, bool closed) {
  switch (kind) {
    case RandomKind::walk:
      return walk(random, n, closed);
    case RandomKind::star:
      return star(random, n, closed);
    case RandomKind::zigzag:
      return zigzag(random, n, closed);
    case RandomKind::uneven:
      return uneven(random, n, closed);
    case RandomKind::near_collinear:
      return near_collinear(random, n, closed);
    case RandomKind::spiral:
      return spiral(random, n, closed);
  }
  throw std::logic_error("unknown RandomKind");
}

RandomKind parse_kind(std::string_view text, const Place& place) {
  std::string known;
  for (const RandomKind kind : random_kinds()) {
    if (text == name(kind)) return kind;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", name(kind));
  }
  refuse(place, fmt::format("no random family {}", in_quotes(text)), fmt::format("known are {}", known));
}

}  // namespace

const std::vector<RandomKind>& random_kinds() {
  static const std::vector<RandomKind> kinds{RandomKind::walk,   RandomKind::star,           RandomKind::zigzag,
                                             RandomKind::uneven, RandomKind::near_collinear, RandomKind::spiral};
  return kinds;
}

std::string_view name(RandomKind kind) {
  constexpr std::array<std::string_view, 6> names{"walk", "star", "zigzag", "uneven", "near-collinear", "spiral"};
  return names[static_cast<std::size_t>(kind)];
}

Input random_input(RandomKind kind, int n, std::uint64_t seed, bool closed) {
  if (n < 1) throw std::invalid_argument(fmt::format("random_input: n = {}; give at least 1", n));
  RandomSource random(seed);
  Input input;
  input.closed = closed;
  input.points = points_of(kind, random, n, closed);
  const double unit = n > 1 ? mean_chord(input) : 1.0;
  for (Vec2& point : input.points) point = on_grid(point / unit);
  return input;
}

std::vector<Drawing> random_drawings(std::string_view text) {
  const std::vector<std::string_view> parts = split(text, ':');
  const Place place{std::string(text), 0};
  if (parts.size() < 2 || parts.size() > 3 || parts[0] != "random") {
    refuse(place, "this names no random points", "write random:KIND:n=12,seed=1");
  }
  const RandomKind kind = parse_kind(parts[1], place);
  KeyValues options(parts.size() == 3 ? parts[2] : "", text);
  const auto n = static_cast<int>(options.take_integer("n", 12, 1, 10'000'000));
  const std::uint64_t first = options.take_seed();
  const bool closed = options.take_flag("closed", false);
  const long count = options.take_integer("count", 1, 1, 100'000);
  options.expect_all_taken("n, seed, closed, count");
  if (n * count > 100'000'000) refuse(place, "more than 10^8 points", "choose a smaller n or count");

  std::vector<Drawing> drawings;
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed) {
    const std::string id = fmt::format("random:{}:n={},seed={},closed={}", name(kind), n, seed, closed);
    drawings.push_back({.id = id,
                        .title = fmt::format("random {}, {} points", name(kind), n),
                        .source = fmt::format("generated: {}", id),
                        .licence = "CC0",
                        .units = "the mean chord",
                        .curves = {random_input(kind, n, seed, closed)}});
  }
  return drawings;
}

}  // namespace kappabench
