#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "schemes/api/input.hpp"
#include "tests/schemes.hpp"

namespace kappabench::test {

/// Uniform and normal numbers that are the same with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) { generator_.discard(8); }
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(generator_() >> 11) * 0x1p-53);
  }
  double normal() {
    const double u = uniform(1e-300, 1.0), v = uniform(0.0, 1.0);
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
  }
  int index(int count) { return static_cast<int>(generator_() % static_cast<std::uint64_t>(count)); }

 private:
  std::mt19937_64 generator_;
};

enum class Family { star, zigzag, uneven_walk, near_collinear, spiral, square };
inline constexpr Family families[] = {Family::star,           Family::zigzag, Family::uneven_walk,
                                      Family::near_collinear, Family::spiral, Family::square};

/// A random input of 3 to 50 points, open or closed; the same for the same seed.
inline Input random_input(Family family, std::uint64_t seed) {
  Random random(seed * 1000003 + static_cast<std::uint64_t>(family) * 7919 + 17);
  Input input;
  const int n = 3 + random.index(48);
  input.closed = random.index(2) == 1;
  const double pi = std::numbers::pi;
  const auto direction = [](double angle) { return Vec2(std::cos(angle), std::sin(angle)); };
  switch (family) {
    case Family::star: {
      std::vector<double> angles;
      for (int i = 0; i < n; ++i) angles.push_back(random.uniform(0.0, 2.0 * pi));
      std::sort(angles.begin(), angles.end());
      for (const double angle : angles) input.points.push_back(random.uniform(0.3, 1.0) * direction(angle));
      break;
    }
    case Family::zigzag: {
      double x = 0.0;
      for (int i = 0; i < n; ++i) {
        input.points.emplace_back(x, (i % 2 ? 1.0 : -1.0) * random.uniform(0.1, 1.0));
        x += random.uniform(0.2, 1.5);
      }
      break;
    }
    case Family::uneven_walk: {
      Vec2 p = Vec2::Zero();
      double heading = random.uniform(0.0, 2.0 * pi);
      for (int i = 0; i < n; ++i) {
        input.points.push_back(p);
        heading += 0.9 * random.normal();
        p += std::pow(10.0, random.uniform(-1.5, 0.5)) * direction(heading);
      }
      break;
    }
    case Family::near_collinear: {
      const double amplitude = std::pow(10.0, random.uniform(-3.0, -1.0));
      const int forth = input.closed ? (n + 1) / 2 : n;  // a closed one runs back beside itself
      double x = 0.0;
      for (int i = 0; i < n; ++i) {
        input.points.emplace_back(x, amplitude * random.uniform(-1.0, 1.0) + (i >= forth ? 0.3 : 0.0));
        x += (i < forth - 1 ? 1.0 : -1.0) * random.uniform(0.5, 1.5) * (i == forth - 1 ? 0.1 : 1.0);
      }
      break;
    }
    case Family::spiral: {
      const double turns = random.uniform(0.5, 3.0), noise = std::pow(10.0, random.uniform(-3.0, -0.7));
      for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * pi * (input.closed ? 1.0 : turns) * i / n;
        const double x = random.normal(), y = random.normal();
        input.points.push_back((input.closed ? 1.0 : 1.0 + angle / 3.0) * direction(angle) + noise * Vec2(x, y));
      }
      break;
    }
    case Family::square:
      for (int i = 0; i < n; ++i) {
        const double x = random.uniform(0.0, 1.0), y = random.uniform(0.0, 1.0);
        input.points.emplace_back(x, y);
      }
      break;
  }
  return input;
}

/// The same input with a random `a` for each point.
inline Input with_random_a(Input input, std::uint64_t seed, double low, double high) {
  Random random(seed);
  input.options.resize(input.points.size());
  for (PointOptions& options : input.options) options.a = random.uniform(low, high);
  return input;
}

inline Fit fit(std::string_view text, const Input& input) { return scheme(text)->fit(input); }

/// The nodes of points that have a segment of their own: all but the ends of an open curve.
inline std::vector<Node> inner_nodes(const Fit& fit) {
  std::vector<Node> nodes;
  for (const Node& node : fit.curve->nodes())
    if (fit.input.closed || (node.point != 0 && node.point != fit.input.size() - 1)) nodes.push_back(node);
  return nodes;
}

/// The largest distance between a node and its point, over the mean chord.
inline double largest_miss(const Fit& fit) {
  double largest = 0.0;
  for (const Node& node : fit.curve->nodes()) {
    const Vec2 at = fit.curve->segment(node.segment).jet(node.t, 0).position();
    largest = std::max(largest, (at - fit.input.points[static_cast<std::size_t>(node.point)]).norm());
  }
  return largest / mean_chord(fit.input);
}

/// The curves of at least 3 points in the drawings of other authors; empty when they are not there. The inputs of
/// `outside` are files in many formats, some hostile: they are no drawings.
inline std::vector<Input> outside_curves() {
  const std::filesystem::path folder = KAPPABENCH_SHARED_DATA;
  std::vector<Input> curves;
  if (!std::filesystem::exists(folder)) return curves;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().parent_path().filename() != "outside") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    std::ifstream stream(file);
    if (file.extension() == ".txt") {
      Input input{.points = {}, .closed = true, .options = {}, .ids = {}};
      for (double x, y; stream >> x >> y;) input.points.emplace_back(x, y);
      curves.push_back(input);
    } else if (file.extension() == ".pts") {
      for (const bool closed : {true, false}) {
        int count = 0;
        stream >> count;
        for (int c = 0; c < count; ++c) {
          Input input{.points = {}, .closed = closed, .options = {}, .ids = {}};
          int n = 0;
          stream >> n;
          for (int i = 0; i < n; ++i) {
            double x = 0.0, y = 0.0;
            stream >> x >> y;
            input.points.emplace_back(x, y);
          }
          if (n >= 3) curves.push_back(input);
        }
      }
    }
  }
  return curves;
}

}  // namespace kappabench::test
