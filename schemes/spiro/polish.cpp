#include "schemes/spiro/polish.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "schemes/segments/clothoid.hpp"

namespace kappabench {

namespace {

/// A number and its derivatives by k0 and k1.
struct Derived {
  double value, by_k0, by_k1;
};

/// Headings, against the x axis, and curvatures of a bend over its chord.
struct Ends {
  Derived start_heading, end_heading, start_curvature, end_curvature;
};

Ends ends_of(const SpiroBend& bend, const Vec2& chord) {
  const double k0 = bend.k0, k1 = bend.k1;
  // The way from end to end for unit length, and its derivatives: integrals of (1, i s, i s^2 / 2) exp(i (k0 s + k1 s^2
  // / 2)), s = u - 1/2.
  const auto m = clothoid_moments(-0.5 * k0 + 0.125 * k1, k0 - 0.5 * k1, k1);
  const std::complex<double> i(0.0, 1.0), end = m[0], end_k0 = i * (m[1] - 0.5 * m[0]),
                                          end_k1 = 0.5 * i * (m[2] - m[1] + 0.25 * m[0]);
  const double size = std::abs(end), squared = size * size;
  const Derived direction{std::arg(end), std::imag(std::conj(end) * end_k0) / squared,
                          std::imag(std::conj(end) * end_k1) / squared};
  const Derived per_length{size / chord.norm(), std::real(std::conj(end) * end_k0) / size / chord.norm(),
                           std::real(std::conj(end) * end_k1) / size / chord.norm()};
  const double chord_angle = std::atan2(chord.y(), chord.x());
  const auto heading = [&](double side) {  // of s = side / 2
    return Derived{chord_angle - direction.value + 0.5 * side * k0 + 0.125 * k1, 0.5 * side - direction.by_k0,
                   0.125 - direction.by_k1};
  };
  const auto curvature = [&](double side) {
    const double k = k0 + 0.5 * side * k1;
    return Derived{k * per_length.value, per_length.value + k * per_length.by_k0,
                   0.5 * side * per_length.value + k * per_length.by_k1};
  };
  return {heading(-1.0), heading(1.0), curvature(-1.0), curvature(1.0)};
}

/// Jumps of heading, and of curvature times the shorter chord, at every joint, and their derivatives by all bends.
struct Jumps {
  Eigen::VectorXd values;
  Eigen::SparseMatrix<double> derivatives;
};

Jumps jumps_of(std::span<const SpiroBend> bends, std::span<const Vec2> chords, bool closed) {
  const std::size_t n = bends.size(), joints = closed ? n : n - 1;
  std::vector<Ends> ends;
  for (std::size_t i = 0; i < n; ++i) ends.push_back(ends_of(bends[i], chords[i]));
  Jumps jumps{Eigen::VectorXd(static_cast<Eigen::Index>(2 * joints)),
              Eigen::SparseMatrix<double>(static_cast<Eigen::Index>(2 * joints), static_cast<Eigen::Index>(2 * n))};
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](std::size_t row, std::size_t bend, const Derived& number, double factor) {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(2 * bend), factor * number.by_k0);
    const bool arc = !closed && (bend == 0 || bend + 1 == n);
    if (!arc) entries.emplace_back(static_cast<int>(row), static_cast<int>(2 * bend + 1), factor * number.by_k1);
  };
  for (std::size_t i = 0; i < joints; ++i) {
    const std::size_t next = (i + 1) % n;
    const double shorter = std::min(chords[i].norm(), chords[next].norm());
    const Derived &h0 = ends[i].end_heading, &h1 = ends[next].start_heading;
    const Derived &k0 = ends[i].end_curvature, &k1 = ends[next].start_curvature;
    jumps.values[static_cast<Eigen::Index>(2 * i)] = std::remainder(h0.value - h1.value, 2.0 * std::numbers::pi);
    jumps.values[static_cast<Eigen::Index>(2 * i + 1)] = shorter * (k0.value - k1.value);
    add(2 * i, i, h0, 1.0), add(2 * i, next, h1, -1.0);
    add(2 * i + 1, i, k0, shorter), add(2 * i + 1, next, k1, -shorter);
  }
  jumps.derivatives.setFromTriplets(entries.begin(), entries.end());
  return jumps;
}

}  // namespace

void polish(std::span<SpiroBend> bends, std::span<const Vec2> chords, bool closed) {
  constexpr int most_steps = 4;  // Newton's method from 1e-7: two would do
  if (bends.size() < 2) return;
  Jumps jumps = jumps_of(bends, chords, closed);
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> normal(jumps.derivatives * jumps.derivatives.transpose());
    if (normal.info() != Eigen::Success) return;
    const Eigen::VectorXd change = jumps.derivatives.transpose() * normal.solve(jumps.values);
    std::vector<SpiroBend> next(bends.begin(), bends.end());
    for (std::size_t i = 0; i < next.size(); ++i) {
      next[i].k0 -= change[static_cast<Eigen::Index>(2 * i)];
      next[i].k1 -= change[static_cast<Eigen::Index>(2 * i + 1)];
    }
    Jumps after = jumps_of(next, chords, closed);
    if (!(after.values.lpNorm<Eigen::Infinity>() < jumps.values.lpNorm<Eigen::Infinity>())) return;
    std::ranges::copy(next, bends.begin());
    jumps = std::move(after);
  }
}

}  // namespace kappabench
