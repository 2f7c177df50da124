#include "metrics/correspondence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/node_pieces.hpp"

namespace kappabench {
namespace {

bool same_order(std::span<const Span> a, std::span<const Span> b, std::size_t shift) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Span& other = b[(i + shift) % b.size()];
    if (a[i].from != other.from || a[i].to != other.to) return false;
  }
  return true;
}

double largest_distance(const Span& a, const Span& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.samples.size(); ++k) {
    const double d = (a.samples[k] - b.samples[k]).norm();
    if (!(d <= largest)) largest = d;  // keeps NaN
  }
  return largest;
}

}  // namespace

std::vector<Span> spans(const Curve& curve, std::optional<int> left_out) {
  const ArcMap arcs(curve);
  std::vector<PlacedNode> nodes = nodes_in_order(curve, arcs);
  std::erase_if(nodes, [&](const PlacedNode& node) { return left_out && node.node.point == *left_out; });
  if (nodes.empty()) return {};
  if (!curve.closed()) {
    if (!at_end(nodes.front(), curve, arcs)) nodes.insert(nodes.begin(), {{no_point, 0, 0.0}, 0.0});
    if (!at_end(nodes.back(), curve, arcs)) nodes.push_back({{no_point, curve.size() - 1, 1.0}, arcs.length()});
  }
  std::vector<Span> result;
  const std::size_t n = nodes.size();
  for (std::size_t i = 0; i < n && (curve.closed() || i + 1 < n); ++i) {
    const bool closing = i + 1 == n;
    const double from = nodes[i].position;
    const double to = closing ? nodes.front().position + arcs.length() : nodes[i + 1].position;
    Span span{nodes[i].node.point, nodes[(i + 1) % n].node.point, {}};
    for (int k = 0; k < samples_per_span; ++k) {
      const CurvePlace place = arcs.place(from + (to - from) * k / (samples_per_span - 1));
      span.samples.push_back(curve.segment(place.segment).jet(place.t, 0).position());
    }
    result.push_back(std::move(span));
  }
  return result;
}

double length_of(const Span& span) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < span.samples.size(); ++i) length += (span.samples[i + 1] - span.samples[i]).norm();
  return length;
}

std::vector<double> span_lengths(const Fit& fit) {
  std::vector<double> lengths(fit.input.points.size(), std::numeric_limits<double>::infinity());
  for (const Span& span : spans(*fit.curve))
    if (span.from != no_point && span.from != span.to) lengths[static_cast<std::size_t>(span.from)] = length_of(span);
  return lengths;
}

std::vector<Span> reversed(std::vector<Span> spans) {
  std::reverse(spans.begin(), spans.end());
  for (Span& span : spans) {
    std::swap(span.from, span.to);
    std::reverse(span.samples.begin(), span.samples.end());
  }
  return spans;
}

std::optional<std::vector<double>> span_deviations(std::span<const Span> a, std::span<const Span> b, bool closed) {
  if (a.size() != b.size()) return std::nullopt;
  for (std::size_t shift = 0; shift < (closed ? std::max<std::size_t>(1, a.size()) : 1); ++shift) {
    if (!same_order(a, b, shift)) continue;
    std::vector<double> result;
    for (std::size_t i = 0; i < a.size(); ++i) result.push_back(largest_distance(a[i], b[(i + shift) % b.size()]));
    return result;
  }
  return std::nullopt;
}

double deviation(std::span<const Span> a, std::span<const Span> b, bool closed) {
  const auto deviations = span_deviations(a, b, closed);
  if (!deviations) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (const double d : *deviations) {
    if (!(d <= largest)) largest = d;
  }
  return largest;
}

std::vector<int> tried(int n) {
  const int count = n <= 60 ? n : 12;
  std::vector<int> chosen;
  chosen.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) chosen.push_back(static_cast<int>(static_cast<long>(k) * n / count));
  return chosen;
}

}  // namespace kappabench
