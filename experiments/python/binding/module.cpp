// The module kappabench._core.
#include <pybind11/pybind11.h>

#include <exception>

#include "datasets/datasets.hpp"
#include "experiments/python/binding/bind.hpp"
#include "reports/store/hdf5_store.hpp"

namespace py = pybind11;

PYBIND11_MODULE(_core, module) {
  // Bad input is a ValueError with our one line; std::invalid_argument is one already.
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const kappabench::DataError& refused) {
      PyErr_SetString(PyExc_ValueError, refused.what());
    } catch (const kappabench::store::StoreError& refused) {
      PyErr_SetString(PyExc_ValueError, refused.what());
    }
  });
  kappabench::python::bind_input(module);
  kappabench::python::bind_catalogue(module);
  kappabench::python::bind_curve(module);
  kappabench::python::bind_measure(module);
  kappabench::python::bind_results(module);
  kappabench::python::bind_baseline(module);
}
