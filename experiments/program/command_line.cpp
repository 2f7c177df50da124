#include "experiments/program/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <new>
#include <set>
#include <system_error>
#include <thread>

#include "datasets/datasets.hpp"
#include "datasets/text.hpp"
#include "experiments/program/errors.hpp"
#include "experiments/program/verbs.hpp"
#include "experiments/run/house.hpp"
#include "experiments/run/provenance.hpp"
#include "schemes/api/known_words.hpp"

namespace kappabench {

namespace {

/// Drawings inside the program say where they come from; those of a user need not.
std::vector<Drawing> drawings_to_check() {
  return std::getenv("KAPPABENCH_DATASETS") == nullptr ? builtin_drawings() : std::vector<Drawing>{};
}

int complain(ExitStatus status, std::string message) {
  // One line, whatever the library that complains likes.
  std::ranges::replace(message, '\n', ' ');
  fmt::print(stderr, "kappabench: {}\n", message);
  return status;
}

/// Everything a user can ask for: the parsed arguments of each verb, and the parser that fills them.
struct CommandLine {
  CLI::App app{"kappabench: the research benchmark for interpolatory planar curves", "kappabench"};
  ListArguments list_arguments{};
  FitArguments fit_arguments{};
  HermiteArguments hermite_arguments{};
  CompareArguments compare_arguments{};
  MeasureArguments measure_arguments{};
  CheckArguments check_arguments{};
  RunArguments run_arguments{};
  ReproduceArguments reproduce_arguments{};
  MergeArguments merge_arguments{};
  ReportArguments report_arguments{};
  DiffArguments diff_arguments{};
  NewSchemeArguments new_scheme_arguments{};
  std::vector<std::string> plugins{};  ///< known before the rest is read: plugins_named
  int status = success;

