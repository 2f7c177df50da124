#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "schemes/fpc/cascade.hpp"
#include "schemes/fpc/tasks.hpp"
#include "tests/unit/schemes/kappa_inputs.hpp"

namespace kappabench::test {

inline constexpr std::array all_types{PointType::regular, PointType::cusp, PointType::loop, PointType::inflection};

/// The same points, each of a random type; the ends of an open curve have none.
inline Input with_random_types(Input input, std::uint64_t seed) {
  Random random(seed + 77);
  input.options.assign(input.points.size(), {});
  for (std::size_t i = 0; i < input.options.size(); ++i) {
    const bool end = !input.closed && (i == 0 || i + 1 == input.options.size());
    const PointType type = all_types[static_cast<std::size_t>(random.index(4))];
    if (!end) input.options[i].type = type;
  }
  return input;
}

inline fpc::CubicChain chain_of(const Input& input, const fpc::Defaults& defaults = {}) {
  const fpc::Tasks read = fpc::read_tasks(input, defaults);
  if (!read.problem.empty()) throw std::runtime_error(read.problem);
  return fpc::make_chain(input.points, read.tasks, input.closed);
}

/// The closed curve of fixture F6.
inline Input five_points(std::vector<PointType> types = {}) {
  Input input{.points = {{0, 0}, {4, -1}, {5, 3}, {2, 5}, {-1, 3}}, .closed = true, .options = {}, .ids = {}};
  if (!types.empty()) {
    input.options.resize(5);
    for (std::size_t i = 0; i < 5; ++i) input.options[i].type = types[i];
  }
  return input;
}

}  // namespace kappabench::test
