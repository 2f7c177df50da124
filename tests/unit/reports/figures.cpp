#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "reports/figures/figure.hpp"
#include "reports/figures/gnuplot.hpp"
#include "tests/catch.hpp"
#include "tests/unit/reports/synthetic.hpp"

namespace fs = std::filesystem;
using namespace kappabench;

namespace {

store::ExperimentRecord experiment() { return synthetic::results().experiments.front(); }

const store::FigureRecord& figure(const store::ExperimentRecord& from, const std::string& id) {
  for (const auto& candidate : from.figures) {
    if (candidate.id == id) return candidate;
  }
  throw std::out_of_range(id);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto place = text.find(part); place != std::string::npos; place = text.find(part, place + 1)) ++found;
  return found;
}

/// A figure of one panel of its own.
FigureFiles one_panel(store::PanelRecord panel, const store::ExperimentRecord& from) {
  return draw_figure({"own", "", "", 0, {std::move(panel)}}, from, "own");
}

store::PanelRecord panel_of(const std::string& kind, std::vector<int> cells) {
  store::PanelRecord panel;
  panel.kind = kind;
  panel.cells = std::move(cells);
  return panel;
}

}  // namespace

TEST_CASE("A script draws into svg and png with relative names") {
  const auto from = experiment();
  const auto files = draw_figure(figure(from, "curves"), from, "curves");
  CHECK(has(files.script, "set terminal svg"));
  CHECK(has(files.script, "set terminal pngcairo"));
  CHECK(has(files.script, "set output 'curves'.'.'.format"));
  CHECK(files.data.size() == 6);
  for (const auto& [name, text] : files.data) {
    CHECK(has(files.script, "'" + name + "' index 0"));
    CHECK(fs::path(name).is_relative());
    CHECK_FALSE(text.empty());
  }
  CHECK(draw_figure(figure(from, "single"), from, "s").data.count("s.dat") == 1);
}

TEST_CASE("A curve that did not converge is dashed and says so") {
  const auto from = experiment();
  for (const char* kind : {"curve", "curvature", "convergence"}) {
    const auto files = one_panel(panel_of(kind, {0, 1}), from);
    CHECK(has(files.script, "ekappa a=0.8 (not converged)"));
    CHECK(count(files.script, "dt (8,5)") == 2);  // the curve and its line in the legend
  }
  const auto alone = one_panel(panel_of("curve", {0}), from);
  CHECK_FALSE(has(alone.script, "dt (8,5)"));
}

TEST_CASE("A wild curve says so, converged or not") {
  auto from = experiment();
  from.cells[0].curves[0].warnings = {{"long_span", 2}, {"winding_span", 1}};
  from.cells[1].curves[0].warnings = {{"long_span", 1}};
  const auto files = one_panel(panel_of("curve", {0, 1}), from);
  CHECK(has(files.script, "(converged, long span, winding span)"));
  CHECK(has(files.script, "ekappa a=0.8 (not converged, long span)"));
  CHECK(count(files.script, "dt (8,5)") == 2);  // of the one that did not converge
}

TEST_CASE("A cell without a curve is named, its points are drawn") {
  const auto files = one_panel(panel_of("curve", {4}), experiment());
  CHECK(has(files.script, "kappa (timed out, no curve)"));
  CHECK(count(files.data.at("own.dat"), "\n") == 4);  // a comment and three points
}

TEST_CASE("A label keeps its colour in all panels of a figure") {
  const auto from = experiment();
  const auto files = draw_figure(figure(from, "analysis"), from, "analysis");
  const auto colour_after = [&](const std::string& start) {
    const auto place = files.script.find("#", files.script.find("lc rgb", files.script.find(start)));
    return files.script.substr(place, 7);
  };
  const std::string kappa = colour_after("'analysis-1.dat' index 0");
  CHECK(kappa == colour_after("'analysis-2.dat' index 0"));
  CHECK(kappa == colour_after("'analysis-3.dat' index 0"));
  CHECK(kappa == colour_after("'analysis-4.dat' index 0"));
  CHECK(kappa != colour_after("'analysis-1.dat' index 3"));
}

