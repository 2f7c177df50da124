#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "experiments/papers/ekappa-2022-miura/applicability_bases.hpp"
#include "experiments/papers/ekappa-2022-miura/basis_identities.hpp"
#include "experiments/study/summaries.hpp"
#include "reports/paper.hpp"

namespace kappabench {

namespace {

constexpr std::string_view paper_id = "ekappa-2022-miura";
constexpr std::string_view about =
    "The method needs a segment over three control points whose curvature at its ends is not zero, or no joint can "
    "balance the curvatures of its two sides. For every basis of Appendix C, and for the two that the paper uses, end "
    "curvatures are computed from the blending functions' own derivatives, over three triangles of control points, and "
    "measured in units of the curvature in the middle. The change of the blending functions over the whole range of "
    "the shape parameter is their largest difference between any two values. The statements about the trigonometric "
    "basis are checked on grids and random control points (seeded).";

/// Raise when the cells hold something else.
constexpr int version = 1;

/// Below this part of the curvature in the middle an end curvature is rounding.
constexpr double vanishing = 1e-9;

/// Blending functions are compared, and stored for Fig. 14, at k / grid.
constexpr int grid = 40;
double grid_point(int k) { return static_cast<double>(k) / grid; }

constexpr std::array<const char*, 3> function_columns{"A0", "A1", "A2"};

/// Right-angled with equal legs; flat and lopsided; sharp.
const std::array<std::array<Vec2, 3>, 3>& triangles() {
  static const std::array<std::array<Vec2, 3>, 3> all{{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)},
                                                       {Vec2(0, 0), Vec2(1, 0.3), Vec2(4, 0)},
                                                       {Vec2(0, 0), Vec2(3, 1), Vec2(0.5, 1.2)}}};
  return all;
}

void put(store::CellRecord& cell, std::string column, double value) {
  cell.measurements.push_back({std::move(column), value, "sampled", "1"});
}

std::vector<double> all(const store::CellRecord& cell, std::string_view column) {
  std::vector<double> values;
  for (const store::MeasurementRecord& m : cell.measurements)
    if (m.column == column) values.push_back(m.value);
  return values;
}

/// Everything about one basis; per shape parameter one value a column, but the function columns have grid + 1.
void study(const DegenerateBasis& basis, store::CellRecord& cell) {
  for (const double alpha : basis.parameters) {
    double start = 0.0, end = 0.0, least = 1e300;
    for (const auto& triangle : triangles()) {
      const auto kappa = [&](double t) { return std::abs(curvature(degenerate_curve(basis, alpha, triangle, t))); };
      const double middle = kappa(0.5);
      start = std::max(start, kappa(0.0) / middle);
      end = std::max(end, kappa(1.0) / middle);
      least = std::min({least, kappa(0.0) / middle, kappa(1.0) / middle});
    }
    put(cell, "parameter", alpha);
    put(cell, "largest curvature at 0", start);
    put(cell, "largest curvature at 1", end);
    put(cell, "least end curvature", least);
    put(cell, "curvature in the middle", std::abs(curvature(degenerate_curve(basis, alpha, triangles()[0], 0.5))));
    double least_value = 1.0;
    for (int k = 0; k <= grid; ++k) {
      const auto b = blending_functions(basis, alpha, grid_point(k));
      for (std::size_t j = 0; j < 3; ++j) {
        put(cell, function_columns[j], b[j].value);
        least_value = std::min(least_value, b[j].value);
      }
    }
    put(cell, "least value", least_value);
  }
}

void check_identities(store::CellRecord& cell) {
  for (const Identity& identity : basis_identities()) put(cell, identity.name, identity.largest_deviation());
  for (const std::vector<double>& row : blending_triangle(6))
    for (const double coefficient : row) put(cell, "triangle", coefficient);
}

CellJob job(std::string dataset, std::string label, const SchemePtr& scheme,
            std::function<void(store::CellRecord&)> compute) {
  CellJob job =
      other_job(std::move(dataset), scheme, fmt::format("applicability {} of {}", version, label), std::move(compute));
  job.label = std::move(label);
  return job;
}

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr scheme = context.registry.create("ekappa-trig");
  std::vector<CellJob> jobs;
  for (const DegenerateBasis& basis : degenerate_bases())
    jobs.push_back(job(basis.id, basis.title, scheme, [&basis](store::CellRecord& cell) { study(basis, cell); }));
  jobs.push_back(job("identities", "identities of the trigonometric basis", scheme, check_identities));
  return jobs;
}

