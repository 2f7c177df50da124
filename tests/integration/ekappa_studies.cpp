// The studies of the εκ paper: verdicts follow the cells, runs repeat, timings are complete.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "experiments/papers/ekappa-2022-miura/applicability_bases.hpp"
#include "experiments/papers/ekappa-2022-miura/basis_identities.hpp"
#include "experiments/papers/ekappa-2022-miura/family_sweep.hpp"
#include "experiments/study/rows.hpp"
#include "experiments/study/timing.hpp"
#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"
#include "tests/integration/experiment_records.hpp"

using namespace kappabench;
using namespace kappabench::test;
using namespace kappabench::miura;

namespace {

/// A column of a cell's rows.
template <class Value = double>
std::vector<Value>& column_in(store::CellRecord& cell, std::string_view name) {
  for (store::TableRecord& rows : cell.rows)
    for (store::TableColumn& column : rows.columns)
      if (column.name == name) return std::get<std::vector<Value>>(column.cells);
  FAIL("no column " << name);
  throw std::logic_error("unreachable");
}

double total(const store::CellRecord& cell, const study::Quantity& what) { return study::Rows({cell}).total(what); }

/// How far a statement about the bases is from holding.
double& deviation_of(store::CellRecord& identities, std::string_view statement) {
  const auto& statements = column_in<std::string>(identities, "statement");
  const auto found = std::ranges::find(statements, statement);
  REQUIRE(found != statements.end());
  return column_in(identities, "largest deviation")[static_cast<std::size_t>(found - statements.begin())];
}

store::CellRecord& cell_of(store::ExperimentRecord& record, const std::string& dataset) {
  const auto found = std::ranges::find(record.cells, dataset, &store::CellRecord::dataset);
  REQUIRE(found != record.cells.end());
  return *found;
}

}  // namespace

TEST_CASE("pinned points: the verdict follows the counts") {
  const PlannedExperiment planned{.id = "ekappa-pinned",
                                  .schemes = {"ekappa:a=0.66666666666666663", "ekappa:a=0.9"},
                                  .datasets = {"ellipse-even", "random:walk:n=9,seed=3,closed=true,count=4"}};
  store::ExperimentRecord record = run_one(planned);
  CHECK(record.tables == run_one(planned).tables);
  REQUIRE(record.cells.size() == 4);

  double all_pinned = 0.0;
  for (const auto& cell : record.cells) {
    CHECK(total(cell, points) == total(cell, pinned) + total(cell, at_inflection) + total(cell, peaks) +
                                     total(cell, valleys) + total(cell, neither));
    CHECK(total(cell, valleys) == 0.0);  // Miura 2022, Appendix A.2: one extremum, a maximum
    all_pinned += total(cell, pinned);
  }
  CHECK(column_in(record.cells[1], points.name).size() == 4);  // a row a drawing
  CHECK(verdict(record, "extremum-at-points") == (all_pinned > 0.0 ? "contradicted" : "reproduced"));

  for (auto& cell : record.cells) column_in(cell, peaks.name) = column_in(cell, points.name);
  for (const auto& other : {pinned, at_inflection, neither}) set_column(record, other.name, 0.0);
  record = concluded(record);
  CHECK(verdict(record, "extremum-at-points") == "reproduced");
  column_in(record.cells[1], pinned.name).back() = 1.0;
  CHECK(verdict(concluded(record), "extremum-at-points") == "contradicted");
  CHECK(column_of(table_of(record, "pinned-bernstein"), "points").size() == 4);
}

TEST_CASE("minima of the trigonometric curve: measured slopes decide, a missing cell is no verdict") {
  store::ExperimentRecord record = run_one({.id = "ekappa-trig-minima",
                                            .schemes = {"ekappa-trig:a=0.5", "ekappa-trig:a=0.9", "ekappa:a=0.9"},
                                            .datasets = {"blob-12"}});
  REQUIRE(record.cells.size() == 2);  // the Bernstein basis is none of this
  // Twelve gentle turns: minima at a = 1/2, maxima at 0.9.
  CHECK(total(record.cells[0], valleys) > 0.0);
  CHECK(total(record.cells[1], valleys) == 0.0);
  CHECK(verdict(record, "trigonometric-local-maximum") == "contradicted");
  record.cells.erase(record.cells.begin());
  column_in(record.cells[0], peaks.name) = column_in(record.cells[0], points.name);
  CHECK(verdict(concluded(record), "trigonometric-local-maximum") == "reproduced");
  record.cells.clear();
  CHECK(concluded(record).claims.empty());
}