TEST_CASE("A huge peak of curvature is cut off, and the panel says how large it is") {
  const auto from = experiment();
  auto comb = panel_of("curve", {3});
  comb.comb = true;
  CHECK(has(one_panel(comb, from).script, "comb cut at |κ| = "));
  const auto& kappa = from.cells[3].curves[0].sample_kappa;
  const auto reached = fmt::format("off the scale: |κ| reaches {:.3g}", *std::max_element(kappa.begin(), kappa.end()));
  CHECK(has(one_panel(panel_of("curvature", {3}), from).script, reached));
  CHECK_FALSE(has(one_panel(panel_of("curvature", {0}), from).script, "off the scale"));
}

TEST_CASE("Teeth are proportional to curvature and stand on the outer side") {
  auto from = experiment();
  auto& curve = from.cells[0].curves[0];
  auto panel = panel_of("curve", {0});
  panel.comb = true;
  panel.comb_scale = 0.5;
  const std::string data = one_panel(panel, from).data.at("own.dat");
  double x = 0, y = 0, dx = 0, dy = 0;
  REQUIRE(std::sscanf(data.c_str(), "# comb: x y dx dy\n%lf %lf %lf %lf", &x, &y, &dx, &dy) == 4);
  double largest = 0, xmin = 1e9, xmax = -1e9, ymin = 1e9, ymax = -1e9;
  for (const double kappa : curve.sample_kappa) largest = std::max(largest, std::abs(kappa));
  for (const double px : curve.point_x) xmin = std::min(xmin, px), xmax = std::max(xmax, px);
  for (const double py : curve.point_y) ymin = std::min(ymin, py), ymax = std::max(ymax, py);
  const double scale = 0.5 * std::max(xmax - xmin, ymax - ymin) / largest;
  CHECK(dx == Approx(-scale * curve.sample_kappa[0] * curve.sample_normal_x[0]).epsilon(1e-6));
  CHECK(dy == Approx(-scale * curve.sample_kappa[0] * curve.sample_normal_y[0]).epsilon(1e-6));
  CHECK(x * dx + y * dy > 0);  // outwards, where the curve bends around the origin
}

TEST_CASE("Nodes with the marks pinned and at_inflection are drawn, other marks are not") {
  auto from = experiment();
  auto& curve = from.cells[0].curves[0];
  const auto panel = panel_of("curve", {0});
  const auto drawn = one_panel(panel, from);
  for (const char* what : {"pinned node", "node at an inflection"}) {
    CHECK(has(drawn.script, what));
    CHECK(has(drawn.data.at("own.dat"), std::string("# ") + what + ": x y"));
  }
  for (std::string& marks : curve.node_marks) marks = "unpinned curvature_minimum pinned_not";
  const auto plain = one_panel(panel, from);
  CHECK_FALSE(has(plain.script, "pinned node"));
  CHECK_FALSE(has(plain.script, "node at an inflection"));
}

TEST_CASE("Convergence is logarithmic with a floor") {
  const auto files = one_panel(panel_of("convergence", {0}), experiment());
  CHECK(has(files.script, "set logscale y"));
  CHECK(has(files.data.at("own.dat"), "24 1e-17"));
  CHECK(has(files.script, "residual 0 is drawn at 1e-17"));
}

TEST_CASE("A slope is the exponent on log axes") {
  auto from = experiment();
  std::vector<double> n, t;
  for (int i = 1; i <= 6; ++i) n.push_back(i), t.push_back(3.0 * i * i);
  from.tables = {{"t", "", "", {{"n", "1", "", n, true}, {"time", "s", "", t, false}}}};
  auto panel = panel_of("graph", {});
  panel.table = "t", panel.x = "n", panel.y = {"time"};
  panel.log_x = panel.log_y = panel.slope = true;
  CHECK(has(one_panel(panel, from).script, "time (slope 2.00)"));
  std::get<std::vector<double>>(from.tables[0].columns[1].cells)[2] = -1.0;
  CHECK(has(one_panel(panel, from).script, "1 of 6 points are undefined and not shown"));
}

