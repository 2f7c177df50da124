// Programs in other languages as schemes: honest ones give the numbers of the built-in scheme, and whatever a hostile
// one does is an outcome with one line that names its manifest.
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "datasets/datasets.hpp"
#include "experiments/check/check.hpp"
#include "experiments/run/cell.hpp"
#include "schemes/plugin/manifest.hpp"
#include "schemes/plugin/protocol.hpp"
#include "tests/catch.hpp"
#include "tests/integration/program.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;
namespace fs = std::filesystem;

namespace {

const fs::path examples = fs::path(KAPPABENCH_SOURCE) / "tests/external_example";

SchemePtr scheme_of(const fs::path& manifest) {
  Registry registry;
  load_manifest(manifest, registry);
  return registry.create(registry.list().front().id);
}

/// Polygons from hostile.py in a folder of its own, or what it makes of them.
class Hostile {
 public:
  explicit Hostile(std::string kind, double timeout = 30.0, std::string_view continuity = "G0")
      : Hostile(std::vector<std::string>{"python3", (examples / "hostile/hostile.py").string(), kind}, kind, timeout,
                continuity) {}
  explicit Hostile(const std::vector<std::string>& command) : Hostile(command, "who", 30.0, "G0") {}

  [[nodiscard]] fs::path manifest() const { return folder_.path() / "hostile.toml"; }
  [[nodiscard]] const fs::path& folder() const { return folder_.path(); }
  [[nodiscard]] Fit fit(bool closed = false) const { return fit(corners(closed)); }
  [[nodiscard]] Fit fit(const Input& input) const { return scheme_->fit(input); }
  /// The same program, which is asked for another kind of trouble.
  void turn(const std::string& kind) { scheme_ = registry_.create("hostile", {{"kind", kind}}); }

  static Input corners(bool closed) { return {.points = {{0, 0}, {4, 0}, {4, 3}, {1, 5}}, .closed = closed}; }

 private:
  Hostile(const std::vector<std::string>& command, const std::string& kind, double timeout,
          std::string_view continuity) {
    write(manifest(), fmt::format("id = \"hostile\"\ntitle = \"Hostile\"\ncitation = \"none\"\ncommand = {}\n"
                                  "timeout = {}\n[[parameter]]\nname = \"kind\"\ndefault = \"{}\"\n"
                                  "help = \"of trouble\"\n[traits]\ncontinuity = \"{}\"\nlocality = 1\n",
                                  nlohmann::json(command).dump(), timeout, kind, continuity));
    load_manifest(manifest(), registry_);
    turn(kind);
  }

