#include <cstdlib>
#include <iostream>
#include <sstream>

#include "tests/catch.hpp"
#include "tests/unit/datasets/scratch.hpp"

using namespace kappabench;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

std::string refused(std::string_view name) {
  return refusal([&] { return open_drawings(name); });
}

/// Sets an environment variable and puts it back.
class Environment {
 public:
  Environment(const char* key, const std::string& value) : key_(key) {
    if (const char* before = std::getenv(key)) before_ = before;
    setenv(key, value.c_str(), 1);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
  ~Environment() {
    if (before_.empty()) {
      unsetenv(key_);
    } else {
      setenv(key_, before_.c_str(), 1);
    }
  }

 private:
  const char* key_;
  std::string before_;
};

}  // namespace

TEST_CASE("a name opens a built-in drawing, a file or a folder", "[datasets]") {
  const std::vector<Drawing> bird = open_drawings("bird");
  REQUIRE(bird.size() == 1);
  CHECK(bird[0].id == "bird");

  const ScratchFolder scratch;
  const auto b = file_in(scratch, "b.csv", "0,0\n1,1\n");
  static_cast<void>(file_in(scratch, "a.txt", "0 0\n"));
  static_cast<void>(file_in(scratch, "README.md", "no points"));
  CHECK(open_drawings(b.string())[0].id == "b");
  const std::vector<Drawing> all = open_drawings(scratch.path().string());
  REQUIRE(all.size() == 2);
  CHECK(all[0].id == "a");
  CHECK(all[1].id == "b");
}

TEST_CASE("a folder without points and one with a bad file are refused", "[datasets]") {
  const ScratchFolder scratch;
  CHECK_THAT(refused(scratch.path().string()), StartsWith(scratch.path().string() + ": no points in this folder"));
  const auto bad = file_in(scratch, "bad.txt", "0 0\noops\n");
  CHECK_THAT(refused(scratch.path().string()), StartsWith(bad.string() + ":2: "));
}

TEST_CASE("an unknown name is told near ones", "[datasets]") {
  CHECK_THAT(refused("brid"), Contains("did you mean bird?"));
  CHECK_THAT(refused("elefant"), Contains("did you mean elephant?"));
  CHECK_THAT(refused("no such thing at all"), Contains("kappabench list datasets"));
  CHECK_THAT(refused("../points/bird"), Contains("no built-in drawing, file or folder"));
  CHECK_THAT(refused(""), Contains("no built-in drawing, file or folder"));
}

TEST_CASE("KAPPABENCH_DATASETS moves the built-in drawings", "[datasets]") {
  const ScratchFolder scratch;
  static_cast<void>(file_in(scratch, "mine.txt", "0 0\n1 1\n2 0\n"));
  const Environment environment("KAPPABENCH_DATASETS", scratch.path().string());
  REQUIRE(builtin_drawings().size() == 1);
  CHECK(open_drawings("mine")[0].curves[0].size() == 3);
  CHECK_THAT(refused("bird"), Contains("no built-in drawing"));
}

TEST_CASE("a missing folder of built-in drawings is said, and files still open", "[datasets]") {
  const ScratchFolder scratch;
  const auto file = file_in(scratch, "mine.txt", "0 0\n");
  const Environment environment("KAPPABENCH_DATASETS", (scratch.path() / "nowhere").string());
  CHECK_THAT(refusal([] { return builtin_drawings(); }), Contains("this folder cannot be read"));
  CHECK(open_drawings(file.string()).size() == 1);
}

TEST_CASE("a dash is plain text from standard input", "[datasets]") {
  std::istringstream text("closed\n0 0\n1 0\n0 1\n");
  std::streambuf* const before = std::cin.rdbuf(text.rdbuf());
  const std::vector<Drawing> drawings = open_drawings("-");
  std::istringstream bad("0 0\n1 x\n");
  std::cin.clear();
  std::cin.rdbuf(bad.rdbuf());
  const std::string message = refused("-");
  std::cin.rdbuf(before);
  std::cin.clear();
  REQUIRE(drawings.size() == 1);
  CHECK(drawings[0].id == "stdin");
  CHECK(drawings[0].curves[0].closed);
  CHECK_THAT(message, StartsWith("standard input:2: y = \"x\" is not a number; "));
}
