#include "experiments/papers/pkappa-2024-wang/energies.hpp"

#include <algorithm>
#include <iterator>

#include "experiments/study/jobs.hpp"
#include "metrics/parabola_energy.hpp"
#include "metrics/statistics.hpp"
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

double first_stage_energy(const Curve& curve, double unit) {
  constexpr double weight = 0.1;
  double sum = 0.0;
  for (const double energy : parabola_energies(curve)) sum += energy * unit;
  for (const SegmentPtr& segment : curve.segments()) {
    const auto points = dynamic_cast<const PolynomialSegment&>(*segment).control_points();
    double before = 0.0;
    for (std::size_t j = 0; j + 1 < points.size(); ++j) {
      const double edge = (points[j + 1] - points[j]).squaredNorm() / (unit * unit);
      sum += weight * edge;
      if (j > 0) sum += weight * (edge - before) * (edge - before);
      before = edge;
    }
  }
  return sum;
}

}  // namespace kappabench::wang
