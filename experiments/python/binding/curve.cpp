// Fitting, and what a fit is asked: points of its curve, lengths, report, JSON and SVG.
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "experiments/program/curve_formats.hpp"
#include "experiments/python/binding/arrays.hpp"
#include "experiments/python/binding/bind.hpp"
#include "experiments/python/binding/evaluate.hpp"
#include "experiments/python/binding/fitted.hpp"
#include "experiments/python/binding/given.hpp"
#include "experiments/run/cell.hpp"
#include "metrics/arc_map.hpp"

namespace kappabench::python {

namespace {

Fitted fit(const ChosenScheme& chosen, const Input& input) { return {chosen.scheme, chosen.scheme->fit(input)}; }

/// The derivative of order `nu` with respect to the parameter, two numbers an element of t.
py::array_t<double> derivative(const Fitted& fitted, const Numbers& t, int nu) {
  const Curve& curve = curve_in(fitted);
  py::array_t<double> array = array_like(t, 2);
  double* const out = array.mutable_data();
  const py::gil_scoped_release others_may_run;
  for_each_jet(curve, values_of(t), nu, [out, k = static_cast<std::size_t>(nu)](std::size_t i, const Jet& jet) {
    out[2 * i] = jet.d[k].x();
    out[2 * i + 1] = jet.d[k].y();
  });
  return array;
}

/// Curvature, or its derivative of order `nu` with respect to arc length.
py::array_t<double> curvature_at(const Fitted& fitted, const Numbers& t, int nu) {
  using Measure = double (*)(const Jet&);
  constexpr std::array<Measure, 3> measures{curvature, curvature_derivative, curvature_second_derivative};
  const Curve& curve = curve_in(fitted);
  py::array_t<double> array = array_like(t);
  double* const out = array.mutable_data();
  const py::gil_scoped_release others_may_run;
  for_each_jet(curve, values_of(t), nu + 2,
               [out, measure = measures.at(static_cast<std::size_t>(nu))](std::size_t i, const Jet& jet) {
                 out[i] = measure(jet);
               });
  return array;
}

ArcMap arc_map_of(const Fitted& fitted) { return ArcMap(curve_in(fitted)); }

/// Arc length from the start of the curve to parameter t; of a closed curve that was gone around k times, k lengths
/// more.
double length_to(const ArcMap& arcs, const Curve& curve, double t) {
  if (std::isnan(t)) return t;
  const Spot spot = spot_at(curve, t);
  const double rounds = curve.closed() ? std::floor(t / curve.size()) : 0.0;
  return rounds * arcs.length() + arcs.position({spot.segment, spot.t});
}

double parameter_at(const ArcMap& arcs, const Curve& curve, double s) {
  if (std::isnan(s)) return s;
  const double rounds = curve.closed() ? std::floor(s / arcs.length()) : 0.0;
  const auto place = arcs.place(s);
  return rounds * curve.size() + place.segment + place.t;
}

template <double (*Map)(const ArcMap&, const Curve&, double)>
py::array_t<double> mapped(const ArcMap& arcs, const Fitted& fitted, const Numbers& given) {
  const Curve& curve = curve_in(fitted);
  py::array_t<double> array = array_like(given);
  double* const out = array.mutable_data();
  const std::span<const double> values = values_of(given);
  const py::gil_scoped_release others_may_run;
  std::transform(values.begin(), values.end(), out, [&](double value) { return Map(arcs, curve, value); });
  return array;
}

/// Point, parameter of the whole curve, segment, marks.
py::list nodes_of(const Fitted& fitted) {
  py::list list;
  for (const Node& node : curve_in(fitted).nodes())
    list.append(py::make_tuple(node.point, node.segment + node.t, node.segment, node.marks));
  return list;
}

/// Parameter of the whole curve, segment that ends there, claim.
py::list joints_of(const Fitted& fitted) {
  py::list list;
  for (const Joint& joint : curve_in(fitted).joints())
    list.append(py::make_tuple(joint.segment + 1.0, joint.segment, name(joint.claimed)));
  return list;
}

std::string text_of(const Fitted& fitted, const std::string& format) {
  return format_fits(format, *fitted.scheme, {fitted.fit});
}

void bind_report(py::module_& module) {
  py::class_<Report>(module, "Report")
      .def_property_readonly("outcome", [](const Report& report) { return name(report.outcome); })
      .def_readonly("message", &Report::message)
      .def_readonly("warnings", &Report::warnings)
      .def_readonly("iterations", &Report::iterations)
      .def_readonly("residual", &Report::residual)
      .def_readonly("seconds", &Report::seconds)
      .def_readonly("trace", &Report::trace)
      .def_readonly("counters", &Report::counters);
}

}  // namespace

void bind_curve(py::module_& module) {
  bind_report(module);
  py::class_<ArcMap>(module, "ArcMap")
      .def(py::init(&arc_map_of), py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("length", &ArcMap::length)
      .def("lengths", &mapped<length_to>)
      .def("parameters", &mapped<parameter_at>);
  py::class_<Fitted>(module, "Fitted")
      .def_property_readonly("has_curve", [](const Fitted& fitted) { return fitted.fit.curve.has_value(); })
      .def_property_readonly("closed", [](const Fitted& fitted) { return fitted.fit.input.closed; })
      .def_property_readonly("size", [](const Fitted& fitted) { return curve_in(fitted).size(); })
      .def_property_readonly("input", [](const Fitted& fitted) { return fitted.fit.input; })
      .def_property_readonly("report", [](const Fitted& fitted) { return fitted.fit.report; })
      .def_property_readonly("scheme", [](const Fitted& fitted) { return ChosenScheme{fitted.scheme}; })
      .def_property_readonly("nodes", &nodes_of)
      .def_property_readonly("joints", &joints_of)
      .def("derivative", &derivative, py::arg("t"), py::arg("nu"))
      .def("curvature", &curvature_at, py::arg("t"), py::arg("nu"))
      .def("text", &text_of, py::arg("format"), py::call_guard<py::gil_scoped_release>());
  module.def("fit", &fit, py::arg("scheme"), py::arg("input"), py::call_guard<py::gil_scoped_release>());
  module.def("given_curves", &given_curves, py::arg("json"), py::arg("source"), py::arg("registry"), py::arg("points"));
}

}  // namespace kappabench::python
