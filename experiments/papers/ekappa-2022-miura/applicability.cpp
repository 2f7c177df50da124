// Miura 2022, Appendix C and Fig. 14: which bases does the method apply to, and do the printed identities hold?
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/papers/ekappa-2022-miura/applicability_bases.hpp"
#include "experiments/papers/ekappa-2022-miura/basis_identities.hpp"
#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "metrics/statistics.hpp"
#include "reports/paper.hpp"

namespace kappabench {
namespace {

using namespace miura;
using study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Row, study::Rows, study::Table;

constexpr std::string_view about =
    "The method needs a segment over three control points whose curvature at its ends is not zero, or no joint can "
    "balance the curvatures of its two sides. For every basis of Appendix C, and for the two that the paper uses, end "
    "curvatures are computed from the blending functions' own derivatives, over three triangles of control points, and "
    "measured in units of the curvature in the middle. The change of the blending functions over the whole range of "
    "the shape parameter is their largest difference between any two values. The statements about the trigonometric "
    "basis are checked on grids and random control points (seeded).";

/// Below this part of the curvature in the middle an end curvature is rounding.
constexpr double vanishing = 1e-9;

/// Blending functions are compared, and stored for Fig. 14, at k / grid.
constexpr int grid = 40;

/// Right-angled with equal legs; flat and lopsided; sharp.
const std::array<std::array<Vec2, 3>, 3>& triangles() {
  static const std::array<std::array<Vec2, 3>, 3> all{{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)},
                                                       {Vec2(0, 0), Vec2(1, 0.3), Vec2(4, 0)},
                                                       {Vec2(0, 0), Vec2(3, 1), Vec2(0.5, 1.2)}}};
  return all;
}

// ---- what is measured

/// Of one basis, a row for each of its shape parameters: curvatures at the ends over that in the middle, ...
const Key parameter{"shape parameter"};
const Quantity at_start{"largest curvature at 0", "1", Method::sampled};
const Quantity at_end{"largest curvature at 1", "1", Method::sampled};
const Quantity least_at_ends{"least end curvature", "1", Method::sampled};
const Quantity in_the_middle{"curvature in the middle", "1/length", Method::exact};
const Quantity least_value{"least value", "1", Method::sampled};
/// ... and a row for each of them and t.
const Key at_t{"t"};
const std::array<Quantity, 3> functions{
    {{"A0", "1", Method::exact}, {"A1", "1", Method::exact}, {"A2", "1", Method::exact}}};

void measure_basis(const Uses& uses, Notes& notes) {
  const DegenerateBasis& basis = basis_named(uses.words.at("basis"));
  for (const double alpha : basis.parameters) {
    const auto kappa = [&](const std::array<Vec2, 3>& triangle, double t) {
      return std::abs(curvature(degenerate_curve(basis, alpha, triangle, t)));
    };
    std::vector<double> start, end, values;
    for (const auto& triangle : triangles()) {
      start.push_back(kappa(triangle, 0.0) / kappa(triangle, 0.5));
      end.push_back(kappa(triangle, 1.0) / kappa(triangle, 0.5));
    }
    for (int k = 0; k <= grid; ++k) {
      const double t = static_cast<double>(k) / grid;
      const auto b = blending_functions(basis, alpha, t);
      notes.row({parameter(alpha), at_t(t)},
                {functions[0](b[0].value), functions[1](b[1].value), functions[2](b[2].value)});
      for (const Blending& function : b) values.push_back(function.value);
    }
    notes.row({parameter(alpha)}, {at_start(std::ranges::max(start)), at_end(std::ranges::max(end)),
                                   least_at_ends(std::min(std::ranges::min(start), std::ranges::min(end))),
                                   in_the_middle(kappa(triangles()[0], 0.5)), least_value(std::ranges::min(values))});
  }
}

const Key statement{"statement"}, degree_key{"degree"}, place_key{"place"};
const Quantity deviation{"largest deviation", "1", Method::sampled};
/// Eq. (43).
const Quantity coefficient{"coefficient", "1", Method::exact};

