#pragma once

// The one place that knows which major version of Catch2 is installed: tests are written for version 3's names.
#if __has_include(<catch2/catch_all.hpp>)

#include <catch2/catch_all.hpp>

using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

#else

#include <catch2/catch.hpp>
#include <string>

using Catch::Detail::Approx;
inline auto ContainsSubstring(const std::string& text) { return Catch::Contains(text); }

#endif
