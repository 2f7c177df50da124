#include "experiments/papers/pkappa-2024-wang/energies.hpp"

#include <algorithm>
#include <iterator>

#include "experiments/study/jobs.hpp"
#include "metrics/parabola_energy.hpp"
#include "metrics/statistics.hpp"
#include "schemes/pkappa/spans.hpp"
#include "schemes/segments/polynomial.hpp"

namespace kappabench::wang {

std::vector<Node> inner_nodes(const Curve& curve) {
  std::vector<Node> nodes;
  std::ranges::copy_if(curve.nodes(), std::back_inserter(nodes),
                       [](const Node& node) { return node.t > 0.0 && node.t < 1.0; });
  return nodes;
}

std::vector<double> parabola_energies(const Curve& curve) {
  std::vector<double> energies;
  for (const Node& node : inner_nodes(curve))
    energies.push_back(best_parabola(curve.segment(node.segment), node.t).energy);
  return energies;
}

double mean_energy_of(const Fit& fit) { return study::solved(fit) ? mean(parabola_energies(*fit.curve)) : undefined; }

namespace {

/// E_p + weight (E_e + E_c) of a segment with `unit` as the length 1.
double weighted_energy(const Curve& curve, const Node& node, double unit, double weight) {
  const Segment& segment = curve.segment(node.segment);
  double sum = best_parabola(segment, node.t).energy * unit;
  const auto points = dynamic_cast<const PolynomialSegment&>(segment).control_points();
  double before = 0.0;
  for (std::size_t j = 0; j + 1 < points.size(); ++j) {
    const double edge = (points[j + 1] - points[j]).squaredNorm() / (unit * unit);
    sum += weight * edge;
    if (j > 0) sum += weight * (edge - before) * (edge - before);
    before = edge;
  }
  return sum;
}

}  // namespace

double first_stage_energy(const Curve& curve, double unit) {
  constexpr double weight = 0.1;
  double sum = 0.0;
  for (const Node& node : inner_nodes(curve)) sum += weighted_energy(curve, node, unit, weight);
  return sum;
}

double mean_own_energy(const Curve& curve, const Input& input) {
  constexpr double weight = 0.01;
  const std::vector<double> chords = pkappa::chords_of(input.points, input.closed);
  double sum = 0.0;
  for (const Node& node : inner_nodes(curve))
    sum += weighted_energy(curve, node, chords[static_cast<std::size_t>(node.segment)], weight);
  return sum / curve.size();
}

}  // namespace kappabench::wang