/// A basis with its finished cell.
struct Studied {
  const DegenerateBasis* basis;
  const store::CellRecord* cell;
  std::vector<double> parameters;

  [[nodiscard]] std::size_t size() const { return parameters.size(); }
  [[nodiscard]] double at(std::string_view column, std::size_t k) const { return all(*cell, column)[k]; }
  [[nodiscard]] double start(std::size_t k) const { return at("largest curvature at 0", k); }
  [[nodiscard]] double end(std::size_t k) const { return at("largest curvature at 1", k); }
  [[nodiscard]] bool vanishes(std::size_t k) const { return std::max(start(k), end(k)) < vanishing; }
  /// Curvature at both ends of all triangles.
  [[nodiscard]] bool applies(std::size_t k) const { return at("least end curvature", k) > vanishing; }
};

std::vector<Studied> studied(const store::ExperimentRecord& record) {
  std::vector<Studied> result;
  for (const DegenerateBasis& basis : degenerate_bases())
    for (const store::CellRecord& cell : record.cells)
      if (cell.dataset == basis.id && !cell.measurements.empty())
        result.push_back({&basis, &cell, all(cell, "parameter")});
  return result;
}

const Studied* find(const std::vector<Studied>& bases, std::string_view id) {
  const auto found = std::ranges::find_if(bases, [&](const Studied& s) { return s.basis->id == id; });
  return found == bases.end() ? nullptr : &*found;
}

/// Largest difference of a blending function between two shape parameters, over all pairs.
double change(const Studied& s) {
  double largest_change = 0.0;
  for (const char* column : function_columns) {
    const std::vector<double> values = all(*s.cell, column);
    for (std::size_t k = 0; k <= grid; ++k) {
      double low = 1e300, high = -1e300;
      for (std::size_t p = 0; p < s.size(); ++p) {
        low = std::min(low, values[p * (grid + 1) + k]);
        high = std::max(high, values[p * (grid + 1) + k]);
      }
      largest_change = std::max(largest_change, high - low);
    }
  }
  return largest_change;
}

store::TableRecord curvature_table(const std::vector<Studied>& bases) {
  TableBuilder builder(
      "end-curvatures", "Curvature at the ends of degenerate segments",
      "Largest over three triangles of control points, over the curvature in the middle. 'applicable': "
      "not zero at both ends. A negative least value: the basis leaves the triangle.");
  builder.words("basis").words("place").numbers("shape parameter").numbers("curvature at 0").numbers("curvature at 1");
  builder.words("applicable").numbers("least blending value").numbers("curvature in the middle");
  for (const Studied& s : bases)
    for (std::size_t k = 0; k < s.size(); ++k)
      builder.row({s.basis->title, s.basis->place, s.parameters[k], s.start(k), s.end(k),
                   std::string(s.applies(k)    ? "yes"
                               : s.vanishes(k) ? "no"
                                               : "in part"),
                   s.at("least value", k), s.at("curvature in the middle", k)});
  return builder.table();
}

store::TableRecord basis_table(const std::vector<Studied>& bases) {
  TableBuilder builder("bases", "How much the shape parameter does",
                       "Change: the largest difference of a blending function between two shape parameters of the "
                       "table above. Curvature in the middle: of the right-angled triangle, from least to largest.");
  builder.words("basis").words("place").numbers("from").numbers("to").counts("parameters").counts("applicable");
  builder.numbers("change of the functions").numbers("least curvature").numbers("largest curvature");
  for (const Studied& s : bases) {
    double applicable = 0;
    for (std::size_t k = 0; k < s.size(); ++k) applicable += s.applies(k);
    const std::vector<double> middle = all(*s.cell, "curvature in the middle");
    builder.row({s.basis->title, s.basis->place, s.parameters.front(), s.parameters.back(),
                 static_cast<double>(s.size()), applicable, change(s), *std::ranges::min_element(middle),
                 *std::ranges::max_element(middle)});
  }
  return builder.table();
}

std::string function_table_id(const Studied& s) { return "functions-" + s.basis->id; }

