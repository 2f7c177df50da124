#pragma once

#include <optional>
#include <span>
#include <vector>

#include "schemes/api/scheme.hpp"

namespace kappabench {

inline constexpr int no_point = -1;

/// A stretch of a curve from one node to the next, sampled at equal steps of arc length, both ends included.
struct Span {
  int from;  ///< points of the two nodes; `no_point` for an end of an open curve that is no node
  int to;
  std::vector<Vec2> samples;
};

inline constexpr int samples_per_span = 17;

/// The stretches between consecutive nodes, in the curve's order; on a closed curve also from the last node to the
/// first, on an open one also from its start and to its end if those are no nodes. Nodes of point `left_out` are passed
/// over.
[[nodiscard]] std::vector<Span> spans(const Curve& curve, std::optional<int> left_out = std::nullopt);

/// Of the polygon through its samples.
[[nodiscard]] double length_of(const Span& span);

/// For every point of the fit, which has a curve, the length of the span from it to the next one; infinite where there
/// is none.
[[nodiscard]] std::vector<double> span_lengths(const Fit& fit);

/// The same spans for the curve run backwards.
[[nodiscard]] std::vector<Span> reversed(std::vector<Span> spans);

/// Largest distance of corresponding samples, span by span. nullopt if the curves do not meet the same points in the
/// same order; on closed curves the orders may be cyclic shifts of each other.
[[nodiscard]] std::optional<std::vector<double>> span_deviations(std::span<const Span> a, std::span<const Span> b,
                                                                 bool closed);

/// Largest of span_deviations; infinite where those are nullopt.
[[nodiscard]] double deviation(std::span<const Span> a, std::span<const Span> b, bool closed);

/// Which of n points or spans an experiment of many fits tries: all of up to 60, otherwise 12, evenly spread.
[[nodiscard]] std::vector<int> tried(int n);

}  // namespace kappabench
