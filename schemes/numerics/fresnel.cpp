#include "schemes/numerics/fresnel.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace kappabench {

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr int nodes = 12;
constexpr double reach = 6.266570686577501;  // A_N = sqrt((N + 1/2) pi)
constexpr Complex eighth(1.0 / std::numbers::sqrt2, 1.0 / std::numbers::sqrt2);

struct Node {
  double square;  // t_k^2
  double weight;  // exp(-t_k^2)
};

std::array<Node, nodes> make_nodes() {
  std::array<Node, nodes> result{};
  for (int k = 0; k < nodes; ++k) {
    const double t = (k + 0.5) * pi / reach;
    result[static_cast<std::size_t>(k)] = {t * t, std::exp(-t * t)};
  }
  return result;
}

}  // namespace

Complex fresnel_tail(double x) {
  static const std::array<Node, nodes> rule = make_nodes();
  const double xx = x * x;
  double real = 0.0, imaginary = 0.0;
  for (const Node& node : rule) {  // weight / (x^2 + i t_k^2)
    const double ratio = node.square / xx;
    const double part = node.weight / (1.0 + ratio * ratio);
    real += part;
    imaginary -= part * ratio;
  }
  // The common factor x / x^2 is 1 / x; at x = 0 only the residue is left.
  const Complex sum = x > 0.0 ? eighth * Complex(real, imaginary) / (reach * x) : 0.0;
  const double decay = std::numbers::sqrt2 * reach * x;
  if (decay > 80.0) return sum;
  return sum + std::polar(1.0, -xx) / (std::polar(std::exp(decay), -decay) + 1.0);
}

Complex fresnel(double z) {
  const double x = std::sqrt(pi / 2.0) * std::abs(z);
  // exp(i pi z^2 / 2) with z^2 exact to twice the digits, and reduced by the period.
  const double square = z * z, rest = std::fma(z, z, -square);
  const Complex turn = std::polar(1.0, 0.5 * pi * (std::fmod(square, 4.0) + rest));
  // The integral from 0 to infinity is (1 + i) / 2.
  const Complex integral = Complex(0.5, 0.5) * (1.0 - 2.0 * turn * fresnel_tail(x));
  return z < 0.0 ? -integral : integral;
}

}  // namespace kappabench