void measure_identities(const Uses&, Notes& notes) {
  for (const Identity& identity : basis_identities())
    notes.row({statement(identity.name)}, {deviation(identity.largest_deviation())});
  const auto rows = blending_triangle(6);
  for (std::size_t n = 0; n < rows.size(); ++n)
    for (std::size_t k = 0; k < rows[n].size(); ++k)
      notes.row({degree_key(n + 1), place_key(k)}, {coefficient(rows[n][k])});
}

std::vector<CellJob> jobs(const Context&) {
  std::vector<CellJob> jobs;
  for (const DegenerateBasis& basis : degenerate_bases())
    jobs.push_back(study::numbers_job<measure_basis>(
        {.work = "end curvatures of a basis", .words = {{"basis", basis.id}}}, basis.id, basis.title));
  jobs.push_back(study::numbers_job<measure_identities>({.work = "identities of the trigonometric basis"}, "identities",
                                                        "identities of the trigonometric basis"));
  return jobs;
}

// ---- what follows

bool vanishes(const Row& row) { return std::max(row[at_start], row[at_end]) < vanishing; }
/// Curvature at both ends of all triangles.
bool applies(const Row& row) { return row[least_at_ends] > vanishing; }
double alpha_of(const Row& row) { return std::get<double>(row[parameter]); }

/// The rows of a basis for its shape parameters.
Rows ends(const Findings& found, std::string_view basis) {
  return found.rows().where({study::key::dataset(basis)}).where_row([](const Row& row) { return row.has(at_start); });
}

/// Largest difference of a blending function between two shape parameters, over all pairs.
double change(const Findings& found, std::string_view basis) {
  double most = 0.0;
  for (const auto& [t, rows] : found.rows().where({study::key::dataset(basis)}).by(at_t))
    for (const Quantity& function : functions) {
      const auto [low, high] = std::ranges::minmax(rows.values(function));
      most = std::max(most, high - low);
    }
  return most;
}

Table curvature_table(const Findings& found) {
  Table table("end-curvatures", "Curvature at the ends of degenerate segments",
              "Largest over three triangles of control points, over the curvature in the middle. 'applicable': "
              "not zero at both ends. A negative least value: the basis leaves the triangle.");
  table.words("basis").words("place").numbers("shape parameter").numbers("curvature at 0").numbers("curvature at 1");
  table.words("applicable").numbers("least blending value").numbers("curvature in the middle");
  for (const DegenerateBasis& basis : degenerate_bases())
    for (const Row* row : ends(found, basis.id))
      table.row({basis.title, basis.place, alpha_of(*row), (*row)[at_start], (*row)[at_end],
                 applies(*row)    ? "yes"
                 : vanishes(*row) ? "no"
                                  : "in part",
                 (*row)[least_value], (*row)[in_the_middle]});
  return table;
}

Table basis_table(const Findings& found) {
  Table table("bases", "How much the shape parameter does",
              "Change: the largest difference of a blending function between two shape parameters of the "
              "table above. Curvature in the middle: of the right-angled triangle, from least to largest.");
  table.words("basis").words("place").numbers("from").numbers("to").counts("parameters").counts("applicable");
  table.numbers("change of the functions").numbers("least curvature").numbers("largest curvature");
  for (const DegenerateBasis& basis : degenerate_bases()) {
    const Rows rows = ends(found, basis.id);
    const auto [low, high] = std::ranges::minmax(rows.values(in_the_middle));
    table.row({basis.title, basis.place, basis.parameters.front(), basis.parameters.back(), rows.size(),
               rows.where_row(applies).size(), change(found, basis.id), low, high});
  }
  return table;
}

std::string function_table_id(const DegenerateBasis& basis) { return "functions-" + basis.id; }

/// A_1 and A_2 (A_0 is the mirror image of A_2) for the first, a middle and the last shape parameter, for a graph.
Table function_table(const Findings& found, const DegenerateBasis& basis) {
  Table table(function_table_id(basis), fmt::format("Blending functions, {}", basis.title), "");
  table.numbers("t").words("parameter").numbers("value of it").numbers("A1").numbers("A2");
  for (const auto& [words, alpha] : {std::pair("least", basis.parameters.front()),
                                     std::pair("middle", basis.parameters[basis.parameters.size() / 2]),
                                     std::pair("largest", basis.parameters.back())})
    for (const auto& [t, rows] : found.rows().where({study::key::dataset(basis.id), parameter(alpha)}).by(at_t))
      table.row({std::get<double>(t), words, alpha, rows.total(functions[1]), rows.total(functions[2])});
  return table;
}

