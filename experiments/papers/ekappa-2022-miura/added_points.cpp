#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "datasets/datasets.hpp"
#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/study/selection.hpp"
#include "experiments/study/study.hpp"
#include "experiments/study/summaries.hpp"
#include "experiments/study/verdicts.hpp"

namespace kappabench {

using namespace miura;
using namespace study;

namespace {

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

/// Where the added points lie, as a part of the way to the neighbours.
constexpr double along_chords = 0.2, along_parallel = 0.5;
constexpr int points_tried = 8;
/// Larger curves are left out, where every fit takes long.
constexpr int most_points = 100;

/// Both added points, before and after point i of a closed or open curve.
Input with_added(const Input& input, int i, bool sharper) {
  const int n = input.size();
  const Vec2& p = input.points[static_cast<std::size_t>(i)];
  const Vec2& before = input.points[static_cast<std::size_t>((i + n - 1) % n)];
  const Vec2& after = input.points[static_cast<std::size_t>((i + 1) % n)];
  const Vec2 direction = along_parallel * 0.5 * (after - before);
  const Vec2 first = sharper ? Vec2(p + along_chords * (before - p)) : Vec2(p - direction);
  const Vec2 second = sharper ? Vec2(p + along_chords * (after - p)) : Vec2(p + direction);
  Input result{.points = {}, .closed = input.closed, .options = {}, .ids = {}};
  for (int k = 0; k < n; ++k) {
    if (k == i) result.points.push_back(first);
    result.points.push_back(input.points[static_cast<std::size_t>(k)]);
    if (k == i) result.points.push_back(second);
  }
  return result;
}

double curvature_at_point(const Fit& fit, int point) {
  if (solved(fit))
    for (const Node& node : fit.curve->nodes())
      if (node.point == point) return curvature_at(*fit.curve, node);
  return std::numeric_limits<double>::quiet_NaN();
}

void measure_curve(const Scheme& kappa, const Input& input, store::CellRecord& cell) {
  const Fit plain = kappa.fit(input);
  if (!solved(plain)) return;
  const int first = input.closed ? 0 : 1, inner = input.closed ? input.size() : input.size() - 2;
  for (const int k : evenly(inner, points_tried)) {
    const int point = first + k;
    const double before = curvature_at_point(plain, point);
    for (const bool sharper : {true, false}) {
      const double after = curvature_at_point(kappa.fit(with_added(input, point, sharper)), point + 1);
      put(cell, sharper ? "sharpened" : "flattened", after / before);
    }
  }
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const SchemePtr kappa = context.registry.create("kappa");
  for (const Version& version : versions)
    for (const Drawing& drawing : open_drawings(version.dataset))
      jobs.push_back(drawn_job(drawing, kappa, std::string(version.label)));
  for (const Drawing& drawing : study::drawings_of(context))
    jobs.push_back(
        study_job(drawing, kappa, "added points", 1, [kappa](const Drawing& points, store::CellRecord& cell) {
          for (const Input& input : points.curves)
            if (input.size() <= most_points) measure_curve(*kappa, input, cell);
        }));
  return jobs;
}

// ---- from the finished cells

/// Curvature at the point that all versions share, which is the first of each.
double curvature_at_top(const store::ExperimentRecord& record, const Version& version) {
  if (const auto index = drawn_cell(record, version.dataset, version.label)) {
    const store::CellRecord& cell = record.cells[static_cast<std::size_t>(*index)];
    for (const store::CurveRecord& curve : cell.curves)
      for (std::size_t i = 0; i < curve.node_point.size(); ++i)
        if (curve.node_point[i] == 0) return curve.node_kappa[i];
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Ratios that are defined, and how many are above 1.
struct Ratios {
  std::vector<double> all;
  double larger = 0.0;
  [[nodiscard]] double cases() const { return static_cast<double>(all.size()); }
};

Ratios ratios(const store::ExperimentRecord& record, std::string_view column) {
  Ratios found;
  for (const double value : values(record, column)) {
    if (std::isnan(value)) continue;
    found.all.push_back(value);
    found.larger += value > 1.0 ? 1.0 : 0.0;
  }
  return found;
}

store::TableRecord drawn_table(const store::ExperimentRecord& record) {
  TableBuilder builder("figure", "Curvature at the point between the added ones",
                       "κ-curves of Fig. 2: κ at point 0 per drawing unit, and over that of the original; a negative "
                       "ratio means that the curve bends the other way there.");
  builder.words("drawing").words("curve").numbers("κ", "1/length").numbers("over the original");
  for (const Version& version : versions) {
    const double kappa = curvature_at_top(record, version);
    builder.row({std::string(version.dataset), std::string(version.label), kappa,
                 kappa / curvature_at_top(record, versions[1])});
  }
  return builder.table();
}

store::TableRecord rule_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "rule", "Two points added by a rule at points of all drawings",
      "|κ| of the κ-curve at the point, with over without the added points; up to eight points of curves of at most "
      "100. Sharpen: 20 % of the way along both chords. Flatten: a quarter of the chord of the neighbours to either "
      "side, parallel to it.");
  builder.words("added to").counts("cases").counts("larger |κ|").counts("not larger").numbers("median ratio");
  for (const auto& [words, column] : {std::pair("sharpen", "sharpened"), std::pair("flatten", "flattened")}) {
    const Ratios found = ratios(record, column);
    builder.row({std::string(words), found.cases(), found.larger, found.cases() - found.larger, median(found.all)});
  }
  return builder.table();
}

std::optional<store::FigureRecord> figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{.id = "ekappa-added-points",
                             .title = "Added points and the size of a curvature peak",
                             .caption =
                                 "The original κ-curve in the middle; with two more points beside the top one, its "
                                 "curvature is larger (left) or smaller (right). Combs have one length for the "
                                 "longest tooth in each panel; the table has the numbers.",
                             .columns = 3,
                             .panels = {}};
  for (const Version& version : versions) {
    const auto index = drawn_cell(record, version.dataset, version.label);
    if (!index) return std::nullopt;
    store::PanelRecord panel{.kind = "curve", .title = std::string(version.label), .cells = {*index}};
    panel.comb = true;
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

store::ClaimRecord added_claim(const store::ExperimentRecord& record) {
  const double plain = curvature_at_top(record, versions[1]);
  const double sharper = curvature_at_top(record, versions[0]) / plain;
  const double flatter = curvature_at_top(record, versions[2]) / plain;
  const double agree = (std::abs(sharper) > 1.0 ? 1.0 : 0.0) + (std::abs(flatter) < 1.0 ? 1.0 : 0.0);
  const Ratios up = ratios(record, "sharpened"), down = ratios(record, "flattened");
  return claim(
      "extra-points-control-curvature", verdict_for_all(2.0 - agree, 2.0),
      fmt::format("κ times {:.3g} with two points added to sharpen, {:.3g} to flatten{}", sharper, flatter,
                  flatter < 0.0 ? " (it bends the other way there)" : ""),
      fmt::format(
          "Our stand-in for Fig. 2, points added by hand. By a fixed rule at points of all drawings the added "
          "points raise |κ| in {} cases (on the chords) and do not raise it in {} (parallel to the chord of the "
          "neighbours): a handle, but one that has to be tried out.",
          share(up.larger, up.cases()), share(down.cases() - down.larger, down.cases())));
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {drawn_table(record), rule_table(record)};
  if (auto drawn = figure(record)) record.figures.push_back(std::move(*drawn));
  record.claims = {added_claim(record)};
}

}  // namespace

Experiment ekappa_added_points_experiment() {
  return {.id = "ekappa-added-points",
          .title = "Added points to control curvature (Miura 2022, Fig. 2)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
