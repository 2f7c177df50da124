#pragma once

#include <pybind11/pybind11.h>

#include "reports/store/model.hpp"

namespace kappabench::python {

/// (title, caption, {name: column}, {name: unit}): numbers are arrays, words lists of str. The package makes a Table of
/// it.
[[nodiscard]] pybind11::tuple python_table(const store::TableRecord& table);

}  // namespace kappabench::python
