// Manifests of external programs: what they say is what the scheme is, and what they get wrong is one line with the
// place and what would be right.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "schemes/plugin/manifest.hpp"
#include "schemes/plugin/plugins.hpp"
#include "tests/catch.hpp"
#include "tests/integration/program.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

const std::string head = "id = \"my-spline\"\ntitle = \"My spline\"\ncitation = \"nobody\"\n";
const std::string command = "command = [\"python3\", \"my.py\"]\n";
const std::string traits = "[traits]\ncontinuity = \"G1\"\n";

Manifest read(const std::string& text) {
  const ScratchFolder folder;
  write(folder.path() / "my.toml", text);
  return read_manifest(folder.path() / "my.toml");
}

/// One line: the place, then what.
void refuses(const std::string& text, int line, const std::string& what) {
  std::string message;
  try {
    static_cast<void>(read(text));
  } catch (const std::runtime_error& error) {
    message = error.what();
  }
  INFO(text.substr(0, 500));
  CHECK_THAT(message, ContainsSubstring(fmt::format("my.toml:{}: ", line)));
  CHECK_THAT(message, ContainsSubstring(what));
  CHECK(message.find('\n') == std::string::npos);
  CHECK(message.size() < 1100);
}

std::string parameter(const std::string& lines) {
  return head + command + "[[parameter]]\nname = \"p\"\nhelp = \"h\"\n" + lines + traits;
}

std::string trait(const std::string& line) { return head + command + "[traits]\n" + line; }

}  // namespace

TEST_CASE("A manifest says what the scheme is") {
  const Manifest manifest = read(head + command + R"(version = 3
timeout = 2.5
[[parameter]]
name = "tension"
default = 0.5
least = 0.0
most = 1
most_included = false
help = "how tight"
[[parameter]]
name = "n"
default = 3
least = 1
help = "how many"
[[parameter]]
name = "way"
default = "chord"
choices = ["chord", "uniform"]
help = "which"
[[parameter]]
name = "on"
default = true
help = "whether"
[[mark]]
name = "flat"
help = "no curvature there"
[traits]
open = false
closed = true
fewest_open_points = 2
fewest_closed_points = 4
continuity = "G1 |k|"
continuity_exceptions = "cusps: G0"
locality = 2
similarity_invariant = false
reversal_invariant = false
cyclic_shift_invariant = false
repeats_allowed = true
hermite = true
refit_is_fit = false
)");
  const SchemeInfo& info = manifest.info;
  CHECK(info.id == "my-spline");
  CHECK(info.title == "My spline");
  CHECK(info.citation == "nobody");
  CHECK(info.version == 3);
  CHECK(manifest.timeout == 2.5);
  CHECK(manifest.command.words == std::vector<std::string>{"python3", "my.py"});
  REQUIRE(info.parameters.size() == 4);
  CHECK(range_text(info.parameters[0]) == "a number in [0, 1)");
  CHECK(info.parameters[0].help == "how tight");
  CHECK(range_text(info.parameters[1]) == "an integer in [1, inf)");
  CHECK(range_text(info.parameters[2]) == "chord|uniform");
  CHECK(std::get<std::string>(info.parameters[2].default_value) == "chord");
  CHECK(std::get<bool>(info.parameters[3].default_value));
  REQUIRE(info.marks.size() == 1);
  CHECK(info.marks[0].name == "flat");
  const SchemeTraits& t = info.traits;
  CHECK((!t.open && t.closed && t.fewest_open_points == 2 && t.fewest_closed_points == 4 && t.locality == 2));
  CHECK((!t.similarity_invariant && !t.reversal_invariant && !t.cyclic_shift_invariant));
  CHECK((t.repeats_allowed && t.hermite && !t.refit_is_fit));
  CHECK(t.continuity == Continuity::g1_equal_magnitude);
  CHECK(t.continuity_exceptions == "cusps: G0");
  CHECK(info.plugin.ends_with("my.toml"));
  CHECK(info.plugin_digest.size() == 16);
}

