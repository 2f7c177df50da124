#include "schemes/numerics/sine_cosine.hpp"

#include <fmt/format.h>

#include "schemes/numerics/batch_sine_cosine.hpp"

namespace kappabench {

#ifdef KAPPABENCH_WITH_AVX2
void sine_cosine_avx2(std::span<const double> angle, std::span<double> sine, std::span<double> cosine);
#endif

void sine_cosine(Sines sines, std::span<const double> angle, std::span<double> sine, std::span<double> cosine) {
  if (sines == Sines::library) {
    for (std::size_t i = 0; i < angle.size(); ++i) {
      sine[i] = std::sin(angle[i]);
      cosine[i] = std::cos(angle[i]);
    }
    return;
  }
#ifdef KAPPABENCH_WITH_AVX2
  if (__builtin_cpu_supports("avx2")) return sine_cosine_avx2(angle, sine, cosine);
#endif
  batch_sine_cosine<xsimd::default_arch>(angle, sine, cosine);
}

std::string xsimd_version() {
  return fmt::format("{}.{}.{}", XSIMD_VERSION_MAJOR, XSIMD_VERSION_MINOR, XSIMD_VERSION_PATCH);
}

}  // namespace kappabench
