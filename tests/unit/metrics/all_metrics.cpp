#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "metrics/continuity.hpp"
#include "tests/catch.hpp"
#include "tests/unit/metrics/curves.hpp"
#include "tests/unit/metrics/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

/// A half circle that hides what it is, so that it can only be sampled.
class OpaqueArc final : public Segment {
 public:
  [[nodiscard]] Jet jet(double t, int) const override {
    Jet jet;
    double factor = 1.0;
    for (std::size_t k = 0; k <= max_jet_order; ++k) {
      const double angle = std::numbers::pi * t + 0.5 * std::numbers::pi * static_cast<double>(k);
      jet.d[k] = factor * Vec2(std::cos(angle), std::sin(angle));
      factor *= std::numbers::pi;
    }
    return jet;
  }
  [[nodiscard]] ExactForm exact() const override { return OpaqueForm{}; }
};

std::vector<Fit> nasty_fits() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  std::vector<Curve> curves;
  const auto one = [&](const std::vector<Vec2>& points) { curves.push_back(single(bezier(points))); };
  one({{0, 0}, {1, 0}});                          // a line
  one({{0, 0}, {1, 0.1}, {2, 0.2}, {3, 0.3}});    // a line of higher degree
  one({{0, 0}, {2, 0}, {-1, 0}, {1, 0}});         // a line that runs back over itself
  one({{0, 0}, {1, 1}, {0, 1}, {1, 0}});          // a cusp
  one({{0, 0}, {1.0000001, 1}, {0, 1}, {1, 0}});  // almost a cusp
  one({{0, 0}, {0, 0}, {1, 1}, {1, 1}});          // rests at both ends, straight
  one({{0, 0}, {0, 0}, {1, 2}, {3, 0}});          // rests at its start
  one({{1, 1}, {1, 1}, {1, 1}});                  // a point
  one({{0, 0}, {1, nan}, {2, 0}});                // not numbers
  one({{0, 0}, {1, inf}, {2, 0}});
  one({{0, 0}, {1e-160, 1e-160}, {2e-160, 0}});           // tiny
  one({{0, 0}, {1e100, 1e100}, {2e100, 0}});              // huge
  one({{1e9, 1e9}, {1e9 + 1, 1e9 + 1}, {1e9 + 2, 1e9}});  // far away
  curves.push_back(single(std::make_shared<OpaqueArc>()));
  curves.push_back(circle(1.0));
  curves.emplace_back(std::vector<SegmentPtr>{bezier({{0, 0}, {3, 2}, {-2, 2}, {0, 0}})},
                      std::vector<Joint>{{0, Continuity::g0}}, std::vector<Node>{{0, 0, 0.0}},
                      true);  // one closed segment
  curves.emplace_back(
      std::vector<SegmentPtr>{bezier({{0, 0}, {1, 1}}), bezier({{1, 1}, {1, 1}}), bezier({{1, 1}, {2, 0}})},
      std::vector<Joint>{{0, Continuity::g1}, {1, Continuity::g1}},
      std::vector<Node>{{0, 0, 0.0}, {1, 1, 0.5}, {2, 2, 1.0}}, false);  // a segment without length
  curves.emplace_back(std::vector<SegmentPtr>{bezier({{0, 0}, {1, 1}, {2, 0}})}, std::vector<Joint>{},
                      std::vector<Node>{},
                      false);  // no nodes
  std::vector<Fit> fits;
  for (const Curve& curve : curves) {
    fits.push_back(fit_of(curve));
    if (fits.back().input.size() < 2) fits.back().input.points = {{0, 0}, {1, 0}};
  }
  return fits;
}

}  // namespace

TEST_CASE("ids and columns are unique and described", "[metrics]") {
  std::set<std::string> ids;
  std::set<std::string> columns;
  for (const Metric& metric : all_metrics()) {
    CHECK(ids.insert(metric.id).second);
    CHECK_FALSE(metric.title.empty());
    CHECK(metric.version >= 1);
    for (const Column& column : metric.columns) {
      CHECK(columns.insert(column.name).second);
      CHECK_FALSE(column.unit.empty());
      CHECK_FALSE(column.help.empty());
      CHECK(column.help.find('\n') == std::string::npos);
    }
  }
  CHECK(find_metric("continuity").id == "continuity");
  CHECK_THROWS_WITH(find_metric("beauty"), Catch::Matchers::Contains("parabola_energy"));
}

TEST_CASE("every metric fills exactly its columns, on any curve, without throwing", "[metrics]") {
  const PolygonScheme scheme;
  for (const Fit& fit : nasty_fits()) {
    for (const Metric& metric : all_metrics()) {
      std::vector<Measurement> row;
      REQUIRE_NOTHROW(row = metric.measure(scheme, fit));
      REQUIRE(row.size() == metric.columns.size());
      CHECK(std::ranges::equal(row, metric.columns, {}, &Measurement::column, &Column::name));
      CHECK(std::ranges::equal(row, metric.columns, {}, &Measurement::unit, &Column::unit));
    }
  }
}

