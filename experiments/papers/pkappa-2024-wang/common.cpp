#include "experiments/papers/pkappa-2024-wang/common.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "datasets/datasets.hpp"
#include "datasets/random_points.hpp"
#include "experiments/run/record.hpp"
#include "experiments/study/summaries.hpp"
#include "metrics/parabola_energy.hpp"
#include "schemes/segments/polynomial.hpp"

namespace kappabench::wang {

namespace {

const PolynomialSegment& bezier(const Segment& segment) { return dynamic_cast<const PolynomialSegment&>(segment); }

const study::Key segment_key{"segment"};
const study::Quantity a0{"a0", "1/length", Method::sampled}, a1{"a1", "1/length", Method::sampled},
    a2{"a2", "1/length", Method::sampled};

void fit_measure_and_keep_parabolas(const Uses& uses, store::CellRecord& cell) {
  study::Notes notes(cell);
  const Scheme& scheme = *uses.schemes.front();
  for (const Input& input : uses.drawings.front().curves) {
    const Fit fit = scheme.fit(input);
    cell.curves.push_back(record_of(scheme, fit, uses.metrics));
    if (fit.report.outcome != Outcome::converged) cell.outcome = name(fit.report.outcome);
    if (!fit.curve) continue;
    for (const Node& node : inner_nodes(*fit.curve)) {
      const Parabola q = best_parabola(fit.curve->segment(node.segment), node.t).parabola;
      notes.row({segment_key(node.segment)}, {a0(q.a0), a1(q.a1), a2(q.a2)});
    }
  }
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

std::vector<Node> inner_nodes(const Curve& curve) {
  std::vector<Node> nodes;
  std::ranges::copy_if(curve.nodes(), std::back_inserter(nodes),
                       [](const Node& node) { return node.t > 0.0 && node.t < 1.0; });
  return nodes;
}

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
  for (const Node& node : inner_nodes(curve))
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
  metrics.push_back(&find_metric("parabola_energy"));
  return {
      .dataset = drawing.id,
      .label = std::move(label),
      .uses = {.work = "fit with parabolas", .schemes = {scheme}, .drawings = {drawing}, .metrics = std::move(metrics)},
      .compute = fit_measure_and_keep_parabolas};
}

study::Table parabola_table(const study::Findings& found, std::string id, const std::vector<int>& cells, int steps) {
  study::Table table(std::move(id), "Curvature and its parabola",
                     "Curvature of the segments and the parabola nearest to it (Eq. (3)) with its vertex at the "
                     "segment's point, against the segment's number plus t.");
  table.words("curve").numbers("segment + t").numbers("curvature", "1/length").numbers("parabola", "1/length");
  table.numbers("difference", "1/length");
  for (const int c : cells) {
    const store::CurveRecord* curve = found.curve(c);
    if (curve == nullptr) continue;
    const store::CellRecord& cell = found.cell(c);
    const int samples = curve->samples_per_segment, stride = std::max(1, (samples - 1) / steps);
    std::size_t s = 0;
    for (const study::Row* row :
         found.rows().where({study::key::dataset(cell.dataset), study::key::label(cell.label)})) {
      for (int j = 0; j < samples; j += stride) {
        const double t = static_cast<double>(j) / (samples - 1);
        const double kappa = curve->sample_kappa[s * static_cast<std::size_t>(samples) + static_cast<std::size_t>(j)];
        const double parabola = (*row)[a0] + t * ((*row)[a1] + t * (*row)[a2]);
        table.row({cell.label, static_cast<double>(s) + t, kappa, parabola, kappa - parabola});
      }
      ++s;
    }
  }
  return table;
}

study::Panel parabola_panel(std::string title, std::string table, std::string x_label) {
  return study::Panel::graph(std::move(table), "segment + t", {"curvature", "parabola"}, std::move(title))
      .labels(std::move(x_label), "κ");
}

study::Panel difference_panel(std::string title, std::string table) {
  return study::Panel::graph(std::move(table), "segment + t", {"difference"}, std::move(title))
      .labels("segment + t", "κ - parabola");
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