TEST_CASE("References that lead nowhere are named") {
  const auto from = experiment();
  const auto message = [&](const store::PanelRecord& panel) -> std::string {
    try {
      (void)one_panel(panel, from);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  CHECK(has(message(panel_of("curve", {99})), "no cell 99"));
  CHECK(has(message(panel_of("pie", {})), "unknown kind of panel 'pie'"));
  auto graph = panel_of("graph", {});
  graph.table = "none";
  CHECK(has(message(graph), "no table 'none'"));
  graph.table = "energies", graph.x = "missing", graph.y = {"energy"};
  CHECK(has(message(graph), "no column 'missing'"));
  graph.x = "drawing", graph.y = {"scheme"};
  CHECK(has(message(graph), "words, not numbers"));
  auto window = panel_of("curve", {0});
  window.window = {1.0, 0.0, 0.0, 1.0};
  CHECK(has(message(window), "window"));
}

TEST_CASE("Words of the user cannot become commands") {
  auto from = experiment();
  from.cells[0].label = "it's `rm` \"x\"\n} {_^";
  auto panel = panel_of("curve", {0});
  panel.title = "a'\nquit";
  const auto files = one_panel(panel, from);
  CHECK(has(files.script, "'a'' quit'"));
  CHECK(has(files.script, "'it''s `rm` \"x\" } {_^'"));
}

TEST_CASE("gnuplot draws every figure without a word") {
  const ScratchFolder folder;
  if (!run_gnuplot(folder.path(), "/dev/null").installed) {
    WARN("gnuplot is not installed: drawing is not tested");
    return;
  }
  auto from = experiment();
  from.cells[0].label = "it's `x` {_^ \"q\" <&> κ";
  from.figures[0].panels[0].title = "a < b & 'c' @ {d}_e^f";
  from.figures.push_back(
      {"empty", "", "", 0, {panel_of("curve", {}), panel_of("convergence", {4}), panel_of("curvature", {4})}});
  for (const auto& drawn : from.figures) {
    const auto files = draw_figure(drawn, from, drawn.id);
    std::ofstream(folder.path() / (drawn.id + ".gp")) << files.script;
    for (const auto& [name, text] : files.data) std::ofstream(folder.path() / name) << text;
    CHECK(run_gnuplot(folder.path(), drawn.id + ".gp").problem == "");
    const std::string svg = synthetic::read_text(folder.path() / (drawn.id + ".svg"));
    CHECK(has(svg, "</svg>"));
    CHECK(synthetic::read_text(folder.path() / (drawn.id + ".png")).substr(1, 3) == "PNG");
    CHECK(run_gnuplot(folder.path(), drawn.id + ".gp").problem == "");
    CHECK(synthetic::read_text(folder.path() / (drawn.id + ".svg")) == svg);
  }
}

TEST_CASE("gnuplot's complaints and absence are told") {
  const ScratchFolder folder;
  const auto absent = run_gnuplot(folder.path(), "x.gp", "no-such-gnuplot");
  CHECK_FALSE(absent.installed);
  CHECK(has(absent.problem, "install the package gnuplot"));
  if (!run_gnuplot(folder.path(), "/dev/null").installed) return;
  std::ofstream(folder.path() / "bad.gp") << "plot 'nowhere.dat'\n";
  const auto bad = run_gnuplot(folder.path(), "bad.gp");
  CHECK(bad.installed);
  CHECK(has(bad.problem, "bad.gp"));
  CHECK(gnuplot_version(folder.path()).find('.') != std::string::npos);
  CHECK(gnuplot_version(folder.path(), "no-such-gnuplot").empty());
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);  // bad.gp alone
}
