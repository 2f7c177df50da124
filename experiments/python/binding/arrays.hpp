#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <span>
#include <vector>

namespace kappabench::python {

namespace py = pybind11;

/// Any array of numbers, as doubles in C order.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

[[nodiscard]] inline std::span<const double> values_of(const Numbers& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// A new array of the shape of `like`, of `components` numbers an element; of one, if that is 0.
[[nodiscard]] inline py::array_t<double> array_like(const Numbers& like, py::ssize_t components = 0) {
  std::vector<py::ssize_t> shape(like.shape(), like.shape() + like.ndim());
  if (components > 0) shape.push_back(components);
  return py::array_t<double>(shape);
}

}  // namespace kappabench::python
