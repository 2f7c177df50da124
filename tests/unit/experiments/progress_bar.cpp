#include "experiments/program/progress_bar.hpp"

#include "tests/catch.hpp"

using namespace kappabench;
using std::chrono::duration;

TEST_CASE("the time left is what the rest takes at the pace of the part") {
  CHECK(time_left(duration<double>(10.0), 0, 5).empty());
  CHECK(time_left(duration<double>(10.0), 5, 5).empty());
  CHECK(time_left(duration<double>(10.0), 1, 5) == "40 s left");
  CHECK(time_left(duration<double>(60.0), 1, 11) == "10 min left");
  CHECK(time_left(duration<double>(3600.0), 1, 4) == "3 h left");
}

TEST_CASE("a bar fits any terminal, and gives it no orders") {
  for (const std::size_t width : {1UL, 5UL, 20UL, 60UL, 80UL, 200UL}) {
    const std::string line =
        bar_line("computing", 37, 1000, "12 min left", "compare bird kappa with a long name", width);
    CHECK(line.size() <= width);
  }
  const std::string line = bar_line("computing", 500, 1000, "2 s left", "a\033[2Jb", 80);
  CHECK_THAT(line, ContainsSubstring("[###############...............]"));
  CHECK_THAT(line, ContainsSubstring("500/1000, 2 s left"));
  CHECK_THAT(line, ContainsSubstring("a?[2Jb"));
}
