// A results file as tables.
#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/python/binding/bind.hpp"
#include "experiments/python/binding/tables.hpp"
#include "experiments/study/table.hpp"
#include "reports/store/hdf5_store.hpp"

namespace kappabench::python {

namespace py = pybind11;
using store::ExperimentRecord;
using store::Results;

namespace {

const ExperimentRecord& experiment_in(const Results& results, const std::string& id) {
  const auto found = std::ranges::find(results.experiments, id, &ExperimentRecord::id);
  if (found != results.experiments.end()) return *found;
  std::vector<std::string_view> ids;
  for (const ExperimentRecord& experiment : results.experiments) ids.push_back(experiment.id);
  throw std::invalid_argument(fmt::format("unknown experiment '{}'; the file has {}", id, fmt::join(ids, ", ")));
}

/// id, title, about, tables by their ids.
py::tuple described(const Results& results, const std::string& id) {
  const ExperimentRecord& experiment = experiment_in(results, id);
  py::dict tables;
  for (const store::TableRecord& table : experiment.tables) tables[py::str(table.id)] = python_table(table);
  return py::make_tuple(experiment.id, experiment.title, experiment.about, tables);
}

py::tuple cells(const Results& results, const std::string& id) {
  study::Table table("cells", "Cells", "One row a drawing and scheme.");
  table.words("dataset").words("scheme").words("parameters").words("label").words("outcome").words("message");
  table.counts("curves").words("key");
  for (const store::CellRecord& cell : experiment_in(results, id).cells)
    table.row({cell.dataset, cell.scheme, cell.parameters, cell.label, cell.outcome, cell.message, cell.curves.size(),
               cell.key});
  return python_table(table.record());
}

py::tuple claims(const Results& results, const std::string& id) {
  study::Table table("claims", "Claims", "One row a claim of the paper.");
  table.words("paper").words("claim").words("verdict").words("ours").words("evidence").words("method");
  table.words("kind").words("sample").words("interval").words("rule");
  for (const store::ClaimRecord& claim : experiment_in(results, id).claims)
    table.row({claim.paper, claim.claim, claim.verdict, claim.ours, claim.evidence, claim.method, claim.kind,
               claim.sample, claim.interval, claim.rule});
  return python_table(table.record());
}

/// The curve JSON of a curve of a cell; empty for a fit without one.
std::string curve_text(const Results& results, const std::string& id, std::size_t cell, std::size_t curve) {
  const auto& all = experiment_in(results, id).cells;
  if (cell >= all.size()) throw std::invalid_argument(fmt::format("no cell {}; there are {}", cell, all.size()));
  const auto& curves = all[cell].curves;
  if (curve >= curves.size())
    throw std::invalid_argument(fmt::format("no curve {} in cell {}; there are {}", curve, cell, curves.size()));
  return curves[curve].exact_json;
}

std::vector<std::string> ids_of(const Results& results) {
  std::vector<std::string> ids;
  for (const ExperimentRecord& experiment : results.experiments) ids.push_back(experiment.id);
  return ids;
}

}  // namespace

void bind_results(py::module_& module) {
  py::class_<Results>(module, "Results")
      .def_readonly("provenance", &Results::provenance)
      .def_property_readonly("experiments", &ids_of)
      .def("describe", &described)
      .def("cells", &cells)
      .def("claims", &claims)
      .def("curve_json", &curve_text);
  module.def("read_results", &store::read_results, py::arg("file"), py::call_guard<py::gil_scoped_release>());
}

}  // namespace kappabench::python
