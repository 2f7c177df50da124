#include <fmt/format.h>

#include <algorithm>

#include "experiments/check/check.hpp"
#include "experiments/program/errors.hpp"
#include "experiments/program/in_child.hpp"
#include "experiments/program/progress_bar.hpp"
#include "experiments/program/verbs.hpp"
#include "experiments/program/write_file.hpp"

namespace kappabench {

namespace {

std::vector<std::string> schemes_of(const Registry& registry, const CheckArguments& arguments) {
  if (arguments.all != arguments.scheme.empty())
    throw UsageError("check: give one scheme, ID[:key=value,...], or --all");
  if (!arguments.all) return {arguments.scheme};
  std::vector<std::string> ids;
  for (const SchemeInfo& info : registry.list()) ids.push_back(info.id);
  return ids;
}

std::string written(const CheckArguments& arguments, const std::vector<check::Checked>& all) {
  if (arguments.json) return check::json(all);
  return arguments.all ? check::overview(all) : check::page(all.front());
}

int checked(const Registry& registry, const std::vector<std::string>& schemes, const CheckArguments& arguments) {
  std::vector<check::Checked> all;
  {
    ProgressBar bar("checking");
    for (const std::string& scheme : schemes)
      all.push_back(check::check(
          scheme, [&] { return registry.parse(scheme); },
          [&](std::size_t done, std::size_t total, std::string_view last) {
            bar.show((all.size() * total) + done, schemes.size() * total, fmt::format("{}: {}", scheme, last));
          }));
  }
  write_file(arguments.output, written(arguments, all));
  return std::ranges::all_of(all, &check::Checked::sound) ? success : ran_and_failed;
}

}  // namespace

int check_verb(const Registry& registry, const CheckArguments& arguments) {
  const std::vector<std::string> schemes = schemes_of(registry, arguments);
  const bool from_outside = std::ranges::any_of(schemes, [&](const std::string& scheme) {
    return !registry.parse(scheme)->info().plugin.empty();  // what is misspelt is said first
  });
  const auto check_all = [&] { return checked(registry, schemes, arguments); };
  return from_outside ? in_child(arguments.all ? "check" : arguments.scheme, check_all) : check_all();
}

}  // namespace kappabench