TEST_CASE("slopes tell peaks from valleys") {
  // Both inner control points at the corner: a peak in the middle. Bends at both ends: a valley between them.
  const auto curve = [](const std::array<Vec2, 4>& control) {
    return Curve({std::make_shared<const PolynomialSegment>(control)}, {}, {{.point = 0, .segment = 0, .t = 0.5}},
                 false);
  };
  const Curve peak = curve({Vec2(0, 0), Vec2(2, 2), Vec2(2, 2), Vec2(4, 0)});
  const Curve valley = curve({Vec2(0, 0), Vec2(-0.5, 1), Vec2(4.5, 1), Vec2(4, 0)});
  CHECK(curvature_at(peak, peak.nodes()[0]) == AtPoint::peak);
  CHECK(curvature_at(valley, valley.nodes()[0]) == AtPoint::valley);
  CHECK(curvature_at(peak, {.point = 0, .segment = 0, .t = 0.2}) == AtPoint::passes);
}

TEST_CASE("degenerate bases: derivatives fit the values, partition of unity, C.2 at 3a is Eq. (1)") {
  for (const DegenerateBasis& basis : degenerate_bases())
    for (const double alpha : basis.parameters)
      for (const double t : {0.2, 0.5, 0.9}) {
        CAPTURE(basis.id, alpha, t);
        constexpr double h = 1e-5;
        const Blending low = basis.last(t - h, alpha), at = basis.last(t, alpha), high = basis.last(t + h, alpha);
        CHECK(at.first == Approx((high.value - low.value) / (2.0 * h)).epsilon(1e-5).margin(1e-8));
        CHECK(at.second == Approx((high.first - low.first) / (2.0 * h)).epsilon(1e-5).margin(1e-8));
        const auto b = blending_functions(basis, alpha, t);
        CHECK(b[0].value + b[1].value + b[2].value == Approx(1.0));
        CHECK(basis.last(0.0, alpha).value == 0.0);
        CHECK(basis.last(1.0, alpha).value == Approx(1.0));
      }
  for (const Identity& identity : basis_identities()) {
    CAPTURE(identity.name);
    const bool wrong_as_printed = identity.name == names::parameter_printed || identity.name == names::ratio_printed;
    CHECK((identity.largest_deviation() < 1e-12) != wrong_as_printed);
  }
  CHECK(blending_triangle(3).back() == std::vector<double>{1, 3, 9, 8, 9, 3, 1});
}

TEST_CASE("applicability: verdicts flip with the cells") {
  store::ExperimentRecord record = run_one({.id = "ekappa-applicability"});
  CHECK(verdict(record, "alternative-cubic-applicable") == "reproduced");
  CHECK(verdict(record, "alpha-beta-bernstein-applicability") == "reproduced");
  CHECK(verdict(record, "t-bezier-applicability") == "contradicted");
  CHECK(verdict(record, "blending-triangle") == "reproduced");
  CHECK(verdict(record, "trigonometric-linear-parameter") == "misprint");
  CHECK(record.figures.size() == 1);

  // Vanishing end curvatures at alpha = 2, a wrong coefficient, a wrong identity.
  store::CellRecord& basis = cell_of(record, "alpha-beta");
  for (const char* column : {"largest curvature at 0", "largest curvature at 1", "least end curvature"})
    column_in(basis, column).front() = 0.0;
  store::CellRecord& identities = cell_of(record, "identities");
  column_in(identities, "coefficient").front() = 2.0;
  deviation_of(identities, names::square) = 0.1;
  record = concluded(record);
  CHECK(verdict(record, "alpha-beta-bernstein-applicability") == "contradicted");
  CHECK(verdict(record, "blending-triangle") == "contradicted");
  CHECK(verdict(record, "trigonometric-square") == "contradicted");
  CHECK(verdict(record, "recursive-evaluation") == "reproduced");
  deviation_of(cell_of(record, "identities"), names::recursion) = std::nan("");
  CHECK(verdict(concluded(record), "recursive-evaluation") == "contradicted");
}

