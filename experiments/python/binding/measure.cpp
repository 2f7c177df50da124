// Metrics of one curve, and the table of `compare`.
#include <pybind11/stl.h>

#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "experiments/python/binding/bind.hpp"
#include "experiments/python/binding/compare.hpp"
#include "experiments/python/binding/fitted.hpp"
#include "experiments/python/binding/given.hpp"
#include "experiments/python/binding/tables.hpp"
#include "metrics/metric.hpp"

namespace kappabench::python {

namespace py = pybind11;

namespace {

/// The metrics of these ids; without any, all but those that fit again.
std::vector<const Metric*> metrics_of(const std::vector<std::string>& ids) {
  std::vector<const Metric*> metrics;
  for (const std::string& id : ids) metrics.push_back(&find_metric(id));
  if (metrics.empty())
    for (const Metric& metric : all_metrics())
      if (!metric.refits) metrics.push_back(&metric);
  return metrics;
}

/// Column, value, unit, method.
py::list measure(const Fitted& fitted, const std::vector<std::string>& ids) {
  static_cast<void>(curve_in(fitted));
  const std::vector<const Metric*> metrics = metrics_of(ids);
  for (const Metric* metric : metrics)
    if (metric->refits && is_given(*fitted.scheme))
      throw std::invalid_argument(metric->id + ": this metric fits again, and a curve that was read cannot be");
  std::vector<Measurement> all;
  {
    const py::gil_scoped_release others_may_run;
    for (const Metric* metric : metrics)
      for (Measurement& number : metric->measure(*fitted.scheme, fitted.fit)) all.push_back(std::move(number));
  }
  py::list list;
  for (const Measurement& number : all)
    list.append(py::make_tuple(number.column, number.value, number.unit, name(number.method)));
  return list;
}

void throw_if_interrupted() {
  const py::gil_scoped_acquire here;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

py::tuple compare_all(const std::vector<Drawing>& drawings, const std::vector<ChosenScheme>& chosen,
                      const std::vector<std::string>& metrics, int threads) {
  std::vector<SchemePtr> schemes;
  for (const ChosenScheme& one : chosen) schemes.push_back(one.scheme);
  store::TableRecord table;
  {
    const py::gil_scoped_release others_may_run;
    table = compare(drawings, schemes, metrics_of(metrics), threads, throw_if_interrupted);
  }
  return python_table(table);
}

}  // namespace

void bind_measure(py::module_& module) {
  module.def("measure", &measure, py::arg("fitted"), py::arg("metrics"));
  module.def("compare", &compare_all, py::arg("drawings"), py::arg("schemes"), py::arg("metrics"), py::arg("threads"));
}

}  // namespace kappabench::python