  ScratchFolder folder_;
  Registry registry_;
  SchemePtr scheme_;
};

/// The outcome, and a message that names the manifest and says `what`.
void comes_to(const Hostile& hostile, const Fit& fit, Outcome outcome, const std::string& what) {
  INFO(fit.report.message);
  CHECK(name(fit.report.outcome) == name(outcome));
  CHECK_THAT(fit.report.message, ContainsSubstring(hostile.manifest().string()));
  CHECK_THAT(fit.report.message, ContainsSubstring(what));
  CHECK(std::ranges::none_of(fit.report.message, [](char c) { return static_cast<unsigned char>(c) < 0x20; }));
  CHECK(fit.report.message.size() < 1000);
  CHECK(fit.curve.has_value() == (outcome == Outcome::converged || outcome == Outcome::not_converged));
}

void comes_to(const std::string& kind, Outcome outcome, const std::string& what) {
  INFO(kind);
  const Hostile hostile(kind);
  comes_to(hostile, hostile.fit(), outcome, what);
}

void is_polygon(const Fit& fit) {
  INFO(fit.report.message);
  REQUIRE(fit.report.outcome == Outcome::converged);
  CHECK(fit.curve->size() == (fit.input.closed ? fit.input.size() : fit.input.size() - 1));
}

/// Gone, or dead and not waited for by whoever got it.
bool is_dead(int process) {
  std::ifstream stat(fmt::format("/proc/{}/stat", process));
  std::string number, command, state;
  if (stat >> number >> command >> state) return state == "Z";
  return kill(process, 0) != 0;
}

bool dies_soon(int process) {
  for (int i = 0; i < 500 && !is_dead(process); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return is_dead(process);
}

/// The largest distance between two curves at equal parameters, over the size of the drawing.
double apart(const Curve& a, const Curve& b) {
  if (a.size() != b.size()) return 1.0;
  double most = 0.0, size = 0.0;
  for (int i = 0; i < a.size(); ++i)
    for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      const Vec2 p = a.segment(i).jet(t, 0).position();
      most = std::max(most, (p - b.segment(i).jet(t, 0).position()).norm());
      size = std::max(size, (p - a.start()).norm());
    }
  return most / size;
}

void equals_catmull_rom(const fs::path& manifest, const std::vector<std::string>& drawings) {
  Registry registry;
  load_manifest(manifest, registry);
  const std::string id = registry.list().front().id;
  std::size_t compared = 0;
  for (const double alpha : {0.0, 0.5, 1.0}) {
    const SchemePtr outside = registry.create(id, {{"alpha", alpha}});
    const SchemePtr inside = all_schemes().create("catmull-rom", {{"alpha", alpha}});
    for (const std::string& id_of_drawing : drawings) {
      const Drawing drawing = open_drawings(id_of_drawing).front();
      for (const Input& input : drawing.curves) {
        const Fit found = outside->fit(input), expected = inside->fit(input);
        INFO(drawing.id << ", alpha " << alpha << ": " << found.report.message);
        CHECK(name(found.report.outcome) == name(expected.report.outcome));
        CHECK(found.report.warnings == expected.report.warnings);
        REQUIRE(found.curve.has_value() == expected.curve.has_value());
        if (!found.curve) continue;
        CHECK(apart(*found.curve, *expected.curve) < 1e-14);
        REQUIRE(found.curve->nodes().size() == expected.curve->nodes().size());
        for (std::size_t i = 0; i < found.curve->nodes().size(); ++i)
          CHECK(found.curve->nodes()[i].point == expected.curve->nodes()[i].point);
        ++compared;
      }
    }
  }
  CHECK(compared >= 3 * drawings.size());
}

bool there_is_octave() { return std::system("octave-cli --version >/dev/null 2>&1") == 0; }

std::set<std::string> refuted(const fs::path& manifest) {
  const auto checked = check::check("outside", [&] { return scheme_of(manifest); });
  UNSCOPED_INFO(check::page(checked));
  std::set<std::string> names;
  for (const auto& [claim, finding] : checked.claims)
    if (finding.verdict == check::Verdict::refuted) names.insert(claim.name);
  return names;
}

/// A skeleton of new-scheme, with its names filled in.
void copy_template(const std::string& language, const fs::path& to) {
  for (const auto& entry :
       fs::directory_iterator(fs::path(KAPPABENCH_SOURCE) / "experiments/program/templates" / language)) {
    const auto filled = [](std::string text) {
      for (const auto& [placeholder, value] : {std::pair{"@NAME@", "my-spline"}, std::pair{"@TITLE@", "My spline"}})
        for (std::size_t at = text.find(placeholder); at != std::string::npos; at = text.find(placeholder))
          text.replace(at, std::string_view(placeholder).size(), value);
      return text;
    };
    write(to / filled(entry.path().filename().string()), filled(contents(entry.path())));
  }
}

}  // namespace

// ---- honest programs

TEST_CASE("A Catmull-Rom in Python gives the built-in's numbers") {
  equals_catmull_rom(examples / "catmull_rom.toml", {"bird", "s-curve", "letter-r", "minimal-open", "minimal-closed",
                                                     "near-duplicates", "very-uneven"});
}

