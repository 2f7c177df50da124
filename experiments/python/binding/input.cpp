// Points: from arrays, ids and files.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "datasets/datasets.hpp"
#include "datasets/fields.hpp"
#include "experiments/python/binding/arrays.hpp"
#include "experiments/python/binding/bind.hpp"

namespace kappabench::python {

namespace {

/// What is said of one point, key and value as in files of points.
using Said = std::map<std::string, std::string>;

Input input_of(const Numbers& points, bool closed, const std::vector<Said>& options) {
  if (points.ndim() != 2 || points.shape(1) != 2)
    throw std::invalid_argument("points are an array of shape (n, 2), a row each");
  Input input{.points = {}, .closed = closed};
  const auto rows = points.unchecked<2>();
  input.points.reserve(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) input.points.emplace_back(rows(i, 0), rows(i, 1));
  if (options.empty()) return input;
  if (options.size() != input.points.size())
    throw std::invalid_argument(
        fmt::format("{} options for {} points; give one for each, or a dict from index to options", options.size(),
                    input.points.size()));
  input.options.resize(options.size());
  for (std::size_t i = 0; i < options.size(); ++i)
    for (const auto& [key, value] : options[i])
      set_option(input.options[i], key, value, {fmt::format("point {}", i), 0});
  drop_unsaid_options(input);
  return input;
}

py::array_t<double> points_of(const Input& input) {
  py::array_t<double> array({static_cast<py::ssize_t>(input.size()), py::ssize_t{2}});
  auto rows = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    for (py::ssize_t k = 0; k < 2; ++k) rows(i, k) = input.points[static_cast<std::size_t>(i)][k];
  return array;
}

/// One dict a point, in the units of files; none if nobody said anything.
py::list options_of(const Input& input) {
  py::list list;
  for (const PointOptions& options : input.options) {
    py::dict said;
    if (options.type) said["type"] = name(*options.type);
    for (const PointNumber& number : point_numbers)
      if (const auto& value = options.*number.member)
        said[py::str(std::string(number.name))] = *value / number.file_unit;
    list.append(std::move(said));
  }
  return list;
}

}  // namespace

void bind_input(py::module_& module) {
  py::class_<Input>(module, "Input")
      .def(py::init(&input_of), py::arg("points"), py::arg("closed"), py::arg("options"))
      .def_readonly("closed", &Input::closed)
      .def_property_readonly("points", &points_of)
      .def_property_readonly("options", &options_of)
      .def("__len__", &Input::size);
  py::class_<Drawing>(module, "Drawing")
      .def(py::init([](std::string id, std::vector<Input> curves) {
             return Drawing{.id = std::move(id), .curves = std::move(curves)};
           }),
           py::arg("id"), py::arg("curves"))
      .def_readonly("id", &Drawing::id)
      .def_readonly("title", &Drawing::title)
      .def_readonly("stands_in_for", &Drawing::stands_in_for)
      .def_readonly("source", &Drawing::source)
      .def_readonly("licence", &Drawing::licence)
      .def_readonly("units", &Drawing::units)
      .def_readonly("curves", &Drawing::curves);
  module.def("open_drawings", &open_drawings, py::arg("name"), py::call_guard<py::gil_scoped_release>());
  module.def("builtin_drawings", &builtin_drawings, py::call_guard<py::gil_scoped_release>());
}

}  // namespace kappabench::python
