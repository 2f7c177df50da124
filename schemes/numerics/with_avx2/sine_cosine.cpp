#include "schemes/numerics/batch_sine_cosine.hpp"

namespace kappabench {

void sine_cosine_avx2(std::span<const double> angle, std::span<double> sine, std::span<double> cosine) {
  batch_sine_cosine<xsimd::avx2>(angle, sine, cosine);
}

}  // namespace kappabench