TEST_CASE("A Catmull-Rom in Octave gives the built-in's numbers") {
  if (!there_is_octave()) {
    WARN("octave-cli is not installed: nothing is tested here");
    return;
  }
  equals_catmull_rom(examples / "catmull_rom_octave.toml", {"bird", "s-curve", "minimal-open"});
}

TEST_CASE("The Catmull-Rom in Python keeps all that it claims") {
  CHECK(refuted(examples / "catmull_rom.toml") == std::set<std::string>{});
}

TEST_CASE("The skeleton in Python keeps all that it claims") {
  const ScratchFolder folder;
  copy_template("python", folder.path());
  CHECK(refuted(folder.path() / "my-spline.toml") == std::set<std::string>{});
}

TEST_CASE("The skeleton in MATLAB keeps all that it claims in Octave") {
  if (!there_is_octave()) {
    WARN("octave-cli is not installed: nothing is tested here");
    return;
  }
  const ScratchFolder folder;
  copy_template("matlab", folder.path());
  CHECK(refuted(folder.path() / "my-spline.toml") == std::set<std::string>{});
}

TEST_CASE("A program that draws corners and claims G2 is refuted") {
  const Hostile liar("says_more", 30.0, "G2");
  const Fit fit = liar.fit();
  CHECK(fit.report.outcome == Outcome::not_converged);
  CHECK_THAT(fit.report.message, ContainsSubstring("claims G2, but the direction turns"));
  CHECK(refuted(liar.manifest()).contains("continuity"));
}

TEST_CASE("What a program says of its fit is taken over, its seconds marked as another process's") {
  const Fit fit = Hostile("says_more").fit();
  is_polygon(fit);
  CHECK(fit.report.iterations == 5);
  CHECK(fit.report.residual == 1e-9);
  CHECK(fit.report.seconds == 12.5);
  CHECK(fit.report.counters == std::map<std::string, long>{{"external", 1}, {"steps", 3}});
}

TEST_CASE("Without seconds of its own a fit took the time from question to answer") {
  const auto start = std::chrono::steady_clock::now();
  const Fit fit = Hostile("who").fit();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  is_polygon(fit);
  CHECK(fit.report.seconds > 0.0);
  CHECK(fit.report.seconds < passed.count());
}

TEST_CASE("The question has the points, their options in the units of files, and every parameter") {
  Input input{.points = {{0.1, 0}, {1, 1e-300}}, .closed = true};
  input.options.resize(2);
  input.options[1] = {.type = PointType::cusp, .a = 0.75, .tangent = std::numbers::pi / 4.0};
  const std::vector<ParameterSpec> specs{{.name = "f", .default_value = true, .help = ""},
                                         {.name = "i", .default_value = 3L, .help = ""},
                                         {.name = "r", .default_value = 1.0, .help = ""},
                                         {.name = "t", .default_value = std::string("x\"y"), .help = ""}};
  CHECK(question_of(input, Parameters(specs, {})) ==
        R"({"format":"kappabench-input","version":1,"points":[[0.1,0.0],[1.0,1e-300]],"closed":true,)"
        R"("options":[{},{"type":"cusp","a":0.75,"tangent":45.0}],)"
        R"("parameters":{"f":true,"i":3,"r":1.0,"t":"x\"y"}})"
        "\n");
}

namespace {

/// What authors do to the helper files is no harm.
void helper_holds(const fs::path& manifest, const std::string& error) {
  Registry registry;
  load_manifest(manifest, registry);
  const std::string id = registry.list().front().id;
  const auto fit = [&](const std::string& kind) {
    const Fit found = registry.create(id, {{"kind", kind}})->fit(Hostile::corners(false));
    UNSCOPED_INFO(kind << ": " << found.report.message);
    return found;
  };
  is_polygon(fit("prints"));
  const Fit more = fit("more");
  is_polygon(more);
  CHECK(more.report.iterations == 3);
  CHECK(more.report.message == "fine");
  CHECK(more.report.counters.at("steps") == 2);
  CHECK(more.report.seconds < 10.0);
  const Fit raised = fit("raises");
  CHECK(raised.report.outcome == Outcome::failed);
  CHECK_THAT(raised.report.message, ContainsSubstring(error));
  const Fit refused = fit("refuses");
  CHECK(refused.report.outcome == Outcome::unsupported_input);
  CHECK_THAT(refused.report.message, ContainsSubstring("more than 3 points"));
  for (const std::string kind : {"nan", "nothing"}) {
    const Fit failed = fit(kind);
    CHECK(failed.report.outcome == Outcome::failed);
    CHECK_FALSE(failed.report.message.empty());
  }
}

}  // namespace

