// Miura 2022, Fig. 2: do points added beside a point make its curvature peak sharper, or flatter?
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "datasets/datasets.hpp"
#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/selection.hpp"

namespace kappabench {
namespace {

using namespace miura;
using study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Table, study::Tally;

constexpr std::string_view about =
    "The only handle on the size of a curvature peak of a κ-curve is to add points beside it. Drawn as in the paper, "
    "with the points added by hand, and repeated at points of all drawings with a simple rule: beside the point on its "
    "chords, to sharpen, or on the parallel to the chord of its neighbours, to flatten.";

/// Fig. 2 (a), (b), (c): sharper, as it is, flatter; all meet point 0.
struct Version {
  std::string_view dataset;
  std::string_view label;
};
constexpr std::array<Version, 3> versions{{{"five-blob-sharper", "two points added to sharpen"},
                                           {"five-blob", "original κ-curve"},
                                           {"five-blob-flatter", "two points added to flatten"}}};

// ---- what is measured

/// Where the added points lie, as a part of the way to the neighbours.
constexpr double along_chords = 0.2, along_parallel = 0.5;
constexpr int points_tried = 8;
/// Larger curves are left out, where every fit takes long.
constexpr int most_points = 100;

constexpr std::string_view sharpen = "sharpen", flatten = "flatten";
const Key added_to{"added to"};
const Quantity ratio{"curvature over that without", "1", Method::exact};

/// Both added points, before and after point i of a closed or open curve.
Input with_added(const Input& input, int i, std::string_view purpose) {
  const auto point = [&](int k) { return input.points[static_cast<std::size_t>((k + input.size()) % input.size())]; };
  const Vec2 p = point(i), before = point(i - 1), after = point(i + 1);
  const Vec2 direction = along_parallel * 0.5 * (after - before);
  const bool on_chords = purpose == sharpen;
  Input result{.points = input.points, .closed = input.closed};
  const auto here = result.points.begin() + i;
  const auto first =
      result.points.insert(here, on_chords ? Vec2(p + along_chords * (before - p)) : Vec2(p - direction));
  result.points.insert(first + 2, on_chords ? Vec2(p + along_chords * (after - p)) : Vec2(p + direction));
  return result;
}

double curvature_at_point(const Fit& fit, int point) {
  if (study::solved(fit))
    for (const Node& node : fit.curve->nodes())
      if (node.point == point) return curvature_at(*fit.curve, node);
  return undefined;
}

void measure(const Uses& uses, const Input& input, Notes& notes) {
  if (input.size() > most_points) return;
  const Scheme& kappa = *uses.schemes.front();
  const Fit plain = kappa.fit(input);
  if (!study::solved(plain)) return;
  const int first = input.closed ? 0 : 1, inner = input.closed ? input.size() : input.size() - 2;
  for (const int k : evenly(inner, points_tried)) {
    const int point = first + k;
    for (const std::string_view purpose : {sharpen, flatten}) {
      const double after = curvature_at_point(kappa.fit(with_added(input, point, purpose)), point + 1);
      notes.row({point_key(point), added_to(purpose)}, {ratio(after / curvature_at_point(plain, point))});
    }
  }
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const SchemePtr kappa = context.registry.create("kappa");
  for (const Version& version : versions)
    for (const Drawing& drawing : open_drawings(version.dataset))
      jobs.push_back(fit_job(drawing, kappa, {}, std::string(version.label)));
  for (const Drawing& drawing : study::drawings_of(context))
    jobs.push_back(study::curves_job<measure>({.work = "added points", .schemes = {kappa}, .drawings = {drawing}}));
  return jobs;
}

// ---- what follows

/// Curvature at the point that all versions share, which is the first of each.
double curvature_at_top(const Findings& found, const Version& version) {
  const auto cell = found.find(version.dataset, version.label);
  const store::CurveRecord* curve = cell ? found.curve(*cell) : nullptr;
  for (std::size_t i = 0; curve != nullptr && i < curve->node_point.size(); ++i)
    if (curve->node_point[i] == 0) return curve->node_kappa[i];
  return undefined;
}

std::vector<double> ratios(const Findings& found, std::string_view purpose) {
  return defined(found.rows().where({added_to(purpose)}).values(ratio));
}

Tally raised(const Findings& found, std::string_view purpose) {
  return study::tally_of(ratios(found, purpose), [](double r) { return r > 1.0; });
}

Table drawn_table(const Findings& found) {
  Table table("figure", "Curvature at the point between the added ones",
              "κ-curves of Fig. 2: κ at point 0 per drawing unit, and over that of the original; a negative "
              "ratio means that the curve bends the other way there.");
  table.words("drawing").words("curve").numbers("κ", "1/length").numbers("over the original");
  for (const Version& version : versions) {
    const double kappa = curvature_at_top(found, version);
    table.row({version.dataset, version.label, kappa, kappa / curvature_at_top(found, versions[1])});
  }
  return table;
}

Table rule_table(const Findings& found) {
  Table table("rule", "Two points added by a rule at points of all drawings",
              "|κ| of the κ-curve at the point, with over without the added points; up to eight points of curves of at "
              "most 100. Sharpen: 20 % of the way along both chords. Flatten: a quarter of the chord of the neighbours "
              "to either side, parallel to it.");
  table.words("added to").counts("cases").counts("larger |κ|").counts("not larger").numbers("median ratio");
  for (const std::string_view purpose : {sharpen, flatten}) {
    const Tally larger = raised(found, purpose);
    table.row({purpose, larger.cases, larger.agree, larger.misses(), median(ratios(found, purpose))});
  }
  return table;
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{.id = "ekappa-added-points",
                             .title = "Added points and the size of a curvature peak",
                             .caption =
                                 "The original κ-curve in the middle; with two more points beside the top one, its "
                                 "curvature is larger (left) or smaller (right). Combs have one length for the "
                                 "longest tooth in each panel; the table has the numbers.",
                             .columns = 3};
  for (const Version& version : versions)
    if (const auto cell = found.find(version.dataset, version.label))
      figure.panels.push_back(Panel::curves({*cell}, std::string(version.label)).comb());
  return figure;
}

void claim_handle(Findings& found) {
  const double plain = curvature_at_top(found, versions[1]);
  const double sharper = curvature_at_top(found, versions[0]) / plain;
  const double flatter = curvature_at_top(found, versions[2]) / plain;
  Tally drawn;
  drawn.add(std::abs(sharper) > 1.0);
  drawn.add(std::abs(flatter) < 1.0);
  const Tally up = raised(found, sharpen), down = raised(found, flatten);
  found.judge(
      "extra-points-control-curvature", drawn,
      {fmt::format("κ times {:.3g} with two points added to sharpen, {:.3g} to flatten{}", sharper, flatter,
                   flatter < 0.0 ? " (it bends the other way there)" : ""),
       fmt::format("Our stand-in for Fig. 2, points added by hand. By a fixed rule at points of all drawings the "
                   "added points raise |κ| in {} cases (on the chords) and do not raise it in {} (parallel to "
                   "the chord of the neighbours): a handle, but one that has to be tried out.",
                   up.words(), study::share(down.misses(), down.cases))});
}

void conclude(Findings& found) {
  found.add(drawn_table(found));
  found.add(rule_table(found));
  found.add(figure(found));
  claim_handle(found);
}

}  // namespace

Experiment ekappa_added_points_experiment() {
  return study::experiment({.id = "ekappa-added-points",
                            .title = "Added points to control curvature (Miura 2022, Fig. 2)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"extra-points-control-curvature"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
