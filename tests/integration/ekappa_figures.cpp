// The experiments on the figures of Miura 2022: what their verdicts depend on, and that they depend on nothing else.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "experiments/study/distance.hpp"
#include "reports/figures/figure.hpp"
#include "tests/catch.hpp"
#include "tests/integration/experiment_records.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

store::ExperimentRecord run_on(const std::string& id, const std::string& dataset, int processes = 2) {
  return run_one({.id = id, .datasets = {dataset}}, processes);
}

}  // namespace

TEST_CASE("the jump at inflections shrinks where it does, and only there") {
  const auto wave = run_on("ekappa-inflection", "s-inflections");
  CHECK(all_agree(wave, "inflection-curvature-shrinks"));
  CHECK(all_agree(wave, "inflection-gap-shrinks"));
  CHECK(verdict(wave, "g2-except-inflections") == "reproduced");
  const auto curvature = column_of(table_of(wave, "inflections"), "median |κ|");
  REQUIRE(curvature.size() == 8);  // four a of the drawing, four of all
  CHECK(std::is_sorted(curvature.begin(), curvature.begin() + 4, std::greater<>()));
  // Fig. 7: four curves and four close-ups.
  REQUIRE(wave.figures.size() == 2);
  REQUIRE(wave.figures.front().panels.size() == 8);
  CHECK(wave.figures.front().panels[0].window.empty());
  CHECK(wave.figures.front().panels[4].window.size() == 4);

  // The frame of each close-up is drawn where it was taken.
  const FigureFiles files = draw_figure(wave.figures.front(), wave, "wave");
  CHECK(files.data.at("wave-1.dat").find("frames of close-ups") != std::string::npos);
  CHECK(files.data.at("wave-5.dat").find("frames of close-ups") == std::string::npos);

  // The jump of one of its inflections grows from a = 2/3 to 0.75: one of three steps.
  CHECK_FALSE(all_agree(run_on("ekappa-inflection", "clothoid-noisy"), "inflection-gap-shrinks"));
  // Nothing to measure is not a success.
  CHECK(verdict(run_on("ekappa-inflection", "five-blob"), "inflection-gap-shrinks") == "undecided");
}

TEST_CASE("a larger a sharpens a blob but blunts points that are nearly cusps") {
  const auto wave = run_on("ekappa-global-shape", "s-inflections");
  CHECK(all_agree(wave, "raising-a-sharpens-globally"));
  CHECK(verdict(wave, "interpolates-points") == "reproduced");
  CHECK(verdict(wave, "quadratic-at-two-thirds") == "reproduced");
  CHECK(verdict(wave, "one-maximum-per-segment") == "reproduced");
  CHECK(column_of(table_of(wave, "maxima"), "segments") == std::vector<double>{4, 4, 4, 4});
  // Its five tips lose curvature at every step.
  const auto star = run_on("ekappa-global-shape", "closed-inflections");
  CHECK_FALSE(all_agree(star, "raising-a-sharpens-globally"));
  CHECK(verdict(star, "quadratic-at-two-thirds") == "reproduced");
}

TEST_CASE("both bases are compared on the same points") {
  const auto drop = run_on("ekappa-bases", "five-drop");
  REQUIRE(drop.figures.size() == 2);
  CHECK(drop.figures.front().panels.size() == 8);
  CHECK(drop.figures.front().columns == 4);
  const auto cases = column_of(table_of(drop, "comparison"), "curves");
  CHECK(cases == std::vector<double>(6, 1.0));
  // With the same a the trigonometric curve is nearer to the polygon, hence not the rounder one.
  CHECK(column_of(table_of(drop, "comparison"), "farther from the polygon").back() == 0.0);
  CHECK(claim_of(drop, "trigonometric-rounder").sample.starts_with("0 of 2"));
  CHECK(verdict(run_on("ekappa-bases", "all-collinear"), "trigonometric-rounder") == "undecided");
}

TEST_CASE("raising a at some points, and the wing tips of the bird alone") {
  const auto boomerang = run_on("ekappa-local-shape", "five-boomerang");
  CHECK(all_agree(boomerang, "raising-a-sharpens-locally"));
  CHECK(boomerang.figures.front().panels.size() == 4);
  CHECK(std::ranges::find(boomerang.claims, "wing-tips", &store::ClaimRecord::claim) == boomerang.claims.end());
  CHECK_FALSE(column_of(table_of(boomerang, "points"), "|κ|").empty());

  const auto bird = run_on("ekappa-local-shape", "bird");
  CHECK_FALSE(verdict(bird, "wing-tips").empty());
  const auto influence = column_of(table_of(bird, "influence"), "median");
  REQUIRE(influence.size() == 48);
  for (std::size_t d = 1; d < 8; ++d) CHECK(influence[24 + d] < influence[24 + d - 1]);  // points moved at a = 2/3
}

TEST_CASE("added points change the peak between them") {
  const auto record = run_on("ekappa-added-points", "five-blob");
  CHECK(verdict(record, "extra-points-control-curvature") == "reproduced");
  const auto ratios = column_of(table_of(record, "figure"), "over the original");
  REQUIRE(ratios.size() == 3);
  CHECK(ratios[0] > 1.0);
  CHECK(ratios[1] == 1.0);
  CHECK(std::abs(ratios[2]) < 1.0);
}

TEST_CASE("verdicts, tables and figures do not depend on the number of processes") {
  for (const std::string id : {"ekappa-inflection", "ekappa-local-shape"}) {
    check_same_conclusions(run_on(id, "five-drop", 1), run_on(id, "five-drop", 3));
  }
}

TEST_CASE("influence is sorted by distance from the point, around a closed curve too") {
  using namespace study;
  std::vector<Span> ring;
  for (int i = 0; i < 6; ++i) ring.push_back({i, (i + 1) % 6, {}});
  const std::vector<double> deviations{5, 4, 3, 2, 1, 6};  // spans 0-1, 1-2, 2-3, 3-4, 4-5, 5-0
  CHECK(largest_by_distance(ring, deviations, 0, true, 3) == std::vector<double>{6, 4, 3});
  CHECK(largest_by_distance(ring, deviations, 3, true, 3) == std::vector<double>{3, 4, 6});
  const std::vector<Span> line(ring.begin(), ring.begin() + 5);
  CHECK(largest_by_distance(line, std::span(deviations).first(5), 1, false, 4) == std::vector<double>{5, 3, 2, 1});
}
