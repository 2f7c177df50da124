#include "experiments/papers/ekappa-2022-miura/common.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "metrics/statistics.hpp"
#include "schemes/curve/jet.hpp"

namespace kappabench::miura {

SchemePtr cubic(const Registry& registry, double a) { return registry.create("ekappa", {{"a", a}}); }
SchemePtr trigonometric(const Registry& registry, double a) { return registry.create("ekappa-trig", {{"a", a}}); }

std::vector<SchemePtr> figure_schemes(const Registry& registry) {
  std::vector<SchemePtr> schemes;
  for (const Shape& shape : figure_shapes) schemes.push_back(cubic(registry, shape.a));
  return schemes;
}

Drawing with_shape_at(Drawing drawing, double a, const std::function<bool(int, int)>& chosen) {
  for (int c = 0; Input & input : drawing.curves) {
    input.options.resize(input.points.size());
    for (int i = 0; PointOptions & options : input.options)
      options.a = chosen(c, i++) ? std::optional<double>(a) : std::nullopt;
    ++c;
  }
  return drawing;
}

std::string label_of_shape(const Shape& shape) {
  return shape.a == figure_shapes[0].a ? "κ-curve" : fmt::format("εκ, a = {}", shape.words);
}

void add_shape_jobs(std::vector<CellJob>& jobs, const Context& context, const Drawing& drawing) {
  for (const Shape& shape : figure_shapes) {
    const bool first = shape.a == figure_shapes[0].a;
    const SchemePtr scheme = first ? context.registry.create("kappa") : cubic(context.registry, shape.a);
    jobs.push_back(fit_job(drawing, scheme, {}, label_of_shape(shape)));
  }
}

std::vector<double> window_at(const store::CurveRecord& curve, double x, double y, double part) {
  const auto [x0, x1] = std::ranges::minmax(curve.sample_x);
  const auto [y0, y1] = std::ranges::minmax(curve.sample_y);
  const double half = 0.5 * part * std::max(x1 - x0, y1 - y0);
  return {x - half, x + half, y - half, y + half};
}

double curvature_at(const Curve& curve, const Node& node) {
  const double kappa = std::abs(curvature(curve.segment(node.segment).jet(node.t, 2)));
  return std::isfinite(kappa) ? kappa : undefined;
}

std::vector<int> evenly(int n, int most) {
  std::vector<int> chosen;
  const int count = std::min(n, most);
  chosen.reserve(static_cast<std::size_t>(std::max(count, 0)));
  for (int k = 0; k < count; ++k) chosen.push_back(k * n / count);
  return chosen;
}

std::vector<double> defined(std::vector<double> numbers) {
  std::erase_if(numbers, [](double x) { return std::isnan(x); });
  return numbers;
}

std::vector<Node> inner_nodes(const Fit& fit) {
  std::vector<Node> nodes;
  const int last = fit.input.size() - 1;
  std::ranges::copy_if(fit.curve->nodes(), std::back_inserter(nodes),
                       [&](const Node& node) { return fit.input.closed || (node.point != 0 && node.point != last); });
  return nodes;
}

}  // namespace kappabench::miura
