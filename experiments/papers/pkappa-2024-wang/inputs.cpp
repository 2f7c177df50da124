#include "experiments/papers/pkappa-2024-wang/inputs.hpp"

#include <array>
#include <utility>

#include "datasets/datasets.hpp"
#include "datasets/random_points.hpp"

namespace kappabench::wang {

Drawing drawing(std::string_view id) { return open_drawings(id).front(); }

Drawing drawing_of(std::string id, Input input) {
  Drawing drawing{.id = std::move(id)};
  drawing.curves = {std::move(input)};
  return drawing;
}

Drawing scaled_to(Drawing drawing, double chord) {
  const double factor = chord / mean_chord(drawing.curves.front());
  for (Input& input : drawing.curves)
    for (Vec2& point : input.points) point *= factor;
  return drawing;
}

Input scaled_to(Input input, double chord) {
  return std::move(scaled_to(drawing_of({}, std::move(input)), chord).curves.front());
}

Input random_curve(std::uint64_t seed, int index, int n, bool closed) {
  constexpr std::array kinds{RandomKind::walk, RandomKind::star, RandomKind::zigzag, RandomKind::spiral};
  const auto i = static_cast<std::size_t>(index);
  return random_input(kinds[i % kinds.size()], n, seed + i, closed);
}

}  // namespace kappabench::wang
