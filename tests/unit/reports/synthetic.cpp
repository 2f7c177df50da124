#include "tests/unit/reports/synthetic.hpp"

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <numbers>
#include <sstream>

namespace kappabench::synthetic {
namespace {

using store::CellRecord;
using store::CurveRecord;
using store::ExperimentRecord;
using store::FigureRecord;
using store::PanelRecord;
using store::TableRecord;

struct Place {
  double x, y;
};
using Formula = std::function<Place(double)>;

constexpr int samples_per_segment = 48;

/// Samples u in [from, to] in `segments` pieces; derivatives by central differences, which is plenty for a drawing.
CurveRecord sampled(const Formula& at, double from, double to, int segments, bool closed) {
  CurveRecord curve;
  curve.closed = closed;
  curve.outcome = "converged";
  curve.samples_per_segment = samples_per_segment;
  curve.exact_json = R"({"format":"kappabench-curve","version":2,"scheme":"synthetic"})";
  const double step = (to - from) / segments, h = 1e-4 * (to - from);
  double s = 0.0;
  Place last = at(from);
  for (int segment = 0; segment < segments; ++segment) {
    for (int i = 0; i < samples_per_segment; ++i) {
      const double u = from + step * (segment + static_cast<double>(i) / (samples_per_segment - 1));
      const Place p = at(u), before = at(u - h), after = at(u + h);
      const double dx = (after.x - before.x) / (2 * h), dy = (after.y - before.y) / (2 * h);
      const double ddx = (after.x - 2 * p.x + before.x) / (h * h), ddy = (after.y - 2 * p.y + before.y) / (h * h);
      const double speed = std::hypot(dx, dy);
      s += std::hypot(p.x - last.x, p.y - last.y);
      last = p;
      curve.sample_x.push_back(p.x);
      curve.sample_y.push_back(p.y);
      curve.sample_s.push_back(s);
      curve.sample_kappa.push_back((dx * ddy - dy * ddx) / (speed * speed * speed));
      curve.sample_normal_x.push_back(-dy / speed);
      curve.sample_normal_y.push_back(dx / speed);
    }
    const auto middle = curve.sample_x.size() - samples_per_segment / 2, end = curve.sample_x.size() - 1;
    curve.point_x.push_back(curve.sample_x[middle]);
    curve.point_y.push_back(curve.sample_y[middle]);
    curve.node_point.push_back(segment);
    curve.node_segment.push_back(segment);
    curve.node_t.push_back(0.5);
    curve.node_x.push_back(curve.sample_x[middle]);
    curve.node_y.push_back(curve.sample_y[middle]);
    curve.node_s.push_back(curve.sample_s[middle]);
    curve.node_kappa.push_back(curve.sample_kappa[middle]);
    curve.node_marks.emplace_back(segment == 1 ? "pinned" : segment == 2 ? "at_inflection curvature_minimum" : "");
    if (segment + 1 < segments || closed) {
      curve.joint_segment.push_back(segment);
      curve.joint_claimed.push_back("G2");
      curve.joint_x.push_back(curve.sample_x[end]);
      curve.joint_y.push_back(curve.sample_y[end]);
      curve.joint_s.push_back(curve.sample_s[end]);
    }
  }
  curve.measurements = {{"bending_energy", 12.5, "sampled", "1"}, {"extrema", segments * 1.0, "exact", "1"}};
  return curve;
}

void converge(CurveRecord& curve, double ratio, int iterations) {
  curve.iterations = iterations;
  for (int i = 0; i <= iterations; ++i) curve.trace.push_back(0.3 * std::pow(ratio, i));
  if (ratio < 0.5) curve.trace.back() = 0.0;  // exactly met: drawn at the floor
  curve.residual = curve.trace.back();
  curve.counters = {{"pinned", 1}, {"sweeps", iterations}};
}

CellRecord cell_of(const std::string& dataset, const std::string& label, std::vector<CurveRecord> curves) {
  CellRecord cell;
  cell.dataset = dataset;
  cell.scheme = label.substr(0, label.find(' '));
  cell.parameters = label.size() > cell.scheme.size() ? label.substr(cell.scheme.size() + 1) : "";
  cell.label = label;
  cell.key = "0123abcd";
  cell.outcome = curves.front().outcome;
  cell.curves = std::move(curves);
  cell.timings = {{"fit", {1e-4, 1.1e-4, 0.9e-4}}, {"evaluate/500", {2e-5}}};
  return cell;
}

TableRecord energies() {
  const double none = std::numeric_limits<double>::quiet_NaN();
  return {"energies",
          "Energies & counts",
          "E_p over the drawing; 100% of the rows, failures included.",
          {{"drawing", "", "", std::vector<std::string>{"polygon", "wave", "peak_1", "broken"}, false},
           {"scheme", "", "", std::vector<std::string>{"kappa", "ekappa", "kappa", "kappa"}, false},
           {"energy", "1/length", "", std::vector<double>{1.6423456e-6, 12.5, 123456789.0, none}, false},
           {"extrema", "1", "", std::vector<double>{6, 4, 1, none}, true}}};
}

TableRecord timings() {
  std::vector<double> points, seconds;
  std::vector<std::string> scheme;
  for (const char* name : {"kappa", "ekappa", "fpc"}) {
    for (int n = 8; n <= 512; n *= 2) {
      scheme.emplace_back(name);
      points.push_back(n);
      const double each = name == std::string("kappa") ? 1e-6 : name == std::string("fpc") ? 4e-6 : 2e-6;
      seconds.push_back(each * n * (1.0 + 0.1 * std::sin(n)) * (name == std::string("fpc") ? n / 8.0 : 1.0));
    }
  }
  return {"scaling",
          "Time against size",
          "",
          {{"scheme", "", "", scheme, false}, {"points", "1", "", points, true}, {"time", "s", "", seconds, false}}};
}

PanelRecord panel(const std::string& kind, const std::string& title, std::vector<int> cells) {
  PanelRecord record;
  record.kind = kind;
  record.title = title;
  record.cells = std::move(cells);
  return record;
}

std::vector<FigureRecord> figures() {
  PanelRecord comb = panel("curve", "with curvature comb", {0});
  comb.comb = true;
  PanelRecord peak = panel("curve", "a peak of curvature", {3});
  peak.comb = true;
  PanelRecord close = panel("curve", "close-up", {0, 1});
  close.window = {0.6, 1.4, -0.4, 0.4};
  PanelRecord graph = panel("graph", "time of a fit", {});
  graph.table = "scaling";
  graph.x = "points";
  graph.y = {"time"};
  graph.series = "scheme";
  graph.log_x = graph.log_y = graph.slope = true;
  PanelRecord words = panel("graph", "extrema", {});
  words.table = "energies";
  words.x = "drawing";
  words.y = {"extrema"};
  words.lines = false;
  return {{"curves",
           "Curves of two schemes",
           "The second did not converge.",
           0,
           {panel("curve", "both", {0, 1}), comb, close, panel("curve", "a wave", {2}), peak,
            panel("curve", "a failure", {4})}},
          {"analysis",
           "Curvature and convergence",
           "",
           2,
           {panel("curvature", "curvature", {0, 1}), panel("curvature", "a peak", {3}),
            panel("convergence", "residual", {0, 1, 2}), graph, words}},
          {"single", "One panel", "Everything on one curve.", 0, {comb}}};
}

}  // namespace

CellRecord polygon_cell(const std::string& label, double bump, bool converged) {
  const auto shape = [bump](double u) {
    const double r = 1.0 + bump * std::cos(3 * u);
    return Place{r * std::cos(u), r * std::sin(u)};
  };
  CurveRecord curve = sampled(shape, -std::numbers::pi / 6, 2 * std::numbers::pi - std::numbers::pi / 6, 6, true);
  converge(curve, converged ? 0.35 : 0.93, converged ? 24 : 40);
  if (!converged) {
    curve.outcome = "not_converged";
    curve.message = "40 iterations without reaching 1e-12";
  }
  return cell_of("polygon", label, {curve});
}

CellRecord wave_cell(const std::string& label, double height) {
  const auto shape = [height](double u) { return Place{u, height * std::sin(2 * u)}; };
  const auto below = [height](double u) { return Place{u, height * std::sin(2 * u) - 1.5 * height}; };
  std::vector<CurveRecord> curves{sampled(shape, 0.0, 6.0, 5, false), sampled(below, 1.0, 5.0, 3, false)};
  for (auto& curve : curves) converge(curve, 0.6, 45);
  return cell_of("wave", label, std::move(curves));
}

CellRecord peak_cell() {
  // y = sqrt(x^2 + e^2): a hyperbola with curvature 1/e at the tip.
  const auto shape = [](double u) {
    const double x = 2e-3 * std::sinh(6.5 * u);
    return Place{x, std::hypot(x, 2e-3)};
  };
  CurveRecord curve = sampled(shape, -1.0, 1.0, 3, false);
  converge(curve, 0.2, 12);
  return cell_of("peak_1", "kappa", {curve});
}

CellRecord failed_cell() {
  CurveRecord curve;
  curve.outcome = "timed_out";
  curve.message = "stopped after 10 s";
  curve.point_x = {0.0, 1.0, 1.0};
  curve.point_y = {0.0, 0.0, 1.0};
  CellRecord cell = cell_of("broken", "kappa", {curve});
  cell.message = curve.message;
  cell.timings.clear();
  return cell;
}

store::Results results() {
  ExperimentRecord full;
  full.id = "ekappa-synthetic";
  full.title = "Synthetic <curves> & tables";
  full.about = "Made of formulas; it tests what is written.";
  full.cells = {polygon_cell("kappa", 0.12, true), polygon_cell("ekappa a=0.8", 0.2, false), wave_cell("fpc", 0.5),
                peak_cell(), failed_cell()};
  full.tables = {energies(), timings()};
  full.figures = figures();
  full.claims = {{"ekappa-2022-miura", "interpolates-points", "reproduced", "0 of 20 points missed",
                  "All nodes lie within 1e-12 of the mean chord."},
                 {"ekappa-2022-miura", "extremum-at-points", "contradicted", "2 of 20", "Two points are pinned."}};
  ExperimentRecord small;
  small.id = "a-second";
  small.title = "Nothing to draw";
  return {{{"commit", "0000"}, {"plan", std::string(100000, 'x')}, {"seed", "7"}}, {full, small}};
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace kappabench::synthetic
