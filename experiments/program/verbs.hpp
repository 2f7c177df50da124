#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "schemes/api/registry.hpp"
#include "schemes/plugin/plugins.hpp"

namespace kappabench {

/// The verbs of the command line. Each returns an exit status and throws UsageError, DataError or
/// std::invalid_argument for what the user got wrong.

struct ListArguments {
  std::string what;  ///< schemes | datasets | metrics | experiments
  bool json = false;
  std::vector<PluginFailure> failed_plugins{};
};
int list(const Registry& registry, const ListArguments& arguments);

struct FitArguments {
  std::string points;
  std::string scheme;
  std::string format{};            ///< empty: as the ending of `output` says
  std::filesystem::path output{};  ///< empty: standard output
};
int fit(const Registry& registry, const FitArguments& arguments);

struct HermiteArguments {
  std::string from;  ///< "x,y,DEG[,kappa]": point, direction in degrees against the x axis, signed curvature
  std::string to;
  std::string scheme = "intrinsic";
  std::string format{};            ///< empty: as the ending of `output` says
  std::filesystem::path output{};  ///< empty: standard output
};
int hermite(const Registry& registry, const HermiteArguments& arguments);

struct CompareArguments {
  std::vector<std::string> points;
  std::vector<std::string> schemes{};
  std::vector<std::string> metrics{};
  std::vector<std::string> curves{};  ///< files of curves that were made elsewhere
  std::string format = "table";       ///< table | csv | json | latex
  std::filesystem::path output{};     ///< a folder for the report; empty: only the table
  std::filesystem::path against{};    ///< a results file whose schemes stand beside; empty: none
  int processes = 1;
};
int compare(const Registry& registry, const CompareArguments& arguments);

struct MeasureArguments {
  std::vector<std::string> curves;    ///< files
  std::vector<std::string> points{};  ///< drawings; empty: the curves' own points
  std::vector<std::string> metrics{};
  std::string format = "table";    ///< table | csv | json | latex
  std::filesystem::path output{};  ///< a folder for the report; empty: only the table
};
int measure(const Registry& registry, const MeasureArguments& arguments);

struct CheckArguments {
  std::string scheme{};  ///< ID[:key=value,...]; empty with `all`
  bool all = false;
  bool json = false;
  std::filesystem::path output{};  ///< empty: standard output
};
int check_verb(const Registry& registry, const CheckArguments& arguments);

struct RunArguments {
  std::vector<std::string> plans_or_experiments;
  std::filesystem::path results{};
  int processes = 1;
  bool resume = false;
  std::string shard{};  ///< "I/N"
  double timeout = 0.0;
};
int run_verb(const Registry& registry, const RunArguments& arguments);

struct ReproduceArguments {
  std::vector<std::string> experiments{};  ///< empty: all of experiments/plans/all.toml
  std::filesystem::path folder;
  int processes = 1;
};
int reproduce(const Registry& registry, const ReproduceArguments& arguments);

struct MergeArguments {
  std::vector<std::filesystem::path> shards;
  std::filesystem::path results;
};
int merge_verb(const Registry& registry, const MergeArguments& arguments);

struct NewSchemeArguments {
  std::string name;
  std::filesystem::path folder;
  std::string kind = "in-tree";  ///< in-tree | plugin | python | matlab
};
int new_scheme(const Registry& registry, const NewSchemeArguments& arguments);

struct DiffArguments {
  std::filesystem::path before, after;
  std::string format = "table";  ///< table (by column) | csv | json (every change)
};
int diff_verb(const DiffArguments& arguments);

struct ReportArguments {
  std::filesystem::path results;
  std::filesystem::path folder;
};
int report(const ReportArguments& arguments);

}  // namespace kappabench