/// NaN without the row.
double deviation_of(const Findings& found, std::string_view name) {
  const std::vector<double> values = found.rows().where({statement(name)}).values(deviation);
  return values.empty() ? undefined : values.front();
}

Table identity_table(const Findings& found) {
  Table table("identities", "Statements about the bases, checked numerically",
              "Largest deviation over grids of t and a, or over random control points.");
  table.words("statement").words("place").numbers("largest deviation");
  for (const Identity& identity : basis_identities())
    table.row({identity.name, identity.place, deviation_of(found, identity.name)});
  return table;
}

store::FigureRecord function_figure(const std::vector<const DegenerateBasis*>& shown) {
  store::FigureRecord figure{
      .id = "ekappa-applicability",
      .title = "Blending functions over the range of the shape parameter",
      .caption =
          "The C-Bézier basis that Fig. 14 of the paper shows beside the two bases that the paper uses. A1 and "
          "A2 for the least, a middle and the largest shape parameter; A0 is the mirror image of A2.",
      .columns = 3};
  for (const DegenerateBasis* basis : shown)
    figure.panels.push_back(Panel::graph(function_table_id(*basis), "t", {"A1", "A2"},
                                         fmt::format("{}: {:.3g} to {:.3g}", basis->brief, basis->parameters.front(),
                                                     basis->parameters.back()))
                                .series("parameter")
                                .labels("t", "blending functions"));
  return figure;
}

/// Whether the statement "curvature at the ends exactly for these parameters" is true of every parameter looked at.
void claim_applicability(Findings& found, std::string_view id, std::string_view basis, bool (*said_to_apply)(double),
                         std::string_view remark) {
  const Rows rows = ends(found, basis);
  std::vector<std::string> wrong;
  for (const Row* row : rows)
    if (!(said_to_apply(alpha_of(*row)) ? applies(*row) : vanishes(*row)))
      wrong.push_back(fmt::format("{:.3g} (end curvature {:.2g} of the middle's)", alpha_of(*row),
                                  std::max((*row)[at_start], (*row)[at_end])));
  found.judge(id, study::all_but(static_cast<double>(wrong.size()), static_cast<double>(rows.size())),
              {fmt::format("{} of {} shape parameters as stated", rows.size() - wrong.size(), rows.size()),
               fmt::format("End curvatures over three triangles of control points{}{}.{}{}",
                           wrong.empty() ? "" : "; not as stated: ", fmt::join(wrong, ", "), remark.empty() ? "" : " ",
                           remark)});
}

/// "Hardly": as a share of what the paper's own basis changes from a = 2/3 to 0.95.
void claim_c_bezier(Findings& found) {
  const double theirs = change(found, "c-bezier"), own = change(found, "bernstein");
  const Rows rows = ends(found, "c-bezier");
  found.judge("c-bezier-unsuitable", study::Interval{theirs / own, theirs / own},
              {fmt::format("functions change by {:.3f}, {:.0f} % of the Bernstein basis's {:.3f}", theirs,
                           100.0 * theirs / own, own),
               fmt::format("Compared with a from 2/3 to 0.95. The basis is unsuitable for another reason: both end "
                           "curvatures vanish for {} of {} parameters.",
                           rows.where_row(vanishes).size(), rows.size())});
}

/// Whether these identities hold to rounding; one that is missing, or NaN, does not.
study::Tally identities(const Findings& found, const std::vector<std::string_view>& names) {
  constexpr double rounding = 1e-12;
  study::Tally tally;
  for (const std::string_view name : names) tally.add(deviation_of(found, name) <= rounding);
  return tally;
}

void claim_identity(Findings& found, std::string_view id, const std::vector<std::string_view>& names,
                    std::string evidence) {
  std::vector<double> deviations;
  deviations.reserve(names.size());
  for (const std::string_view name : names) deviations.push_back(deviation_of(found, name));
  found.judge(id, identities(found, names),
              {fmt::format("largest deviation {:.2g}", fmt::join(deviations, ", ")), std::move(evidence)});
}

