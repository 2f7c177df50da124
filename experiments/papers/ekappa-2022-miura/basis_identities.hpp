#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace kappabench::miura {

/// A statement of Miura 2022 about a basis, as a deviation that is zero when it holds.
struct Identity {
  std::string name;
  std::string place;
  std::function<double()> largest_deviation;  ///< over grids and seeded random control points; deterministic
};

namespace names {
inline constexpr std::string_view square = "v^2 = 2uw";
inline constexpr std::string_view unity = "u^2 + 2uv + 4uw + 2vw + w^2 = 1";
inline constexpr std::string_view negative = "u^2, 2uv, 4uw, 2vw, w^2 are not negative";
inline constexpr std::string_view built_in = "Eq. (17) is Eq. (29) with alpha = 2a";
inline constexpr std::string_view alternative = "C.2 with alpha = 3a is Eq. (1)";
inline constexpr std::string_view recursion = "the recursion (42) evaluates the basis";
inline constexpr std::string_view circle = "a = 1/2 over equal perpendicular legs is a circular arc";
inline constexpr std::string_view parameter_printed = "Eq. (25) as printed gives the stationary parameter";
inline constexpr std::string_view parameter_corrected = "Eq. (25) with the root of beta^2 + 1";
inline constexpr std::string_view ratio_printed = "Eq. (27) as printed makes (26) equal";
inline constexpr std::string_view ratio_corrected = "Eq. (27) with the two areas exchanged";
}  // namespace names

[[nodiscard]] const std::vector<Identity>& basis_identities();

/// Eq. (43): coefficients of the trigonometric basis of degrees 1 to `most`, from the powers of u + v + w.
[[nodiscard]] std::vector<std::vector<double>> blending_triangle(int most);

}  // namespace kappabench::miura