/// A_1 and A_2 (A_0 is the mirror image of A_2) for the first, a middle and the last shape parameter, for a graph.
store::TableRecord function_table(const Studied& s) {
  TableBuilder builder(function_table_id(s), fmt::format("Blending functions, {}", s.basis->title), "");
  builder.numbers("t").words("parameter").numbers("value of it").numbers("A1").numbers("A2");
  const std::vector<double> inner = all(*s.cell, function_columns[1]), last = all(*s.cell, function_columns[2]);
  const std::array<std::pair<const char*, std::size_t>, 3> chosen{
      {{"least", 0}, {"middle", s.size() / 2}, {"largest", s.size() - 1}}};
  for (const auto& [word, p] : chosen)
    for (int k = 0; k <= grid; ++k) {
      const std::size_t i = p * (grid + 1) + static_cast<std::size_t>(k);
      builder.row({grid_point(k), std::string(word), s.parameters[p], inner[i], last[i]});
    }
  return builder.table();
}

store::TableRecord identity_table(const store::CellRecord& cell) {
  TableBuilder builder("identities", "Statements about the bases, checked numerically",
                       "Largest deviation over grids of t and a, or over random control points.");
  builder.words("statement").words("place").numbers("largest deviation");
  for (const Identity& identity : basis_identities())
    builder.row({identity.name, identity.place, measured(cell, identity.name).value_or(std::nan(""))});
  return builder.table();
}

store::ClaimRecord claim(std::string id, std::string verdict, std::string ours, std::string evidence) {
  return {std::string(paper_id), std::move(id), std::move(verdict), std::move(ours), std::move(evidence)};
}

/// Whether the statement "curvature at the ends exactly for these parameters" is true of every parameter looked at.
template <class Predicate>
store::ClaimRecord applicability_claim(std::string id, const Studied& s, const Predicate& said_to_apply,
                                       std::string_view remark) {
  std::string wrong;
  int agree = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    if (said_to_apply(s.parameters[k]) ? s.applies(k) : s.vanishes(k))
      ++agree;
    else
      wrong += fmt::format("{}{:.3g} (end curvature {:.2g} of the middle's)", wrong.empty() ? "" : ", ",
                           s.parameters[k], std::max(s.start(k), s.end(k)));
  }
  return claim(std::move(id), wrong.empty() ? "reproduced" : "contradicted",
               fmt::format("{} of {} shape parameters as stated", agree, s.size()),
               fmt::format("End curvatures over three triangles of control points{}{}.{}{}",
                           wrong.empty() ? "" : "; not as stated: ", wrong, remark.empty() ? "" : " ", remark));
}

/// "Hardly": at most a quarter of what the paper's own basis changes from a = 2/3 to 0.95.
store::ClaimRecord c_bezier_claim(const Studied& c_bezier, const Studied& bernstein) {
  constexpr double hardly = 0.25;
  const double theirs = change(c_bezier), own = change(bernstein);
  int vanish = 0;
  for (std::size_t k = 0; k < c_bezier.size(); ++k) vanish += c_bezier.vanishes(k);
  return claim("c-bezier-unsuitable", theirs <= hardly * own ? "reproduced" : "not reproduced",
               fmt::format("functions change by {:.3f}, {:.0f} % of the Bernstein basis's {:.3f}", theirs,
                           100.0 * theirs / own, own),
               fmt::format("Compared with a from 2/3 to 0.95; 'hardly' is taken as at most {:.0f} %. The basis is "
                           "unsuitable for another reason: both end curvatures vanish for {} of {} parameters.",
                           100.0 * hardly, vanish, c_bezier.size()));
}

/// Deviations of several identities against rounding.
store::ClaimRecord identity_claim(std::string id, const store::CellRecord& cell,
                                  std::span<const std::string_view> names, std::string evidence) {
  constexpr double rounding = 1e-12;
  double worst = 0.0;
  for (const std::string_view name : names) {
    const double deviation = measured(cell, name).value_or(INFINITY);
    worst = std::isnan(deviation) ? INFINITY : std::max(worst, deviation);
  }
  return claim(std::move(id), worst <= rounding ? "reproduced" : "contradicted",
               fmt::format("largest deviation {:.2g}", worst), std::move(evidence));
}

/// Eq. (43) against the rows that the paper prints.
std::optional<store::ClaimRecord> triangle_claim(const store::CellRecord& cell) {
  const Paper& paper = printed_paper(paper_id);
  const auto table = std::ranges::find(paper.tables, "triangle", &PrintedTable::id);
  if (table == paper.tables.end()) return std::nullopt;
  const std::vector<double> ours = all(cell, "triangle");
  std::vector<std::string> rows(table->rows.size());
  std::size_t next = 0, equal = 0;
  for (std::size_t degree = 1; degree <= rows.size(); ++degree) {
    for (std::size_t k = 0; k < 2 * degree + 1 && next < ours.size(); ++k)
      rows[degree - 1] += fmt::format("{}{:.0f}", k == 0 ? "" : " ", ours[next++]);
    equal += rows[degree - 1] == table->rows[degree - 1].back();
  }
  return claim("blending-triangle", equal == rows.size() ? "reproduced" : "contradicted",
               fmt::format("{} of {} rows equal", equal, rows.size()), "From the powers of u + v + w with v^2 = 2uw.");
}