void claim_corrected(Findings& found, std::string_view id, std::string_view printed, std::string_view corrected) {
  found.judge_formula(id, identities(found, {printed}), identities(found, {corrected}),
                      {fmt::format("largest deviation {:.2g}, corrected {:.2g}", deviation_of(found, printed),
                                   deviation_of(found, corrected)),
                       fmt::format("Random control points or areas. The correction: {}.", corrected)});
}

/// Eq. (43) against the rows that the paper prints.
void claim_triangle(Findings& found) {
  const Paper& printed = printed_paper(paper);
  const auto table = std::ranges::find(printed.tables, "triangle", &PrintedTable::id);
  if (table == printed.tables.end()) return;
  study::Tally equal;
  for (std::size_t n = 0; n < table->rows.size(); ++n) {
    const std::vector<double> ours = found.rows().where({degree_key(n + 1)}).values(coefficient);
    equal.add(fmt::format("{:.0f}", fmt::join(ours, " ")) == table->rows[n].back());
  }
  found.judge("blending-triangle", equal,
              {fmt::format("{:.0f} of {:.0f} rows equal", equal.agree, equal.cases),
               "From the powers of u + v + w with v^2 = 2uw."});
}

void conclude(Findings& found) {
  const bool complete = std::ranges::all_of(
      degenerate_bases(), [&](const DegenerateBasis& basis) { return !ends(found, basis.id).empty(); });
  if (!complete || found.rows().where({study::key::dataset("identities")}).empty()) return;
  for (const Table& table : {basis_table(found), curvature_table(found), identity_table(found)}) found.add(table);
  const std::vector<const DegenerateBasis*> shown{&basis_named("c-bezier"), &basis_named("bernstein"),
                                                  &basis_named("trigonometric")};
  for (const DegenerateBasis* basis : shown) found.add(function_table(found, *basis));
  found.add(function_figure(shown));

  claim_c_bezier(found);
  claim_applicability(
      found, "alternative-cubic-applicable", "cubic-alternative", [](double alpha) { return alpha != 3.0; },
      "With alpha = 3a it is the basis of Section 3; beyond 3 the inner function outgrows 1, the "
      "outer ones go negative and curvature changes its sign inside the segment.");
  claim_applicability(
      found, "t-bezier-applicability", "t-bezier", [](double alpha) { return alpha == 0.0; }, "");
  claim_applicability(
      found, "alpha-beta-bernstein-applicability", "alpha-beta", [](double alpha) { return alpha == 2.0; },
      "For 2 it is the quadratic Bézier segment.");
  claim_identity(found, "trigonometric-square", {names::square}, "On a grid of t.");
  claim_identity(found, "quadratic-blending-functions", {names::unity, names::negative},
                 "Sum, and how far below 0 the least value goes, on a grid of t.");
  claim_identity(found, "trigonometric-same-as-built-in-shape", {names::built_in},
                 "Positions over random control points, over their size, a from 0.5 to 1.");
  claim_identity(found, "recursive-evaluation", {names::recursion},
                 "Degrees 1 to 6, random control points, recursion against the coefficients of (43).");
  claim_identity(found, "trigonometric-circle", {names::circle},
                 "Radius and curvature of the segment over two equal perpendicular legs, a = 1/2.");
  claim_triangle(found);
  claim_corrected(found, "trigonometric-linear-parameter", names::parameter_printed, names::parameter_corrected);
  claim_corrected(found, "trigonometric-g2", names::ratio_printed, names::ratio_corrected);
}

}  // namespace

Experiment ekappa_applicability_experiment() {
  return study::experiment(
      {.id = "ekappa-applicability",
       .title = "Which bases the method applies to",
       .about = std::string(about),
       .paper = std::string(paper),
       .claims = {"c-bezier-unsuitable", "alternative-cubic-applicable", "t-bezier-applicability",
                  "alpha-beta-bernstein-applicability", "trigonometric-square", "quadratic-blending-functions",
                  "trigonometric-same-as-built-in-shape", "recursive-evaluation", "trigonometric-circle",
                  "blending-triangle", "trigonometric-linear-parameter", "trigonometric-g2"},
       .jobs = jobs,
       .conclude = conclude});
}

}  // namespace kappabench
