#pragma once

#include <string>
#include <vector>

#include "schemes/api/input.hpp"

namespace kappabench {

/// A named set of curves to interpolate, with where it comes from.
struct Drawing {
  std::string id;  ///< "bird"; for a file its name without the ending
  std::string title{};
  std::string stands_in_for{};  ///< "Miura 2022, Fig. 6", or empty
  std::string source{};
  std::string licence{};
  std::string units{};
  std::vector<Input> curves{};
};

}  // namespace kappabench