TEST_CASE("a metric is held to its columns", "[metrics]") {
  const Column declared{"declared", "1", "help"}, other{"other", "rad", "help"};
  const Fit fit = fit_of(circle(1.0));
  const auto giving = [&](std::vector<Measurement> row) {
    return guarded({.id = "m",
                    .title = "M",
                    .version = 1,
                    .columns = {declared, other},
                    .measure = [row](const Scheme&, const Fit&) { return row; }})
        .measure(NoScheme(), fit);
  };
  const Measurement first = declared(1.0, Method::exact), second = other(2.0, Method::sampled);
  CHECK(giving({first, second}).size() == 2);
  CHECK(second.unit == "rad");
  CHECK_THROWS_AS(giving({first}), std::logic_error);
  CHECK_THROWS_AS(giving({second, first}), std::logic_error);
  CHECK_THROWS_AS(giving({first, second, second}), std::logic_error);
  CHECK_THROWS_AS(giving({first, Column{"undeclared", "1", "help"}(0.0, Method::exact)}), std::logic_error);
}

TEST_CASE("only closed forms and certified counts are exact", "[metrics]") {
  const Fit fit = fit_of(Curve({bezier({{0, 0}, {1, 1}, {2, 0}}), bezier({{2, 0}, {3, -1}, {4, 0}})},
                               {{0, Continuity::g1}}, {{0, 0, 0.0}, {1, 0, 0.5}, {2, 1, 0.5}, {3, 1, 1.0}}, false));
  std::set<std::string> exact;
  for (const Metric& metric : all_metrics())
    if (!metric.refits)
      for (const Measurement& m : metric.measure(NoScheme(), fit))
        if (m.method == Method::exact) exact.insert(m.column);
  CHECK(exact == std::set<std::string>{"intervals_per_segment_mean", "intervals_per_segment_max",
                                       "segments_with_at_most_two_intervals", "curvature_extrema",
                                       "prominent_intervals_per_segment_mean", "prominent_intervals_per_segment_max",
                                       "prominent_extrema", "continuity_position_gap", "continuity_angle_jump",
                                       "continuity_curvature_jump_g2", "continuity_curvature_jump_equal_magnitude",
                                       "continuity_signed_jump_equal_magnitude", "continuity_curvature_jump_all",
                                       "continuity_first_derivative_jump", "continuity_second_derivative_jump",
                                       "continuity_violations", "inflections", "cusps"});
}

TEST_CASE("jumps of curvature against the length are not exact", "[metrics]") {
  const Fit fit = fit_of(Curve({bezier({{0, 0}, {1, 0}}), bezier({{1, 0}, {2, 0}})}, {{0, Continuity::g2}},
                               {{0, 0, 0.0}, {1, 1, 1.0}}, false));
  CHECK(measured(fit, "continuity", column::continuity_curvature_jump_g2.name).method == Method::sampled);
  CHECK(measured(fit, "continuity", column::continuity_violations.name).method == Method::sampled);
  CHECK(measured(fit, "continuity", column::continuity_position_gap.name).method == Method::exact);
}

TEST_CASE("curves that cannot be measured have NaN everywhere", "[metrics]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Fit fit = fit_of(single(bezier({{0, 0}, {1, nan}, {2, 0}})));
  for (const Metric& metric : all_metrics()) {
    for (const Measurement& m : metric.measure(PolygonScheme(), fit)) CHECK(std::isnan(m.value));
  }
}

TEST_CASE("an opaque segment is measured by sampling and says so", "[metrics]") {
  const Fit fit = fit_of(single(std::make_shared<OpaqueArc>()));
  const Measurement m = measured(fit, "monotone_intervals", "intervals_per_segment_max");
  CHECK(m.method == Method::sampled);
  CHECK(m.value == 1.0);
  CHECK(value(fit, "fairness", "total_turning") == Approx(std::numbers::pi).epsilon(1e-12));
  CHECK(value(fit, "features", "loops") == 0.0);
}

TEST_CASE("scale, turn and shift do not change scale-free numbers", "[metrics]") {
  const auto chain = [](double scale, double angle, const Vec2& shift) {
    std::vector<SegmentPtr> segments;
    const Vec2 p[] = {{0, 0}, {1, 2}, {3, 1}, {4, 0}, {5, -1}, {7, -2}, {6, 1}, {5, 4}, {3, 3}, {2, 5}};
    const auto map = [&](const Vec2& q) {
      return Vec2(scale * (std::cos(angle) * q.x() - std::sin(angle) * q.y()) + shift.x(),
                  scale * (std::sin(angle) * q.x() + std::cos(angle) * q.y()) + shift.y());
    };
    for (std::size_t i = 0; i < 3; ++i) {
      segments.push_back(bezier({map(p[3 * i]), map(p[3 * i + 1]), map(p[3 * i + 2]), map(p[3 * i + 3])}));
    }
    return fit_of(Curve(segments, {{0, Continuity::g1}, {1, Continuity::g0}},
                        {{0, 0, 0.0}, {1, 0, 0.6}, {2, 1, 0.5}, {3, 2, 0.4}, {4, 2, 1.0}}, false));
  };
  const Fit a = chain(1.0, 0.0, {0, 0});
  const Fit b = chain(37.0, 2.0, {100.0, -50.0});
  for (const Metric& metric : all_metrics()) {
    if (metric.id == "invariance" || metric.id == "locality" || metric.id == "roundness") continue;
    const auto ma = metric.measure(NoScheme(), a);
    const auto mb = metric.measure(NoScheme(), b);
    for (std::size_t i = 0; i < ma.size(); ++i) {
      INFO(ma[i].column);
      const bool scale_free = metric.columns[i].unit == "1" || metric.columns[i].unit == "rad";
      if (!scale_free || std::isnan(ma[i].value)) continue;
      CHECK(mb[i].value == Approx(ma[i].value).epsilon(1e-7).margin(1e-12));
    }
  }
}
