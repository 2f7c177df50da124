// Locality and comparison of all schemes: what they conclude, that they conclude otherwise from other data, and the
// findings on curves where they are known.

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "experiments/papers/pkappa-2024-wang/visible_flaws.hpp"
#include "experiments/study/curve_marks.hpp"
#include "experiments/study/measured.hpp"
#include "reports/paper.hpp"
#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"
#include "tests/integration/experiment_records.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

/// With every value of a column in the cells of a scheme changed.
store::ExperimentRecord with(store::ExperimentRecord record, const std::string& scheme, const std::string& column,
                             double value) {
  set_column(record, column, value, scheme);
  return record;
}

void check_claims_are_printed(const store::ExperimentRecord& record) {
  const Paper& paper = printed_paper("pkappa-2024-wang");
  std::set<std::string> printed;
  for (const PrintedClaim& claim : paper.claims) printed.insert(claim.id);
  for (const store::ClaimRecord& claim : record.claims) {
    INFO(claim.claim);
    CHECK(claim.paper == "pkappa-2024-wang");
    CHECK(printed.count(claim.claim) == 1);
  }
}

/// Every panel names cells, or a table and columns, that are there.
void check_figures(const store::ExperimentRecord& record) {
  for (const store::FigureRecord& figure : record.figures) {
    INFO(figure.id);
    CHECK(!figure.panels.empty());
    for (const store::PanelRecord& panel : figure.panels) {
      INFO(panel.title);
      if (panel.kind != "graph") CHECK(!panel.cells.empty());
      for (const int cell : panel.cells) CHECK(static_cast<std::size_t>(cell) < record.cells.size());
      if (panel.kind == "graph") CHECK(std::ranges::count(record.tables, panel.table, &store::TableRecord::id) == 1);
    }
  }
}

const std::vector<std::string>& words(const store::TableRecord& table, std::string_view name) {
  return column_of<std::string>(table, name);
}

SegmentPtr bezier(std::vector<Vec2> points) { return std::make_shared<PolynomialSegment>(std::move(points)); }

}  // namespace

TEST_CASE("locality: reaches, an edited pkappa-curve against one fitted again, verdicts that turn") {
  const Context context{.registry = all_schemes(),
                        .schemes = {"kappa", "yuksel", "clothoid3", "clothoid3:curvature=conic", "pkappa"}};
  const store::ExperimentRecord record = concluded(computed("pkappa-locality", context), context);
  check_claims_are_printed(record);
  check_figures(record);
  CHECK(record.claims.size() == 3);
  CHECK(record.figures.front().panels.size() == 6);  // pkappa twice

  const store::TableRecord& reach = table_of(record, "reach");
  const auto& schemes = words(reach, "scheme");
  const auto& most = column_of(reach, "any, most");
  for (std::size_t i = 0; i < schemes.size(); ++i) {
    INFO(schemes[i]);
    CHECK(column_of(reach, "moves")[i] == 48.0);
    if (schemes[i] == "pkappa, edited" || schemes[i] == "yuksel") CHECK(most[i] == 2.0);
    if (schemes[i] == "pkappa, fitted again" || schemes[i] == "kappa") CHECK(most[i] > 4.0);
  }

  CHECK(verdict(record, "yuksel-reaches-five") == "reproduced");
  CHECK(verdict(concluded(with(record, "yuksel", "reach", 3.0), context), "yuksel-reaches-five") == "contradicted");
  CHECK(verdict(concluded(with(record, "yuksel", "reach", 1.0), context), "yuksel-reaches-five") == "contradicted");
  CHECK(verdict(record, "clothoid3-reaches-six-or-eight") == "reproduced");
  CHECK(verdict(concluded(with(record, "clothoid3", "reach", 4.0), context), "clothoid3-reaches-six-or-eight") ==
        "contradicted");  // with the conic estimate it is 3
  CHECK(all_agree(concluded(with(record, "kappa", "visible reach", 3.0), context), "kappa-reaches-six"));
  CHECK(verdict(concluded(with(record, "kappa", "visible reach", 2.0), context), "kappa-reaches-six") ==
        "contradicted");
}

