#pragma once

#include <pybind11/pybind11.h>

namespace kappabench::python {

// What the module _core has, by idea; each in the file of its name. The package kappabench around it is what users see:
// its docstrings say what these are.

void bind_input(pybind11::module_& module);
void bind_catalogue(pybind11::module_& module);
void bind_curve(pybind11::module_& module);
void bind_measure(pybind11::module_& module);
void bind_results(pybind11::module_& module);
void bind_baseline(pybind11::module_& module);

}  // namespace kappabench::python
