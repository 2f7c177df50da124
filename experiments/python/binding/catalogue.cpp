// What there is: schemes and metrics, said as the program's `list ... --json` says it.
#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/python/binding/bind.hpp"
#include "experiments/python/binding/fitted.hpp"
#include "experiments/run/cell.hpp"
#include "metrics/metric.hpp"
#include "schemes/api/registry.hpp"
#include "schemes/plugin/plugins.hpp"

namespace kappabench::python {

namespace py = pybind11;

namespace {

py::object python_of(const ParameterValue& value) {
  return std::visit([](const auto& held) -> py::object { return py::cast(held); }, value);
}

py::dict python_of(const SchemeInfo& info) {
  py::list parameters, marks;
  for (const ParameterSpec& spec : info.parameters)
    parameters.append(py::dict(py::arg("name") = spec.name, py::arg("default") = python_of(spec.default_value),
                               py::arg("range") = range_text(spec), py::arg("help") = spec.help));
  for (const MarkSpec& mark : info.marks)
    marks.append(py::dict(py::arg("name") = mark.name, py::arg("help") = mark.help));
  const SchemeTraits& traits = info.traits;
  return py::dict(
      py::arg("id") = info.id, py::arg("title") = info.title, py::arg("citation") = info.citation,
      py::arg("version") = info.version, py::arg("open") = traits.open, py::arg("closed") = traits.closed,
      py::arg("fewest_open_points") = traits.fewest_open_points,
      py::arg("fewest_closed_points") = traits.fewest_closed_points, py::arg("continuity") = name(traits.continuity),
      py::arg("continuity_exceptions") = traits.continuity_exceptions, py::arg("locality") = traits.locality,
      py::arg("hermite") = traits.hermite, py::arg("parameters") = parameters, py::arg("marks") = marks,
      py::arg("libraries") = info.libraries, py::arg("plugin") = info.plugin);
}

py::dict python_of(const Metric& metric) {
  py::list columns;
  for (const Column& column : metric.columns)
    columns.append(
        py::dict(py::arg("name") = column.name, py::arg("unit") = column.unit, py::arg("help") = column.help));
  return py::dict(py::arg("id") = metric.id, py::arg("title") = metric.title, py::arg("version") = metric.version,
                  py::arg("columns") = columns);
}

template <class Items>
py::list python_list(const Items& items) {
  py::list list;
  for (const auto& item : items) list.append(python_of(item));
  return list;
}

/// A whole number is a number, too, where the scheme wants one.
ParameterValue converted(ParameterValue value, const SchemeInfo& info, const std::string& name) {
  const auto spec = std::ranges::find(info.parameters, name, &ParameterSpec::name);
  const auto* whole = std::get_if<long>(&value);
  if (spec != info.parameters.end() && whole != nullptr && std::holds_alternative<double>(spec->default_value))
    return static_cast<double>(*whole);
  return value;
}

ChosenScheme create(const Registry& registry, const std::string& id, std::map<std::string, ParameterValue> parameters) {
  const std::vector<SchemeInfo> infos = registry.list();
  const auto info = std::ranges::find(infos, id, &SchemeInfo::id);
  if (info == infos.end()) return {registry.create(id)};  // which says what is known
  for (auto& [name, value] : parameters) value = converted(std::move(value), *info, name);
  try {
    return {registry.create(id, parameters)};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("scheme '{}': {}", id, error.what()));
  }
}

void load_plugin(Registry& registry, const std::filesystem::path& file) {
  for (const PluginFailure& failure : load_plugins(std::array{file}, registry))
    throw std::invalid_argument(failure.why);
}

}  // namespace

void bind_catalogue(py::module_& module) {
  py::class_<ChosenScheme>(module, "Scheme")
      .def_property_readonly("id", [](const ChosenScheme& chosen) { return chosen.scheme->info().id; })
      .def_property_readonly("label", [](const ChosenScheme& chosen) { return label_of(*chosen.scheme); })
      .def_property_readonly("parameters", [](const ChosenScheme& chosen) {
        py::dict values;
        for (const auto& [name, value] : chosen.scheme->parameters().values()) values[py::str(name)] = python_of(value);
        return values;
      });
  py::class_<Registry>(module, "Registry")
      .def(py::init([] {
        Registry registry;
        register_all(registry);
        return registry;
      }))
      .def("create", &create, py::arg("id"), py::arg("parameters").noconvert())
      .def("parse",
           [](const Registry& registry, const std::string& text) { return ChosenScheme{registry.parse(text)}; })
      .def("list", [](const Registry& registry) { return python_list(registry.list()); })
      .def("load_plugin", &load_plugin);
  module.def("metrics", [] { return python_list(all_metrics()); });
}

}  // namespace kappabench::python