TEST_CASE("comparison: marks, counts, and verdicts that turn") {
  const Context context{.registry = all_schemes(), .schemes = {"kappa", "yuksel", "clothoid3", "pkappa"}};
  const store::ExperimentRecord record = concluded(computed("pkappa-comparison", context), context);
  check_claims_are_printed(record);
  check_figures(record);
  CHECK(record.figures.size() == 4);
  CHECK(words(table_of(record, "findings"), "scheme").size() == 16);
  check_same_conclusions(concluded(record, context), record);

  const auto turned = [&](const std::string& scheme, const std::string& column, double value,
                          const std::string& claim) {
    return verdict(concluded(with(record, scheme, column, value), context), claim);
  };
  CHECK(verdict(record, "kappa-jumps-at-inflections") == "reproduced");
  CHECK(turned("kappa", "jumps where curvature changes sign", 0.0, "kappa-jumps-at-inflections") == "contradicted");
  CHECK(turned("kappa", "jumps", 0.0, "kappa-jumps-at-inflections") == "undecided");
  CHECK(verdict(record, "others-do-not-jump") == "reproduced");
  CHECK(turned("yuksel", "jumps", 1.0, "others-do-not-jump") == "contradicted");
  CHECK(turned("clothoid3", "pieces with more than two", 0.0, "clothoid3-many-intervals") == "undecided");
  CHECK(turned("clothoid3", "pieces with more than two", 2.0, "clothoid3-many-intervals") == "reproduced");
  CHECK(turned("clothoid3", "alternating spans not monotone", 1.0, "clothoid3-monotone-if-alternating") ==
        "contradicted");
  CHECK(turned("pkappa", "mvc_energy", 0.0, "pkappa-more-uniform") == "reproduced");
  CHECK(turned("pkappa", "mvc_energy", 1e300, "pkappa-more-uniform") == "contradicted");

  // The reading of an extremum that agrees less decides.
  const store::ExperimentRecord off =
      with(with(record, "yuksel", "points", 100.0), "yuksel", "points off extrema", 100.0);
  CHECK(verdict(concluded(with(off, "yuksel", "points off peaks", 100.0), context), "yuksel-off-extrema") ==
        "reproduced");
  CHECK(verdict(concluded(with(off, "yuksel", "points off peaks", 0.0), context), "yuksel-off-extrema") ==
        "contradicted");
}

TEST_CASE("findings on curves where they are known") {
  SECTION("a parabola with its point at the vertex has nothing to mark") {
    const Fit fit{.input = {.points = {{0, 0}, {1, 0.5}, {2, 0}}, .closed = false, .options = {}, .ids = {}},
                  .curve = Curve({bezier({{0, 0}, {1, 1}, {2, 0}})}, {},
                                 {{.point = 0, .segment = 0, .t = 0.0},
                                  {.point = 1, .segment = 0, .t = 0.5},
                                  {.point = 2, .segment = 0, .t = 1.0}},
                                 false),
                  .report = {}};
    const wang::VisibleFlaws found = wang::visible_flaws(fit);
    CHECK(found.points == 1);
    CHECK(found.off_extrema.empty());
    CHECK(found.points_off_peaks == 0);
    CHECK(found.pieces == 1);
    CHECK(found.many_intervals.empty());
    CHECK(found.alternating_spans == 0);
  }
  SECTION("two parabolas of opposite turn: a jump with a change of sign, points off the vertices") {
    const Fit fit{
        .input = {.points = {{0, 0}, {0.5, 0.375}, {3.5, -0.375}, {4, 0}}, .closed = false, .options = {}, .ids = {}},
        .curve = Curve({bezier({{0, 0}, {1, 1}, {2, 0}}), bezier({{2, 0}, {3, -1}, {4, 0}})},
                       {{.segment = 0, .claimed = Continuity::g1}},
                       {{.point = 0, .segment = 0, .t = 0.0},
                        {.point = 1, .segment = 0, .t = 0.25},
                        {.point = 2, .segment = 1, .t = 0.75},
                        {.point = 3, .segment = 1, .t = 1.0}},
                       false),
        .report = {}};
    const wang::VisibleFlaws found = wang::visible_flaws(fit);
    REQUIRE(found.jumps.size() == 1);
    CHECK((found.jumps.front() - Vec2(2, 0)).norm() < 1e-12);
    CHECK(found.jumps_at_sign_changes == 1);
    CHECK(found.points == 2);
    CHECK(found.off_extrema.size() == 2);
    CHECK(found.points_off_peaks == 2);
    CHECK(found.alternating_spans == 1);
    CHECK(found.alternating_not_monotone == 1);  // both vertices are between the points
  }
}

