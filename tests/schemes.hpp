#pragma once

#include <string_view>

#include "schemes/api/registry.hpp"

namespace kappabench::test {

/// Every scheme of this build.
inline const Registry& all_schemes() {
  static const Registry registry = [] {
    Registry all;
    register_all(all);
    return all;
  }();
  return registry;
}

/// "ekappa:a=0.8".
inline SchemePtr scheme(std::string_view text) { return all_schemes().parse(text); }

}  // namespace kappabench::test