TEST_CASE("The helper for Python lets authors print, raise and return nonsense") {
  helper_holds(examples / "careless/careless.toml",
               "ZeroDivisionError: integer division or modulo by zero (careless.py:");
}

TEST_CASE("The helper for MATLAB lets authors print, raise and return nonsense in Octave") {
  if (!there_is_octave()) {
    WARN("octave-cli is not installed: nothing is tested here");
    return;
  }
  helper_holds(examples / "careless/careless_octave.toml", "(careless:8)");
}

// ---- answers that are none

TEST_CASE("An answer that is no curve JSON is a failed fit") {
  const std::vector<std::pair<std::string, std::string>> kinds{
      {"not_json", "JSON"},
      {"stray_print", "JSON"},
      {"not_utf8", "JSON"},
      {"cut_off", "JSON"},
      {"nested", "answer"},
      {"nothing_in_it", "segments"},
      {"a_number", "answer"},
      {"other_format", "gerber"},
      {"other_version", "99"},
      {"two_curves", "2 curves; one is asked"},
      {"no_segments", "no segments"},
      {"no_such_type", "nurbs"},
      {"one_control_point", "control"},
      {"three_coordinates", "[x, y]"},
      {"not_a_number", "JSON"},
      {"null", "null"},
      {"infinite", "answer"},
      {"wrong_count", "weight"},
      {"no_such_node", "node"},
      {"no_such_joint", "joint"},
      {"no_such_outcome", "splendid"},
      {"not_its_outcome", "a program says converged, not_converged, unsupported_input or failed"},
      {"bad_counter", "counter 'two words'"},
      {"bad_count", "counters"},
      {"many_counters", "1000 counters; at most 64"},
      {"negative_time", "seconds: -1"}};
  Hostile hostile("who");
  for (const auto& [kind, what] : kinds) {
    INFO(kind);
    hostile.turn(kind);
    comes_to(hostile, hostile.fit(), Outcome::failed, what);
  }
  hostile.turn("who");
  is_polygon(hostile.fit());
}

TEST_CASE("A curve from outside is held against its claims like any other") {
  const auto unsound = [](const std::string& kind, const std::string& what) {
    const Fit fit = Hostile(kind).fit(true);
    INFO(kind << ": " << fit.report.message);
    CHECK(fit.report.outcome == Outcome::not_converged);
    CHECK_THAT(fit.report.message, ContainsSubstring(what));
  };
  unsound("misses_points", "passes point");
  unsound("open_for_closed", "the curve is open, the input closed");
}

TEST_CASE("A program may say that it failed") {
  const Fit failed = Hostile("says_failed").fit();
  CHECK(failed.report.outcome == Outcome::failed);
  CHECK(failed.report.message == "no idea [31m");
  CHECK(failed.report.iterations == 7);
  CHECK_FALSE(failed.curve.has_value());
  const Fit unsolved = Hostile("says_unsolved").fit();
  CHECK(unsolved.report.outcome == Outcome::not_converged);
  CHECK(unsolved.report.message == "still 0.5 off");
  CHECK(unsolved.curve.has_value());
}

// ---- no answers

