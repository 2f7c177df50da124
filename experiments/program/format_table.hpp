#pragma once

#include <string>
#include <string_view>

#include "reports/store/model.hpp"

namespace kappabench {

/// A table as verbs print it: `format` is table, csv, json (an array with one object a row) or latex.
[[nodiscard]] std::string format_table(const store::TableRecord& table, std::string_view format);

}  // namespace kappabench
