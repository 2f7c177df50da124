#pragma once

#include <span>
#include <string>

namespace kappabench {

/// Who computes sines and cosines: the C library one by one, or xsimd as many at a time as the processor's vectors hold
/// (found out when the program runs). Both are good to the last digit or two; they need not agree in it.
enum class Sines { library, vectorised };

/// The spans have equal length.
void sine_cosine(Sines sines, std::span<const double> angle, std::span<double> sine, std::span<double> cosine);

[[nodiscard]] std::string xsimd_version();

}  // namespace kappabench
