#include "experiments/papers/fpc-2019-chen/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "datasets/random_source.hpp"

namespace kappabench::chen {
namespace {

/// Seeds of neighbouring numbers, made unlike (splitmix64, Steele, Lea and Flood 2014).
std::uint64_t scrambled(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

}  // namespace

Input typed_random_input(RandomKind kind, int n, std::uint64_t seed, bool closed, const std::vector<PointType>& types) {
  Input input = random_input(kind, n, seed, closed);
  RandomSource random(scrambled(seed));
  input.options.resize(input.points.size());
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    const auto drawn = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(types.size())));
    const bool end = !closed && (i == 0 || i + 1 == input.points.size());
    if (!end) input.options[i].type = types[std::min(drawn, types.size() - 1)];
  }
  return input;
}

Input typed_random_input(std::uint64_t seed, std::uint64_t index) {
  RandomSource random(scrambled(seed ^ scrambled(index)));
  const RandomKind kind = random_kinds()[index % random_kinds().size()];
  const int n = 4 + static_cast<int>(random.uniform(0.0, 9.0));
  const bool closed = random.uniform(0.0, 1.0) < 0.5;
  const auto points = static_cast<std::uint64_t>(random.uniform(0.0, 0x1p52));
  return typed_random_input(kind, n, points, closed,
                            {PointType::regular, PointType::cusp, PointType::loop, PointType::inflection});
}

Drawing typed_random_inputs(std::string_view name, std::uint64_t seed, int count) {
  Drawing drawing{.id = fmt::format("random typed inputs: {}, seed {}", name, seed)};
  for (int i = 0; i < count; ++i) drawing.curves.push_back(typed_random_input(seed, static_cast<std::uint64_t>(i)));
  return drawing;
}

}  // namespace kappabench::chen
