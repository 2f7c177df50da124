#pragma once

#include <string_view>

namespace kappabench {

/// The table with one row for every curve and scheme, which the verb `compare` prints.
inline constexpr std::string_view compare_table_id = "compare";

}  // namespace kappabench