TEST_CASE("iterations: fifty published steps leave more than the cascade does") {
  const PlannedExperiment planned{.id = "ekappa-iterations", .datasets = {"five-blob", "bird"}};
  const store::ExperimentRecord record = run_one(planned);
  CHECK(record.tables == run_one(planned).tables);
  const store::TableRecord& table = table_of(record, "iterations-kappa");
  const auto jump_early = column_of(table, "jump after 50"), jump_newton = column_of(table, "jump of Newton");
  const auto curves = column_of(table, "curves"), solved = column_of(table, "solved by Newton");
  REQUIRE(jump_early.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(solved[i] == curves[i]);
    CHECK(jump_newton[i] < 1e-6);
    CHECK(jump_early[i] >= jump_newton[i]);
  }
  CHECK(column_of(table_of(record, "iterations"), "solved").size() == 12);
  REQUIRE(record.figures.size() == 1);
  CHECK(record.figures[0].panels.size() == 2);
}

TEST_CASE("timings: every repetition is there, twice under one name too") {
  long calls = 0;
  const std::vector<TimedWork> works{{"one", [&] { ++calls; }}, {"two", [&] { ++calls; }}};
  for (int round = 0; round < 2; ++round) {
    const auto samples = time_all(works, {.repetitions = 3, .least_seconds = 1e-4});
    REQUIRE(samples.size() == 2);
    for (const auto& [name, seconds] : samples) {
      CHECK(seconds.size() == 3);
      CHECK(std::ranges::all_of(seconds, [](double s) { return s >= 0.0 && s < 1.0; }));
    }
  }
  CHECK(calls >= 12);
  CHECK(peak_resident_bytes() > 1e5);
}

TEST_CASE("timing: the verdicts are about the ratios of the samples") {
  store::ExperimentRecord record = run_one({.id = "ekappa-timing", .datasets = {"minimal-closed"}});
  REQUIRE(record.cells.size() == 1);
  auto& timings = record.cells[0].timings;
  CHECK(timings.size() == 12);
  for (const auto& [name, samples] : timings) CHECK(samples.size() == 12);

  const auto with_ratios = [&](double bernstein, double trigonometric) {
    for (auto& [name, samples] : timings)
      std::ranges::fill(samples, name.find("cubic") != std::string::npos           ? bernstein
                                 : name.find("trigonometric") != std::string::npos ? trigonometric
                                                                                   : 1.0);
    return concluded(record);
  };
  const auto like_the_paper = with_ratios(8.0 / 7.0, 37.0 / 7.0), unlike = with_ratios(2.0, 1.5);
  CHECK(verdict(like_the_paper, "time-bernstein") == "reproduced");
  CHECK(verdict(like_the_paper, "time-trigonometric") == "reproduced");
  CHECK(verdict(unlike, "time-bernstein") == "contradicted");
  CHECK(verdict(unlike, "time-trigonometric") == "contradicted");
}

TEST_CASE("scaling: exponents of a power law come back, with an interval that holds them") {
  store::ExperimentRecord record =
      run_one({.id = "scaling",
               .schemes = {"catmull-rom", "cubic-spline"},
               .datasets = {"random:star:n=100,closed=true", "random:star:n=200,closed=true",
                            "random:star:n=400,closed=true", "random:star:n=800,closed=true"}});
  REQUIRE(record.cells.size() == 8);
  double wobble = 1.01;
  for (auto& cell : record.cells) {
    CHECK(cell.timings["fit"].size() >= 3);
    CHECK(cell.timings["jet"].size() == 5);
    cell.timings["fit"].assign(3, 1e-6 * std::pow(study::Rows({cell}).largest(points), 1.5) * wobble);
    wobble = 1.0 / wobble;
  }
  record = concluded(record);
  const store::TableRecord& table = table_of(record, "exponents");
  const auto value = column_of(table, "exponent"), low = column_of(table, "low"), high = column_of(table, "high");
  REQUIRE(value.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(value[i] == Approx(1.5).margin(0.02));
    CHECK(low[i] <= 1.5);
    CHECK(high[i] >= 1.5);
    CHECK(high[i] - low[i] < 0.2);
  }
  CHECK(column_of(table, "most points") == std::vector<double>{800, 800});
}
