#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "datasets/datasets.hpp"
#include "experiments/program/verbs.hpp"
#include "experiments/run/experiment.hpp"
#include "metrics/metric.hpp"

namespace kappabench {

namespace {

using nlohmann::ordered_json;

ordered_json value_json(const ParameterValue& value) {
  return std::visit([](const auto& v) { return ordered_json(v); }, value);
}

ordered_json schemes_json(const Registry& registry) {
  ordered_json list = ordered_json::array();
  for (const SchemeInfo& info : registry.list()) {
    ordered_json parameters = ordered_json::array();
    for (const ParameterSpec& spec : info.parameters)
      parameters.push_back({{"name", spec.name},
                            {"default", value_json(spec.default_value)},
                            {"range", range_text(spec)},
                            {"help", spec.help}});
    ordered_json marks = ordered_json::array();
    for (const MarkSpec& mark : info.marks) marks.push_back({{"name", mark.name}, {"help", mark.help}});
    const SchemeTraits& traits = info.traits;
    list.push_back({{"id", info.id},
                    {"title", info.title},
                    {"citation", info.citation},
                    {"version", info.version},
                    {"open", traits.open},
                    {"closed", traits.closed},
                    {"fewest_open_points", traits.fewest_open_points},
                    {"fewest_closed_points", traits.fewest_closed_points},
                    {"continuity", name(traits.continuity)},
                    {"continuity_exceptions", traits.continuity_exceptions},
                    {"locality", traits.locality},
                    {"hermite", traits.hermite},
                    {"parameters", parameters},
                    {"marks", marks},
                    {"libraries", info.libraries},
                    {"plugin", info.plugin}});
  }
  return list;
}

ordered_json datasets_json() {
  ordered_json list = ordered_json::array();
  for (const Drawing& drawing : builtin_drawings()) {
    std::size_t points = 0;
    for (const Input& input : drawing.curves) points += input.points.size();
    list.push_back({{"id", drawing.id},
                    {"title", drawing.title},
                    {"stands_in_for", drawing.stands_in_for},
                    {"source", drawing.source},
                    {"licence", drawing.licence},
                    {"units", drawing.units},
                    {"curves", drawing.curves.size()},
                    {"points", points}});
  }
  return list;
}

ordered_json metrics_json() {
  ordered_json list = ordered_json::array();
  for (const Metric& metric : all_metrics()) {
    ordered_json columns = ordered_json::array();
    for (const Column& column : metric.columns)
      columns.push_back({{"name", column.name}, {"unit", column.unit}, {"help", column.help}});
    list.push_back({{"id", metric.id}, {"title", metric.title}, {"version", metric.version}, {"columns", columns}});
  }
  return list;
}

ordered_json experiments_json() {
  ordered_json list = ordered_json::array();
  for (const Experiment& experiment : all_experiments())
    list.push_back({{"id", experiment.id}, {"title", experiment.title}, {"about", experiment.about}});
  return list;
}

ordered_json things(const Registry& registry, std::string_view what) {
  if (what == "schemes") return schemes_json(registry);
  if (what == "datasets") return datasets_json();
  return what == "metrics" ? metrics_json() : experiments_json();
}

void print_text(std::string_view what, const ordered_json& list) {
  for (const ordered_json& item : list) {
    fmt::print("{:<24} {}", item["id"].get<std::string>(), item["title"].get<std::string>());
    if (what == "schemes" && item["plugin"] != "") fmt::print(" (from {})", item["plugin"].get<std::string>());
    if (what == "datasets") {
      const int curves = item["curves"].get<int>();
      fmt::print(" ({} curve{}, {} points)", curves, curves == 1 ? "" : "s", item["points"].get<int>());
    }
    fmt::print("\n");
    if (what == "schemes")
      for (const ordered_json& parameter : item["parameters"])
        fmt::print("  {:<22} {} (default {}): {}\n", parameter["name"].get<std::string>(),
                   parameter["range"].get<std::string>(), parameter["default"].dump(),
                   parameter["help"].get<std::string>());
    if (what == "metrics")
      for (const ordered_json& column : item["columns"])
        fmt::print("  {:<40} [{}] {}\n", column["name"].get<std::string>(), column["unit"].get<std::string>(),
                   column["help"].get<std::string>());
  }
}

}  // namespace

int list(const Registry& registry, const ListArguments& arguments) {
  const ordered_json list = things(registry, arguments.what);
  if (arguments.json)
    fmt::print("{}\n", list.dump(2));
  else
    print_text(arguments.what, list);
  if (!arguments.json && arguments.what == "schemes")
    for (const PluginFailure& failure : arguments.failed_plugins) fmt::print("not loaded: {}\n", failure.why);
  return 0;
}

}  // namespace kappabench