store::FigureRecord function_figure(const std::vector<Studied>& shown) {
  store::FigureRecord figure{
      .id = "ekappa-applicability",
      .title = "Blending functions over the range of the shape parameter",
      .caption =
          "The C-Bézier basis that Fig. 14 of the paper shows beside the two bases that the paper uses. A1 and "
          "A2 for the least, a middle and the largest shape parameter; A0 is the mirror image of A2.",
      .columns = 3,
      .panels = {}};
  for (const Studied& s : shown)
    figure.panels.push_back(
        {.kind = "graph",
         .title = fmt::format("{}: {:.3g} to {:.3g}", s.basis->brief, s.parameters.front(), s.parameters.back()),
         .table = function_table_id(s),
         .x = "t",
         .y = {"A1", "A2"},
         .series = "parameter",
         .x_label = "t",
         .y_label = "blending functions"});
  return figure;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  const std::vector<Studied> bases = studied(record);
  const auto identities = std::ranges::find(record.cells, "identities", &store::CellRecord::dataset);
  if (bases.size() != degenerate_bases().size() || identities == record.cells.end()) return;
  const Studied &c_bezier = *find(bases, "c-bezier"), &bernstein = *find(bases, "bernstein");
  record.tables = {basis_table(bases), curvature_table(bases), identity_table(*identities)};
  const std::vector<Studied> shown{c_bezier, bernstein, *find(bases, "trigonometric")};
  for (const Studied& s : shown) record.tables.push_back(function_table(s));
  record.figures = {function_figure(shown)};

  using Names = std::vector<std::string_view>;
  record.claims = {
      c_bezier_claim(c_bezier, bernstein),
      applicability_claim(
          "alternative-cubic-applicable", *find(bases, "cubic-alternative"), [](double alpha) { return alpha != 3.0; },
          "With alpha = 3a it is the basis of Section 3; beyond 3 the inner function outgrows 1, the "
          "outer ones go negative and curvature changes its sign inside the segment."),
      applicability_claim(
          "t-bezier-applicability", *find(bases, "t-bezier"), [](double alpha) { return alpha == 0.0; }, ""),
      applicability_claim(
          "alpha-beta-bernstein-applicability", *find(bases, "alpha-beta"), [](double alpha) { return alpha == 2.0; },
          "For 2 it is the quadratic Bézier segment."),
      identity_claim("trigonometric-square", *identities, Names{names::square}, "On a grid of t."),
      identity_claim("quadratic-blending-functions", *identities, Names{names::unity, names::negative},
                     "Sum, and how far below 0 the least value goes, on a grid of t."),
      identity_claim("trigonometric-same-as-built-in-shape", *identities, Names{names::built_in},
                     "Positions over random control points, over their size, a from 0.5 to 1."),
      identity_claim("recursive-evaluation", *identities, Names{names::recursion},
                     "Degrees 1 to 6, random control points, recursion against the coefficients of (43)."),
      identity_claim("trigonometric-circle", *identities, Names{names::circle},
                     "Radius and curvature of the segment over two equal perpendicular legs, a = 1/2.")};
  if (const auto verdict = triangle_claim(*identities)) record.claims.push_back(*verdict);
  const auto printed_and_corrected = [&](std::string id, std::string_view printed, std::string_view corrected) {
    store::ClaimRecord verdict = identity_claim(std::move(id), *identities, Names{printed}, "");
    verdict.evidence =
        fmt::format("Random control points or areas. With the correction the largest deviation is {:.2g} ({}).",
                    measured(*identities, corrected).value_or(std::nan("")), corrected);
    record.claims.push_back(std::move(verdict));
  };
  printed_and_corrected("trigonometric-linear-parameter", names::parameter_printed, names::parameter_corrected);
  printed_and_corrected("trigonometric-g2", names::ratio_printed, names::ratio_corrected);
}

}  // namespace

Experiment ekappa_applicability_experiment() {
  return {.id = "ekappa-applicability",
          .title = "Which bases the method applies to",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
