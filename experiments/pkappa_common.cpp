#include "experiments/pkappa_common.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "datasets/datasets.hpp"
#include "datasets/random_points.hpp"
#include "datasets/write_points.hpp"
#include "experiments/record.hpp"
#include "experiments/summaries.hpp"
#include "metrics/parabola_energy.hpp"
#include "schemes/segments/polynomial.hpp"

namespace kappabench::wang {

namespace {

const PolynomialSegment& bezier(const Segment& segment) { return dynamic_cast<const PolynomialSegment&>(segment); }

/// The node inside every segment.
std::vector<Node> inner_node_of_segments(const Curve& curve) {
  std::vector<Node> nodes;
  std::ranges::copy_if(curve.nodes(), std::back_inserter(nodes),
                       [](const Node& node) { return node.t > 0.0 && node.t < 1.0; });
  return nodes;
}

void put_parabolas(const Curve& curve, store::CellRecord& cell) {
  for (const Node& node : inner_node_of_segments(curve)) {
    const Parabola q = best_parabola(curve.segment(node.segment), node.t).parabola;
    study::put(cell, "a0", q.a0, Method::sampled);
    study::put(cell, "a1", q.a1, Method::sampled);
    study::put(cell, "a2", q.a2, Method::sampled);
  }
}

std::string text_of(const Drawing& drawing) {
  std::ostringstream text;
  write_points(text, drawing);
  return text.str();
}

std::vector<double> own_values(const store::CellRecord& cell, std::string_view column) {
  std::vector<double> found;
  for (const store::MeasurementRecord& m : cell.measurements)
    if (m.column == column) found.push_back(m.value);
  return found;
}

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<double> found;
  for (const double v : values) {
    const auto below = std::ranges::count_if(values, [v](double other) { return other < v; });
    const auto equal = std::ranges::count(values, v);
    found.push_back(static_cast<double>(below) + 0.5 * static_cast<double>(equal - 1));
  }
  return found;
}

}  // namespace

store::ClaimRecord claim(std::string_view id, std::string verdict, std::string ours, std::string evidence) {
  return study::claim(paper, id, std::move(verdict), std::move(ours), std::move(evidence));
}

SchemePtr pkappa(const Registry& registry, std::string_view options) {
  return registry.parse(options.empty() ? std::string("pkappa") : fmt::format("pkappa:{}", options));
}

Drawing drawing(std::string_view id) { return open_drawings(id).front(); }

Input scaled_to(Input input, double chord) {
  const double factor = chord / mean_chord(input);
  for (Vec2& point : input.points) point *= factor;
  return input;
}

Drawing scaled_to(Drawing drawing, double chord) {
  const double factor = chord / mean_chord(drawing.curves.front());
  for (Input& input : drawing.curves)
    for (Vec2& point : input.points) point *= factor;
  return drawing;
}

Input random_curve(std::uint64_t seed, int index, int n, bool closed) {
  constexpr std::array kinds{RandomKind::walk, RandomKind::star, RandomKind::zigzag, RandomKind::spiral};
  const auto i = static_cast<std::size_t>(index);
  return random_input(kinds[i % kinds.size()], n, seed + i, closed);
}

std::vector<double> parabola_energies(const Curve& curve) {
  std::vector<double> energies;
  for (const Node& node : inner_node_of_segments(curve))
    energies.push_back(best_parabola(curve.segment(node.segment), node.t).energy);
  return energies;
}