TEST_CASE("stretches and rings") {
  store::CurveRecord whole;
  whole.closed = true;
  for (int i = 0; i <= 10; ++i) {
    whole.sample_s.push_back(i);
    whole.sample_x.push_back(i % 10);
    whole.sample_y.push_back(0.0);
  }
  const store::CurveRecord inner = stretch_of(whole, 2.0, 5.0);
  CHECK(inner.sample_x == std::vector<double>{2, 3, 4, 5});
  const store::CurveRecord around = stretch_of(whole, 8.0, 12.0);
  CHECK(around.sample_x == std::vector<double>{8, 9, 0, 0, 1, 2});  // the place of closure ends one turn and starts one
  CHECK(stretch_of(whole, -2.0, 1.0).sample_x == std::vector<double>{8, 9, 0, 0, 1});
  whole.closed = false;
  CHECK(stretch_of(whole, 8.0, 12.0).sample_x == std::vector<double>{8, 9, 0});

  const store::CurveRecord ring = ring_around({1.0, 2.0}, 0.5, 4);
  REQUIRE(ring.sample_x.size() == 5);
  CHECK(ring.sample_x.front() == ring.sample_x.back());
  for (std::size_t i = 0; i < 5; ++i) CHECK(std::hypot(ring.sample_x[i] - 1.0, ring.sample_y[i] - 2.0) == Approx(0.5));
}

TEST_CASE("compare: distributions and profiles are shares of all curves") {
  const Context context{.registry = all_schemes(),
                        .schemes = {"kappa", "catmull-rom"},
                        .datasets = {"row-open-7", "row-closed-7", "row-closed-9"},
                        .metrics = {"parabola_energy", "fairness"}};
  store::ExperimentRecord record = concluded(computed("compare", context), context);
  check_figures(record);
  // Times we know: kappa three times slower on the first and third curve, twice as fast on the second.
  for (store::CellRecord& cell : record.cells)
    cell.curves.front().seconds = cell.scheme == "catmull-rom" ? 2.0 : cell.dataset == "row-closed-7" ? 1.0 : 6.0;
  record = concluded(record, context);
  const store::TableRecord& profile = table_of(record, "profile-seconds");
  const auto& scheme = words(profile, "scheme");
  const auto &factor = column_of(profile, "factor"), &share = column_of(profile, "share of curves");
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    INFO(scheme[i] << " " << factor[i]);
    if (scheme[i] == "kappa") CHECK(share[i] == Approx(factor[i] >= 3.0 ? 1.0 : 1.0 / 3.0));
    if (scheme[i] == "catmull-rom") CHECK(share[i] == Approx(factor[i] >= 2.0 ? 1.0 : 2.0 / 3.0));
  }
  // A curve that is not solved is within no factor, and its values are no part of a distribution.
  record.cells.front().curves.front().outcome = name(Outcome::not_converged);
  record = concluded(record, context);
  const std::string lost = record.cells.front().label;
  const store::TableRecord& after = table_of(record, "profile-seconds");
  const store::TableRecord& energies = table_of(record, "distribution-mvc_energy");
  for (std::size_t i = 0; i < words(after, "scheme").size(); ++i)
    if (words(after, "scheme")[i] == lost) CHECK(column_of(after, "share of curves")[i] <= 0.67);
  CHECK(std::ranges::count(words(energies, "scheme"), lost) == 2);
}
