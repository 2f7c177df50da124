#include <algorithm>

#include "tests/catch.hpp"
#include "tests/unit/datasets/scratch.hpp"

using namespace kappabench;

TEST_CASE("the built-in drawings load and say where they come from", "[datasets]") {
  const std::vector<Drawing> drawings = builtin_drawings();
  CHECK(drawings.size() >= 25);
  for (const Drawing& drawing : drawings) {
    CAPTURE(drawing.id);
    CHECK(drawing.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos);
    CHECK((drawing.licence == "CC0" || drawing.licence == "MIT"));
    for (const Input& curve : drawing.curves) {
      CHECK(curve.size() >= 3);
      CHECK(std::ranges::all_of(curve.points, [](const Vec2& p) { return p.allFinite(); }));
      CHECK(std::ranges::adjacent_find(curve.points) == curve.points.end());
      if (curve.closed) CHECK(curve.points.front() != curve.points.back());
    }
  }
  CHECK(std::ranges::is_sorted(drawings, {}, &Drawing::id));
  CHECK(fault_of(drawings) == "");
}

TEST_CASE("two drawings with one id, and one that does not say where it comes from, are faults", "[datasets]") {
  const Drawing bird{.id = "bird", .title = "A bird", .source = "drawn by hand", .licence = "CC0", .units = "mm"};
  CHECK(fault_of(std::vector{bird}) == "");
  CHECK(fault_of(std::vector{bird, bird}) == "two built-in drawings have the id 'bird'");
  const auto fault_without = [&](std::string Drawing::*member) {
    Drawing drawing = bird;
    (drawing.*member).clear();
    return fault_of(std::vector{drawing});
  };
  CHECK(fault_without(&Drawing::title) == "datasets/points/bird.txt: no title; begin with a line '# title: ...'");
  CHECK_THAT(fault_without(&Drawing::source), ContainsSubstring("no source"));
  CHECK_THAT(fault_without(&Drawing::licence), ContainsSubstring("no licence"));
  CHECK_THAT(fault_without(&Drawing::units), ContainsSubstring("no units"));
}

TEST_CASE("every figure with a drawn shape has its stand-in", "[datasets]") {
  std::string all;
  for (const Drawing& drawing : builtin_drawings()) all += drawing.stands_in_for + "\n";
  for (const char* figure :
       {"Fig. 2\n", "Fig. 3\n", "Fig. 5\n", "Fig. 6\n", "Fig. 7\n", "Fig. 8\n", "Fig. 9\n", "Fig. 11\n", "Fig. 12\n"}) {
    CHECK(all.find("Miura 2022, " + std::string(figure)) != std::string::npos);
  }
  for (const char* figure : {"Fig. 5", "Figs. 6", "Fig. 7", "Fig. 9", "Fig. 10", "Fig. 11(a)", "Fig. 11(b)",
                             "Fig. 11(c)", "Fig. 11(d)", "Fig. 11(e)", "Fig. 11(f)", "Fig. 12", "Fig. 14, first row",
                             "Fig. 14, second row", "Fig. 14, third row", "Fig. 14, fourth row", "Fig. 15"}) {
    CHECK(all.find("Wang 2024, " + std::string(figure)) != std::string::npos);
  }
}

TEST_CASE("stand-ins for Wang 2024, Table 2 have its numbers of points and curves", "[datasets]") {
  struct Row {
    const char* id;
    int points;
    int open;
    int closed;
  };
  // Wang 2024, Table 2: columns N_I, N_O, N_C.
  for (const Row& row : std::vector<Row>{{"owl", 78, 18, 1},
                                         {"whale", 43, 11, 0},
                                         {"goldfish", 59, 10, 0},
                                         {"cat", 52, 10, 0},
                                         {"duck", 59, 11, 0},
                                         {"snail", 76, 11, 4},
                                         {"car", 141, 35, 0},
                                         {"row-open-7", 7, 1, 0},
                                         {"row-closed-10", 10, 0, 1},
                                         {"row-closed-9", 9, 0, 1},
                                         {"row-closed-7", 7, 0, 1}}) {
    CAPTURE(row.id);
    const Drawing drawing = open_drawings(row.id).at(0);
    int points = 0;
    int closed = 0;
    for (const Input& curve : drawing.curves) {
      points += curve.size();
      closed += curve.closed ? 1 : 0;
    }
    CHECK(points == row.points);
    CHECK(closed == row.closed);
    CHECK(static_cast<int>(drawing.curves.size()) - closed == row.open);
  }
}

TEST_CASE("drawings made by a generator are what it makes, to their six decimals", "[datasets]") {
  int seen = 0;
  for (const Drawing& drawing : builtin_drawings()) {
    constexpr std::string_view prefix = "generated: ";
    if (!drawing.source.starts_with("generated: analytic:")) continue;
    ++seen;
    CAPTURE(drawing.id);
    const std::string expression = drawing.source.substr(prefix.size(), drawing.source.rfind(", six") - prefix.size());
    const Input made = open_drawings(expression).at(0).curves.at(0);
    const Input& stored = drawing.curves.at(0);
    REQUIRE(stored.size() == made.size());
    CHECK(stored.closed == made.closed);
    for (std::size_t i = 0; i < made.points.size(); ++i) {
      CHECK((stored.points[i] - made.points[i]).cwiseAbs().maxCoeff() < 5.1e-7);
    }
  }
  CHECK(seen == 21);
}
