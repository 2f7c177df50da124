#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <xsimd/xsimd.hpp>

namespace kappabench {

/// For the instruction set `Arch` of xsimd: compiled once for each, in a file with that set's compiler options.
template <class Arch>
void batch_sine_cosine(std::span<const double> angle, std::span<double> sine, std::span<double> cosine) {
  using Batch = xsimd::batch<double, Arch>;
  std::size_t i = 0;
  for (; i + Batch::size <= angle.size(); i += Batch::size) {
    const auto [s, c] = xsimd::sincos(Batch::load_unaligned(angle.data() + i));
    s.store_unaligned(sine.data() + i);
    c.store_unaligned(cosine.data() + i);
  }
  for (; i < angle.size(); ++i) {
    sine[i] = std::sin(angle[i]);
    cosine[i] = std::cos(angle[i]);
  }
}

}  // namespace kappabench
