#pragma once

#include <memory>
#include <string>
#include <vector>

#include "datasets/curves/given_curves.hpp"
#include "schemes/api/registry.hpp"

namespace kappabench {

/// The curves of each file as a scheme whose id is the file's name, "mine.svg"; where that is taken, "mine.svg-2", and
/// without what parts a scheme's id from its parameters. Throws as read_curve_file.
[[nodiscard]] std::vector<std::shared_ptr<const GivenCurves>> open_curves(const std::vector<std::string>& files,
                                                                          const Registry& taken);

}  // namespace kappabench