  CommandLine(const Registry& registry, const std::vector<PluginFailure>& failed_plugins) {
    list_arguments.failed_plugins = failed_plugins;
    app.require_subcommand(1);
    app.set_version_flag("--version", version_text());
    add_list(registry);
    add_fit(registry);
    add_hermite(registry);
    add_compare(registry);
    add_measure(registry);
    add_check(registry);
    add_run(registry);
    add_reproduce(registry);
    add_merge(registry);
    add_report();
    add_diff();
    for (CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
      verb->add_option("--plugin", plugins,
                       "FILE with schemes from outside: *.toml or a shared library; may be repeated")
          ->allow_extra_args(false);
    add_new_scheme(registry);
  }

  static int all_processors() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

  void add_list(const Registry& registry) {
    CLI::App* verb = app.add_subcommand("list", "What there is: schemes, datasets, metrics, experiments");
    verb->add_option("WHAT", list_arguments.what, "schemes|datasets|metrics|experiments")
        ->required()
        ->check(CLI::IsMember({"schemes", "datasets", "metrics", "experiments"}));
    verb->add_flag("--json", list_arguments.json, "as JSON");
    verb->callback([&] { status = list(registry, list_arguments); });
  }

  void add_fit(const Registry& registry) {
    CLI::App* verb = app.add_subcommand("fit", "Fit one drawing with one scheme");
    verb->add_option("POINTS", fit_arguments.points, "a drawing's id, a file, or - for standard input")->required();
    verb->add_option("--scheme,--schemes", fit_arguments.scheme, "ID[:key=value,...]")->required();
    verb->add_option("--format", fit_arguments.format,
                     "json|csv|svg|xy (default: what the ending of the output says, else json)")
        ->check(CLI::IsMember({"json", "csv", "svg", "xy"}));
    verb->add_option("-o,--output", fit_arguments.output, "file to write; default: standard output");
    verb->footer(
        "Drawings besides files: random:KIND:n=20,seed=1, analytic:KIND:n=20, glyph:CHARACTER; see "
        "datasets/README.md.\n"
        "Examples:\n"
        "  kappabench fit bird --scheme kappa -o bird.svg\n"
        "  kappabench fit points.csv --scheme ekappa:a=0.8 -o curve.json\n"
        "  kappabench fit random:walk:n=30,seed=7 --scheme pkappa --format csv\n"
        "  printf '0 0\\n1 2\\n3 1\\n' | kappabench fit - --scheme hobby --format svg -o curve.svg");
    verb->callback([&] { status = fit(registry, fit_arguments); });
  }

  void add_hermite(const Registry& registry) {
    CLI::App* verb = app.add_subcommand("hermite", "Join two points with given tangents, and curvatures if given");
    verb->add_option("--from", hermite_arguments.from, "x,y,DEG[,kappa]: point, direction in degrees, curvature")
        ->required();
    verb->add_option("--to", hermite_arguments.to, "x,y,DEG[,kappa]")->required();
    verb->add_option("--scheme", hermite_arguments.scheme, "ID[:key=value,...] that can do it")->capture_default_str();
    verb->add_option("--format", hermite_arguments.format,
                     "json|csv|svg|xy (default: what the ending of the output says, else json)")
        ->check(CLI::IsMember({"json", "csv", "svg", "xy"}));
    verb->add_option("-o,--output", hermite_arguments.output, "file to write; default: standard output");
    verb->footer(
        "Directions are against the x axis, anticlockwise; curvature is 1/length, positive to the left.\n"
        "Examples:\n"
        "  kappabench hermite --from 0,0,30 --to 2,1,-45 --format svg -o curve.svg\n"
        "  kappabench hermite --from 0,0,-20,0.3 --to 1,0,40,2.2\n"
        "  kappabench hermite --from 0,0,-20,0.3 --to 1,0,40,1.55 --scheme clothoid3");
    verb->callback([&] { status = hermite(registry, hermite_arguments); });
  }

  void add_compare(const Registry& registry) {
    CLI::App* verb = app.add_subcommand("compare", "Compare schemes on your points");
    compare_arguments.processes = all_processors();
    verb->add_option("POINTS", compare_arguments.points, "drawings: ids, files, folders")->required();
    verb->add_option("--schemes,--scheme", compare_arguments.schemes, "ID[:key=value,...],... (default: all)")
        ->delimiter(',')
        ->allow_extra_args(false);
    verb->add_option("--metrics", compare_arguments.metrics, "metric ids (default: those of 'compare')")
        ->delimiter(',');
    verb->add_option("--curves", compare_arguments.curves, "files of curves made elsewhere: SVG, curve JSON")
        ->delimiter(',');
    verb->add_option("--format", compare_arguments.format, "table|csv|json|latex")
        ->check(CLI::IsMember({"table", "csv", "json", "latex"}));
    verb->add_option("--against", compare_arguments.against,
                     "RESULTS.h5: its schemes on the same points stand beside, and are not computed again");
    verb->add_option("-o,--output", compare_arguments.output, "folder for results, figures and index.html");
    verb->callback([&] { status = compare(registry, compare_arguments); });
  }

  void add_measure(const Registry& registry) {
    CLI::App* verb = app.add_subcommand("measure", "Measure curves that were made elsewhere");
    verb->add_option("CURVE", measure_arguments.curves, "files: SVG, curve JSON, or - for standard input")->required();
    verb->add_option("--points", measure_arguments.points, "drawings to judge them against (default: their own points)")
        ->delimiter(',');
    verb->add_option("--metrics", measure_arguments.metrics, "metric ids (default: all that do not fit)")
        ->delimiter(',');
    verb->add_option("--format", measure_arguments.format, "table|csv|json|latex")
        ->check(CLI::IsMember({"table", "csv", "json", "latex"}));
    verb->add_option("-o,--output", measure_arguments.output, "folder for results, figures and index.html");
    verb->footer(
        "Of SVG every path, line, polyline, polygon, rect, circle and ellipse is read, where its transforms put it, "
        "in\n"
        "units of the viewBox with y upwards. A curve's own points are the nodes that curve JSON names, else its\n"
        "vertices. A curve that misses the points is not_converged; the residual is its largest distance from a point\n"
        "over the mean chord.\n"
        "Examples:\n"
        "  kappabench measure drawing.svg\n"
        "  kappabench measure mine.svg theirs.json --points bird -o page");
    verb->callback([&] { status = measure(registry, measure_arguments); });
  }

  void add_check(const Registry& registry) {
    CLI::App* verb = app.add_subcommand("check", "Try every claim that a scheme makes of itself");
    verb->add_option("SCHEME", check_arguments.scheme, "ID[:key=value,...]");
    verb->add_flag("--all", check_arguments.all, "every scheme: one line each, then what is refuted");
    verb->add_flag("--json", check_arguments.json, "as JSON");
    verb->add_option("-o,--output", check_arguments.output, "file to write; default: standard output");
    verb->footer("Exit status 0 if nothing is refuted, 3 if something is.");
    verb->callback([&] { status = check_verb(registry, check_arguments); });
  }

  void add_run(const Registry& registry) {
    CLI::App* verb = app.add_subcommand("run", "Run experiments, or the plans that name them");
    run_arguments.processes = all_processors();
    run_arguments.results = "results.h5";
    verb->add_option("PLAN", run_arguments.plans_or_experiments, "PLAN.toml or an experiment's id")->required();
    verb->add_option("-o,--output", run_arguments.results, "results file")->capture_default_str();
    verb->add_option("-j,--jobs", run_arguments.processes, "cells at once")->check(CLI::Range(1, 1024));
    verb->add_flag("--resume", run_arguments.resume, "compute only what changed since the last run");
    verb->add_option("--shard", run_arguments.shard, "I/N: every N-th cell, starting with the I-th");
    verb->add_option("--timeout", run_arguments.timeout, "seconds a cell may take")->check(CLI::NonNegativeNumber);
    verb->callback([&] { status = run_verb(registry, run_arguments); });
  }

  void add_reproduce(const Registry& registry) {
    CLI::App* verb = app.add_subcommand("reproduce", "Run every experiment and write the report");
    reproduce_arguments.processes = all_processors();
    reproduce_arguments.folder = "results";
    verb->add_option("EXPERIMENT", reproduce_arguments.experiments, "ids (default: all)");
    verb->add_option("-o,--output", reproduce_arguments.folder, "folder")->capture_default_str();
    verb->add_option("-j,--jobs", reproduce_arguments.processes, "cells at once")->check(CLI::Range(1, 1024));
    verb->callback([&] { status = reproduce(registry, reproduce_arguments); });
  }

  void add_merge(const Registry& registry) {
    CLI::App* verb = app.add_subcommand("merge", "Join the results of shards");
    verb->add_option("RESULTS", merge_arguments.shards, "results files of shards")->required();
    verb->add_option("-o,--output", merge_arguments.results, "the joined results file")->required();
    verb->callback([&] { status = merge_verb(registry, merge_arguments); });
  }

  void add_report() {
    CLI::App* verb = app.add_subcommand("report", "Tables, figures and index.html of a results file");
    verb->add_option("RESULTS", report_arguments.results, "results file")->required();
    verb->add_option("-o,--output", report_arguments.folder, "folder")->required();
    verb->callback([&] { status = report(report_arguments); });
  }

  void add_new_scheme(const Registry& registry) {
    CLI::App* verb =
        app.add_subcommand("new-scheme", "Write the skeleton of a scheme of your own, which works already");
    verb->add_option("NAME", new_scheme_arguments.name, "its id: lower-case letters, digits and hyphens")->required();
    verb->add_option("DIR", new_scheme_arguments.folder, "a new folder")->required();
    CLI::Option_group* kinds = verb->add_option_group("language");
    for (const std::string kind : {"in-tree", "plugin", "python", "matlab"})
      kinds->add_flag_callback(
          "--" + kind, [this, kind] { new_scheme_arguments.kind = kind; },
          kind == "in-tree"  ? "C++, a folder of schemes/ (default)"
          : kind == "plugin" ? "C++, a shared library of its own"
          : kind == "python" ? "Python, a program of its own"
                             : "MATLAB or Octave, a program of its own");
    kinds->require_option(0, 1);
    verb->footer(
        "Examples:\n"
        "  kappabench new-scheme my-spline my-spline --python\n"
        "  kappabench new-scheme my-spline schemes/my_spline --in-tree");
    verb->callback([&] { status = new_scheme(registry, new_scheme_arguments); });
  }

  void add_diff() {
    CLI::App* verb = app.add_subcommand("diff", "What changed from one results file to another");
    verb->add_option("OLD", diff_arguments.before, "results file")->required();
    verb->add_option("NEW", diff_arguments.after, "results file")->required();
    verb->add_option("--format", diff_arguments.format, "table (by column)|csv|json (every change)")
        ->check(CLI::IsMember({"table", "csv", "json"}));
    verb->footer("Times, messages and provenance are left out; numbers are held against each other bit by bit.");
    verb->callback([&] { status = diff_verb(diff_arguments); });
  }
};

/// The files of --plugin on the command line: schemes must be known before it is read.
std::vector<std::filesystem::path> plugins_named(int argc, char** argv) {
  constexpr std::string_view option = "--plugin";
  std::vector<std::filesystem::path> files;
  if (argc > 1 && std::string_view(argv[1]) == "new-scheme") return files;  // whose --plugin is another one
  for (int i = 1; i < argc; ++i) {
    const std::string_view word(argv[i]);
    if (word == option && i + 1 < argc) files.emplace_back(argv[++i]);
    if (word.starts_with("--plugin=")) files.emplace_back(word.substr(option.size() + 1));
  }
  return files;
}

/// Those of the variable KAPPABENCH_PLUGINS, a list like PATH.
std::vector<std::filesystem::path> plugins_of_environment() {
  const char* list = std::getenv("KAPPABENCH_PLUGINS");
  std::vector<std::filesystem::path> files;
  if (list == nullptr) return files;
  for (const std::string_view file : split(list, ':'))
    if (!file.empty()) files.emplace_back(file);
  return files;
}

/// The same files, each once: one that the environment names may be named again.
std::vector<std::filesystem::path> each_once(const std::vector<std::filesystem::path>& files,
                                             const std::vector<std::filesystem::path>& but = {}) {
  const auto place = [](const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(file, ignored);
  };
  std::set<std::filesystem::path> seen;
  for (const std::filesystem::path& file : but) seen.insert(place(file));
  std::vector<std::filesystem::path> once;
  std::ranges::copy_if(files, std::back_inserter(once),
                       [&](const std::filesystem::path& file) { return seen.insert(place(file)).second; });
  return once;
}

/// Adds the schemes from outside. What cannot be loaded is a line each; if the command line names it, an error, except
/// where the question is what there is, and the list of schemes says it itself.
std::vector<PluginFailure> add_plugins(int argc, char** argv, Registry& registry) {
  const std::vector<std::filesystem::path> files = plugins_named(argc, argv);
  std::vector<PluginFailure> failures = load_plugins(each_once(plugins_of_environment(), files), registry);
  const std::vector<PluginFailure> named = load_plugins(each_once(files), registry);
  const bool listing = argc > 1 && std::string_view(argv[1]) == "list";
  if (!listing && !named.empty()) throw UsageError(named.front().why);
  failures.insert(failures.end(), named.begin(), named.end());
  const bool listing_schemes = listing && argc > 2 && std::string_view(argv[2]) == "schemes";
  if (!listing_schemes)
    for (const PluginFailure& failure : failures) fmt::print(stderr, "kappabench: not loaded: {}\n", failure.why);
  return failures;
}

/// CLI11 would only say that a verb is missing.
void require_known_verb(const CLI::App& app, std::string_view word) {
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    verbs.push_back(verb->get_name());
  if (!word.starts_with('-') && std::ranges::find(verbs, word) == verbs.end())
    throw UsageError(fmt::format("unknown verb '{}'; {}", word, known_words(word, verbs)));
}

}  // namespace

int run_command_line(int argc, char** argv) {
  try {
    Registry registry;
    register_all(registry);
    check_house(all_experiments(), printed_papers(), drawings_to_check());
    const std::vector<PluginFailure> failed_plugins = add_plugins(argc, argv, registry);
    CommandLine command(registry, failed_plugins);
    if (argc > 1) require_known_verb(command.app, argv[1]);
    try {
      command.app.parse(argc, argv);
      return command.status;
    } catch (const CLI::Success& request) {  // --help
      return command.app.exit(request);
    } catch (const CLI::ParseError& error) {
      return complain(bad_usage, fmt::format("{}; see 'kappabench --help'", error.what()));
    }
  } catch (const std::bad_alloc&) {
    return complain(ran_and_failed, "out of memory");
  } catch (const std::logic_error& error) {  // std::invalid_argument: unknown ids, bad values
    return complain(bad_usage, error.what());
  } catch (const std::exception& error) {
    return complain(bad_usage, error.what());
  }
}

}  // namespace kappabench