double first_stage_energy(const Curve& curve, double unit) {
  constexpr double weight = 0.1;
  double sum = 0.0;
  for (const double energy : parabola_energies(curve)) sum += energy * unit;
  for (const SegmentPtr& segment : curve.segments()) {
    const auto points = bezier(*segment).control_points();
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

bool same(const Segment& a, const Segment& b) {
  return std::ranges::equal(bezier(a).control_points(), bezier(b).control_points());
}

CellJob profiled_job(const Drawing& drawing, const SchemePtr& scheme, std::string label,
                     std::vector<const Metric*> metrics) {
  std::string what = "profile 1\n" + text_of(drawing);
  for (const Metric* metric : metrics) what += fmt::format("{} {}\n", metric->id, metric->version);
  CellJob job =
      other_job(drawing.id, scheme, what, [drawing, scheme, metrics = std::move(metrics)](store::CellRecord& cell) {
        for (const Input& input : drawing.curves) {
          const Fit fit = scheme->fit(input);
          cell.curves.push_back(record_of(*scheme, fit, metrics));
          if (fit.report.outcome != Outcome::converged) cell.outcome = name(fit.report.outcome);
          if (fit.curve) put_parabolas(*fit.curve, cell);
        }
      });
  job.label = std::move(label);
  return job;
}

store::TableRecord parabola_table(const store::ExperimentRecord& record, std::string id, const std::vector<int>& cells,
                                  int steps) {
  TableBuilder builder(std::move(id), "Curvature and its parabola",
                       "Curvature of the segments and the parabola nearest to it (Eq. (3)) with its vertex at the "
                       "segment's point, against the segment's number plus t.");
  builder.words("curve").numbers("segment + t").numbers("curvature", "1/length").numbers("parabola", "1/length");
  builder.numbers("difference", "1/length");
  for (const int c : cells) {
    const store::CellRecord& cell = record.cells[static_cast<std::size_t>(c)];
    const auto a0 = own_values(cell, "a0"), a1 = own_values(cell, "a1"), a2 = own_values(cell, "a2");
    if (cell.curves.empty()) continue;
    const store::CurveRecord& curve = cell.curves.front();
    const int samples = curve.samples_per_segment, stride = std::max(1, (samples - 1) / steps);
    for (std::size_t s = 0; s < a0.size(); ++s)
      for (int j = 0; j < samples; j += stride) {
        const double t = static_cast<double>(j) / (samples - 1);
        const std::size_t at = s * static_cast<std::size_t>(samples) + static_cast<std::size_t>(j);
        const double parabola = a0[s] + t * (a1[s] + t * a2[s]);
        builder.row({cell.label, static_cast<double>(s) + t, curve.sample_kappa[at], parabola,
                     curve.sample_kappa[at] - parabola});
      }
  }
  return builder.table();
}

store::PanelRecord parabola_panel(std::string title, std::string table, std::string x_label) {
  store::PanelRecord panel{.kind = "graph", .title = std::move(title)};
  panel.table = std::move(table);
  panel.x = "segment + t";
  panel.y = {"curvature", "parabola"};
  panel.x_label = std::move(x_label);
  panel.y_label = "κ";
  return panel;
}

store::PanelRecord difference_panel(std::string title, std::string table) {
  store::PanelRecord panel = parabola_panel(std::move(title), std::move(table), "segment + t");
  panel.y = {"difference"};
  panel.y_label = "κ - parabola";
  return panel;
}

store::PanelRecord curve_panel(std::vector<int> cells, std::string title, bool comb) {
  store::PanelRecord panel{.kind = "curve", .title = std::move(title), .cells = std::move(cells)};
  panel.comb = comb;
  return panel;
}

CellJob sweep_job(std::string dataset, const SchemePtr& scheme, std::string_view name, int version, int count,
                  std::function<void(int index, store::CellRecord&)> measure) {
  CellJob job = other_job(std::move(dataset), scheme, fmt::format("{} {}, {} inputs", name, version, count),
                          [count, measure = std::move(measure)](store::CellRecord& cell) {
                            for (int i = 0; i < count; ++i) measure(i, cell);
                          });
  job.label = name;
  return job;
}

std::vector<int> cells_labelled(const store::ExperimentRecord& record, std::string_view label) {
  std::vector<int> found;
  for (std::size_t i = 0; i < record.cells.size(); ++i)
    if (record.cells[i].label == label) found.push_back(static_cast<int>(i));
  return found;
}

std::string verdict_often(const Tally& tally) {
  if (!(tally.cases > 0.0)) return "not reproduced";
  return 3.0 * tally.agree >= 2.0 * tally.cases ? "reproduced"
         : 2.0 * tally.agree < tally.cases      ? "contradicted"
                                                : "not reproduced";
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size() || a.size() < 3) return std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> ra = ranks(a), rb = ranks(b);
  const double middle = 0.5 * static_cast<double>(a.size() - 1);
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (ra[i] - middle) * (rb[i] - middle);
    aa += (ra[i] - middle) * (ra[i] - middle);
    bb += (rb[i] - middle) * (rb[i] - middle);
  }
  return ab / std::sqrt(aa * bb);
}

}  // namespace kappabench::wang
