#include "experiments/run/plan.hpp"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace kappabench {

namespace {

/// Reports where a node of the file stands with every complaint.
class Reader {
 public:
  explicit Reader(std::string_view source_name) : source_name_(source_name) {}

  [[noreturn]] void refuse(const toml::source_region& where, std::string_view what) const {
    throw std::invalid_argument(fmt::format("{}:{}: {}", source_name_, where.begin.line, what));
  }

  template <std::size_t N>
  void only_keys(const toml::table& table, const std::array<std::string_view, N>& allowed) const {
    for (const auto& [key, node] : table)
      if (std::ranges::find(allowed, key.str()) == allowed.end())
        refuse(key.source(), fmt::format("unknown key '{}'; known are {}", key.str(), fmt::join(allowed, ", ")));
  }

  [[nodiscard]] std::vector<std::string> strings(const toml::table& table, std::string_view key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) return {};
    std::vector<std::string> result;
    if (const toml::array* array = node->as_array())
      for (const toml::node& item : *array) {
        const auto text = item.value<std::string>();
        if (!text) refuse(item.source(), fmt::format("'{}' must be a list of strings", key));
        result.push_back(*text);
      }
    else
      refuse(node->source(), fmt::format("'{}' must be a list of strings", key));
    return result;
  }

  [[nodiscard]] PlannedExperiment experiment(const toml::node& node) const {
    const toml::table* table = node.as_table();
    if (table == nullptr) refuse(node.source(), "an experiment is written as a table [[experiment]]");
    only_keys(*table, std::array<std::string_view, 4>{"id", "schemes", "datasets", "metrics"});
    const auto id = (*table)["id"].value<std::string>();
    if (!id) refuse(table->source(), "an experiment needs id = \"...\"; see 'kappabench list experiments'");
    return {*id, strings(*table, "schemes"), strings(*table, "datasets"), strings(*table, "metrics")};
  }

  [[nodiscard]] Plan plan(const toml::table& table) const {
    only_keys(table, std::array<std::string_view, 2>{"seed", "experiment"});
    Plan plan;
    if (const toml::node* seed = table.get("seed")) {
      if (!seed->is_integer() || *seed->value<std::int64_t>() < 0)
        refuse(seed->source(), "seed must be an integer from 0 up");
      plan.seed = static_cast<std::uint64_t>(*seed->value<std::int64_t>());
    }
    const toml::node* list = table.get("experiment");
    if (list == nullptr || !list->is_array_of_tables())
      refuse(table.source(), "a plan needs at least one [[experiment]] with an id");
    for (const toml::node& node : *list->as_array()) plan.experiments.push_back(experiment(node));
    return plan;
  }

 private:
  std::string_view source_name_;
};

std::string string_list(const std::vector<std::string>& items) {
  std::vector<std::string> quoted;
  for (const std::string& item : items) {
    std::ostringstream text;
    text << toml::value<std::string>(item);
    quoted.push_back(text.str());
  }
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

}  // namespace

Plan parse_plan(std::string_view text, std::string_view source_name) {
  try {
    return Reader(source_name).plan(toml::parse(text));
  } catch (const toml::parse_error& error) {
    throw std::invalid_argument(fmt::format("{}:{}: {}", source_name, error.source().begin.line, error.description()));
  }
}

Plan read_plan(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file))
    throw std::invalid_argument(fmt::format("{}: cannot be read; a plan is a TOML file", file.string()));
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parse_plan(text, file.string());
}

std::string to_toml(const Plan& plan) {
  std::string text = fmt::format("seed = {}\n", plan.seed);
  for (const PlannedExperiment& experiment : plan.experiments) {
    text += fmt::format("\n[[experiment]]\nid = \"{}\"\n", experiment.id);
    if (!experiment.schemes.empty()) text += fmt::format("schemes = {}\n", string_list(experiment.schemes));
    if (!experiment.datasets.empty()) text += fmt::format("datasets = {}\n", string_list(experiment.datasets));
    if (!experiment.metrics.empty()) text += fmt::format("metrics = {}\n", string_list(experiment.metrics));
  }
  return text;
}

}  // namespace kappabench
