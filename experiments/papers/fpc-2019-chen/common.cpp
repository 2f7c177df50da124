#include "experiments/papers/fpc-2019-chen/common.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "experiments/study/summaries.hpp"

namespace kappabench::fpc {

store::ClaimRecord claim(std::string_view id, std::string verdict, std::string ours, std::string evidence) {
  return study::claim(paper, id, std::move(verdict), std::move(ours), std::move(evidence));
}

const std::vector<std::string_view>& gallery() {
  static const std::vector<std::string_view> names{"butterfly", "clover",   "leaf-with-tips",   "ribbon",
                                                   "bat",       "flourish", "fish-in-one-line", "clef"};
  return names;
}

std::vector<Drawing> gallery_or(const Context& context) { return study::drawings_or(context, gallery()); }

store::PanelRecord curve_panel(int cell, std::string title, bool comb) {
  store::PanelRecord panel{.kind = "curve", .title = std::move(title), .cells = {cell}};
  panel.comb = comb;
  return panel;
}

Loops loops_of(const store::ExperimentRecord& record, std::string_view dataset, std::string_view scheme) {
  for (std::size_t i = 0; i < record.cells.size(); ++i) {
    const store::CellRecord& cell = record.cells[i];
    if (cell.dataset != dataset || cell.scheme != scheme || cell.curves.empty()) continue;
    const store::CurveRecord& curve = cell.curves.front();
    return {static_cast<int>(i), static_cast<double>(curve.point_x.size()), measured(curve, "loops").value_or(0.0),
            measured(curve, "loops_at_nodes").value_or(0.0)};
  }
  return {};
}

int count_of(const Input& input, PointType type) {
  return static_cast<int>(
      std::ranges::count_if(input.options, [type](const PointOptions& options) { return options.type == type; }));
}

double length_between(const Segment& segment, double from, double to) {
  // Gauss's rule with 3 points in each of many parts; a cusp or a small loop does not hide between them.
  constexpr int parts = 200;
  constexpr double offset = 0.7745966692414834;
  const double half = 0.5 * (to - from) / parts;
  double length = 0.0;
  for (int i = 0; i < parts; ++i) {
    const double middle = from + (2 * i + 1) * half;
    const auto at = [&](double t) { return segment.jet(t, 1).d[1].norm(); };
    length += half * (8.0 * at(middle) + 5.0 * (at(middle - offset * half) + at(middle + offset * half))) / 9.0;
  }
  return length;
}

std::vector<Node> nodes_of(const Curve& curve, int point) {
  std::vector<Node> found;
  std::ranges::copy_if(curve.nodes(), std::back_inserter(found),
                       [point](const Node& node) { return node.point == point; });
  return found;
}

CellJob random_job(const SchemePtr& scheme, std::string_view name, int version, int inputs,
                   std::function<void(std::uint64_t index, store::CellRecord&)> measure) {
  CellJob job = other_job(fmt::format("random typed inputs: {}", name), scheme,
                          fmt::format("{} {}, {} inputs", name, version, inputs),
                          [inputs, measure = std::move(measure)](store::CellRecord& cell) {
                            for (int i = 0; i < inputs; ++i) measure(static_cast<std::uint64_t>(i), cell);
                          });
  job.label = fmt::format("{} (numbers)", name);
  return job;
}

}  // namespace kappabench::fpc