TEST_CASE("No answer in time is a time-out") {
  const Input many{.points = [] {
    std::vector<Vec2> points;
    for (int i = 0; i < 100'000; ++i) points.emplace_back(i, i % 2);
    return points;
  }()};
  for (const std::string kind : {"silence", "endless_complaints", "deaf"}) {
    INFO(kind);
    const Hostile hostile(kind, 0.5);
    const auto start = std::chrono::steady_clock::now();
    comes_to(hostile, hostile.fit(many), Outcome::timed_out, "no answer in 0.5 s");
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
  }
}

TEST_CASE("Endless output is cut off") { comes_to("endless_line", Outcome::failed, "bytes without an end of line"); }

TEST_CASE("A program that ends before it answers has crashed") {
  comes_to("exits", Outcome::crashed, "exited with status 0 before it answered");
  comes_to("exits_at_once", Outcome::crashed, "exited with status 3");
  comes_to("aborts", Outcome::crashed, "ended by signal Aborted");
  comes_to("closes_output", Outcome::crashed, "closed its standard output");
  comes_to("kills_guardian", Outcome::crashed, "before it answered");
}

TEST_CASE("What a crashed program said last is in the message, cleaned") {
  comes_to("fails", Outcome::crashed, "ValueError: no  curve fits");
  comes_to("mutters", Outcome::crashed, "last words");
}

TEST_CASE("A program that does not read is no reason to die of SIGPIPE") {
  const Hostile hostile("exits_at_once");
  Input many;
  for (int i = 0; i < 100'000; ++i) many.points.emplace_back(i, i % 2);
  comes_to(hostile, hostile.fit(many), Outcome::crashed, "exited with status 3");
}

TEST_CASE("A program that cannot be started is a failed fit") {
  const auto fails = [](const Hostile& hostile, const std::string& what) {
    comes_to(hostile, hostile.fit(), Outcome::failed, what);
  };
  fails(Hostile(std::vector<std::string>{"no-such-program"}), "cannot start 'no-such-program': No such file");
  fails(Hostile(std::vector<std::string>{"./no/such/program"}), "No such file");
  const Hostile data(std::vector<std::string>{"data.txt"});
  write(data.folder() / "data.txt", "no program");
  fails(data, "make it executable");
  fs::permissions(data.folder() / "data.txt", fs::perms::owner_all);
  fails(data, "Exec format error; a script begins with");
  write(data.folder() / "data.txt", "#!/no/such/interpreter\n");
  fails(data, "No such file");
}

// ---- afterwards

TEST_CASE("Noise beside an answer is no harm") {
  is_polygon(Hostile("many_complaints").fit());
  is_polygon(Hostile("in_pieces").fit());
  const Hostile twice("answers_twice");
  for (int i = 0; i < 3; ++i) is_polygon(twice.fit(i == 1));
}

TEST_CASE("A program is started anew after it has crashed, hung or ended") {
  const Hostile crashing("aborts_once"), hanging("silent_once", 3.0), ending("answers_once");
  CHECK(crashing.fit().report.outcome == Outcome::crashed);
  is_polygon(crashing.fit());
  CHECK(hanging.fit().report.outcome == Outcome::timed_out);
  is_polygon(hanging.fit());
  for (int i = 0; i < 3; ++i) is_polygon(ending.fit(i == 1));
}

TEST_CASE("Threads share one program and get their own answers") {
  const Hostile hostile("who");
  std::vector<Fit> fits(64);
  std::vector<std::thread> threads;
  for (std::size_t thread = 0; thread < 8; ++thread)
    threads.emplace_back([&, thread] {
      for (std::size_t i = thread; i < fits.size(); i += 8) {
        Input input = Hostile::corners(i % 2 == 0);
        input.points.emplace_back(-2.0, static_cast<double>(i));
        fits[i] = hostile.fit(input);
      }
    });
  for (std::thread& thread : threads) thread.join();
  std::set<long> processes;
  for (const Fit& fit : fits) {
    is_polygon(fit);
    processes.insert(fit.report.counters.at("process"));
  }
  CHECK(processes.size() == 1);
  // The thread that started it is gone, the program is not.
  CHECK(processes.contains(hostile.fit().report.counters.at("process")));
}

TEST_CASE("After a fork each process has a program of its own") {
  const Hostile hostile("who");
  const long ours = hostile.fit().report.counters.at("process");
  const pid_t child = fork();
  if (child == 0) {
    const Fit fit = hostile.fit();
    _exit(fit.report.outcome == Outcome::converged && fit.report.counters.at("process") != ours ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  CHECK(status == 0);
  CHECK(hostile.fit().report.counters.at("process") == ours);
}

TEST_CASE("Nothing is left of a program and what it started") {
  int program = 0, child = 0;
  {
    const Hostile crashing("leaves_children");
    comes_to(crashing, crashing.fit(), Outcome::crashed, "exited with status 3");
    std::ifstream(crashing.folder() / "child.txt") >> program >> child;
    REQUIRE(child > 0);
    CHECK(dies_soon(child));
    const Hostile hanging("leaves_children", 2.0);
    comes_to(hanging, hanging.fit(true), Outcome::timed_out, "no answer");
    std::ifstream(hanging.folder() / "child.txt") >> program >> child;
    CHECK(dies_soon(program));
    CHECK(dies_soon(child));
  }
  {
    const Hostile idle("who");
    program = static_cast<int>(idle.fit().report.counters.at("process"));
    CHECK_FALSE(is_dead(program));
  }
  CHECK(dies_soon(program));
}

TEST_CASE("A program dies with a worker that is killed") {
  const Hostile hostile("leaves_children", 1000.0);
  const pid_t worker = fork();
  if (worker == 0) {
    static_cast<void>(hostile.fit(true));
    _exit(0);
  }
  const fs::path told = hostile.folder() / "child.txt";
  int program = 0, child = 0;
  for (int i = 0; i < 1000 && child == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::ifstream(told) >> program >> child;
  }
  REQUIRE(child > 0);
  CHECK_FALSE(is_dead(child));
  kill(worker, SIGKILL);
  waitpid(worker, nullptr, 0);
  CHECK(dies_soon(program));
  CHECK(dies_soon(child));
}

TEST_CASE("Restarts leave no file descriptors behind") {
  const auto open_files = [] {
    return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
  };
  if (!fs::exists("/proc/self/fd")) return;
  const Hostile hostile("exits_at_once");
  const auto before = open_files();
  for (int i = 0; i < 20; ++i) CHECK(hostile.fit().report.outcome == Outcome::crashed);
  CHECK(open_files() == before);
}

// ---- the store

TEST_CASE("A cell's key changes with the manifest, the script and the files that it names") {
  const ScratchFolder folder;
  const fs::path manifest = folder.path() / "m.toml";
  const auto key = [&] {
    const Drawing drawing{.id = "corners", .curves = {Hostile::corners(false)}};
    return fit_job(drawing, scheme_of(manifest), {}).key();
  };
  const auto manifest_text = [](std::string_view title) {
    return fmt::format(
        "id = \"m\"\ntitle = \"{}\"\ncitation = \"none\"\ncommand = [\"python3\", \"m.py\"]\n"
        "files = [\"table.txt\"]\n[traits]\ncontinuity = \"G0\"\n",
        title);
  };
  write(manifest, manifest_text("one"));
  write(folder.path() / "m.py", "pass\n");
  write(folder.path() / "table.txt", "1\n");
  std::set<std::string> keys{key()};
  CHECK(keys.contains(key()));
  write(folder.path() / "m.py", "pass \n");
  keys.insert(key());
  write(folder.path() / "table.txt", "2\n");
  keys.insert(key());
  write(manifest, manifest_text("two"));
  keys.insert(key());
  CHECK(keys.size() == 4);
  write(folder.path() / "not_named.txt", "3\n");
  CHECK(keys.contains(key()));
}