TEST_CASE("What a manifest leaves out has the value of any scheme") {
  const Manifest manifest = read(head + command + traits);
  CHECK(manifest.timeout == 20.0);
  CHECK(manifest.info.version == 1);
  CHECK(manifest.info.traits.locality == -1);
  CHECK(manifest.info.traits.open);
  for (const auto& [text, continuity] : {std::pair{"G0", Continuity::g0}, std::pair{"G2", Continuity::g2},
                                         std::pair{"C1", Continuity::c1}, std::pair{"C2", Continuity::c2}})
    CHECK(read(trait(fmt::format("continuity = \"{}\"\n", text))).info.traits.continuity == continuity);
}

TEST_CASE("What is wrong in a manifest is one line with the place") {
  refuses("id = \"a\"\nid = \"b\"\n", 2, "no TOML");
  refuses("id = \n", 1, "no TOML");
  refuses("id = " + std::string(100'000, '['), 1, "no TOML");
  refuses(std::string(2'000'000, '#'), 1, "more than 1048576 bytes");
  refuses("id = \"\xff\"\n", 1, "no TOML");
  refuses("title = \"x\"\n", 1, "id is missing; write id = ");
  refuses("id = 3\n", 1, "id: not a text");
  refuses("id = \"\"\n", 1, "id: empty");
  for (const std::string id : {"My-Spline", "my_spline", "my spline", "-spline", "3-spline", "é"})
    refuses("\nid = \"" + id + "\"\n", 2, "lower-case letters, digits and hyphens, a letter first");
  refuses("id = \"" + std::string(65, 'a') + "\"\n", 1, "at most 64");
  refuses("id = \"a\"\ntitle = \"two\\nlines\"\n", 2, "title: one line");
  refuses("id = \"a\"\ntitle = \"x\"\n", 1, "citation is missing");
  refuses(head + traits, 1, "command is missing; write command = [\"python3\"");
  refuses(head + "command = []\n" + traits, 4, "command: names no program");
  refuses(head + "command = \"python3\"\n" + traits, 4, "command: not a list of texts");
  refuses(head + "command = [\"python3\", 3]\n" + traits, 4, "command: not a text");
  refuses(head + command + "timeout = -1\n" + traits, 5, "timeout: -1; a number of seconds above 0");
  refuses(head + command + "timeout = 0\n" + traits, 5, "timeout: 0");
  refuses(head + command + "timeout = nan\n" + traits, 5, "timeout: not a finite number");
  refuses(head + command + "timeout = \"long\"\n" + traits, 5, "timeout: not a finite number");
  refuses(head + command + "version = 0\n" + traits, 5, "version: not an integer from 1");
  refuses(head + command + "files = [\"table.txt\"]\n" + traits, 5, "files: no file 'table.txt'");
  refuses(head + command + "tempo = 3\n" + traits, 5, "unknown key 'tempo'; known are id, title");
  refuses(head + command, 1, "traits are missing");
  refuses(head + command + "traits = 3\n", 5, "traits are missing; write a line [traits]");
  refuses(head + command + "parameter = 3\n" + traits, 5, "write [[parameter]] before each");
  refuses(head + command + "[parameter]\nname = \"p\"\n" + traits, 5, "write [[parameter]] before each");
  refuses(head + command + "[[mark]]\nname = \"m\"\n" + traits, 5, "help is missing");
}

TEST_CASE("What is wrong in a parameter is one line with the place") {
  refuses(head + command + "[[parameter]]\nhelp = \"h\"\n" + traits, 5, "name is missing");
  refuses(head + command + "[[parameter]]\nname = \"a b\"\n" + traits, 6, "letters, digits and underscores");
  refuses(parameter(""), 5, "default is missing");
  refuses(parameter("default = [1]\n"), 8, "default: not a boolean, an integer, a real number or text");
  refuses(parameter("default = inf\n"), 8, "default: not a finite number");
  refuses(parameter("default = 1979-05-27\n"), 8, "default: not a boolean");
  refuses(parameter("default = 2.0\nleast = 0.0\nmost = 1.0\n"), 8, "p=2: allowed is a number in [0, 1]");
  refuses(parameter("default = 1.0\nmost = 1.0\nmost_included = false\n"), 8, "a number in (-inf, 1)");
  refuses(parameter("default = \"x\"\nchoices = [\"y\"]\n"), 8, "p=x: allowed is y");
  refuses(parameter("default = \"x\"\nchoices = []\n"), 9, "choices: not a list");
  refuses(parameter("default = \"x,y\"\n"), 8, "commas and semicolons");
  refuses(parameter("default = \"x\"\nleast = 1\n"), 9, "least: 'p' is no number");
  refuses(parameter("default = 1\nchoices = [\"x\"]\n"), 9, "numbers have least and most");
  refuses(parameter("default = 1\nmin = 0\n"), 9, "unknown key 'min'");
  refuses(head + command + "[[parameter]]\nname = \"p\"\nhelp = \"h\"\ndefault = 1\n[[parameter]]\nname = \"p\"\n" +
              "help = \"h\"\ndefault = 1\n" + traits,
          10, "a second parameter 'p'");
}

TEST_CASE("What is wrong in the traits is one line with the place") {
  refuses(trait(""), 5, "continuity is missing");
  refuses(trait("continuity = \"G3\"\n"), 6, "continuity: 'G3'; known are G0, G1, G1 |k|, G2, C1, C2");
  refuses(trait("continuity = \"G1\"\nlocal = 2\n"), 7, "unknown trait 'local'; known are continuity");
  refuses(trait("continuity = \"G1\"\nlocality = -2\n"), 7, "locality: not an integer from -1");
  refuses(trait("continuity = \"G1\"\nlocality = 2.0\n"), 7, "locality: not an integer");
  refuses(trait("continuity = \"G1\"\nopen = 1\n"), 7, "open: neither true nor false");
  refuses(trait("continuity = \"G1\"\nfewest_open_points = 1\n"), 7, "fewest_open_points: not an integer from 2");
  refuses(trait("continuity = \"G1\"\nopen = false\nclosed = false\n"), 5, "neither open nor closed");
}

TEST_CASE("A manifest that cannot be used takes no other with it") {
  const ScratchFolder folder;
  const std::string good = head + command + traits;
  write(folder.path() / "good.toml", good);
  write(folder.path() / "again.toml", good);
  write(folder.path() / "bad.toml", "id = 3\n");
  Registry registry;
  const std::vector<std::filesystem::path> files{folder.path() / "missing.toml", folder.path() / "bad.toml",
                                                 folder.path() / "good.toml", folder.path() / "again.toml",
                                                 folder.path()};
  const auto failures = load_plugins(std::span(files).first(4), registry);
  REQUIRE(registry.list().size() == 1);
  CHECK(registry.list().front().id == "my-spline");
  REQUIRE(failures.size() == 3);
  CHECK_THAT(failures[0].why, ContainsSubstring("missing.toml: cannot be read; a manifest is a TOML file"));
  CHECK_THAT(failures[1].why, ContainsSubstring("bad.toml:1: id: not a text"));
  CHECK_THAT(failures[2].why, ContainsSubstring("again.toml: scheme 'my-spline' is registered already; choose"));
}

TEST_CASE("An id that a built-in scheme has is taken") {
  const ScratchFolder folder;
  write(folder.path() / "my.toml", "id = \"kappa\"\ntitle = \"x\"\ncitation = \"x\"\n" + command + traits);
  Registry registry;
  register_all(registry);
  CHECK_THROWS_AS(load_manifest(folder.path() / "my.toml", registry), std::invalid_argument);
}
