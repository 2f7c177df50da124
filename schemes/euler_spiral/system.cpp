#include "schemes/euler_spiral/system.hpp"

#include <algorithm>
#include <cmath>

namespace kappabench::euler_spiral {

System::System(const Polygon& polygon)
    : polygon_(polygon),
      spans_(polygon.chords()),
      values_(polygon.points()),
      by_bend_(polygon.points()),
      columns_(polygon.points()) {
  matrix_.cyclic = polygon.closed;
  matrix_.resize(polygon.points());
}

bool System::evaluate(std::span<const double> headings, double bend) {
  const std::size_t n = polygon_.points();
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const std::size_t next = (i + 1) % n;
    const auto span =
        span_between(headings[i] - 0.5 * bend * polygon_.turns[i], headings[next] + 0.5 * bend * polygon_.turns[next]);
    if (!span) return false;
    spans_[i] = *span;
  }
  for (std::size_t k = 0; k < n; ++k) {
    const bool is_end = !polygon_.closed && (k == 0 || k + 1 == n);
    const Row row = is_end ? at_end(k, headings, bend) : between_spans(k);
    values_[k] = row.value;
    matrix_.lower[k](0) = row.lower;
    matrix_.diagonal[k](0) = row.diagonal;
    matrix_.upper[k](0) = row.upper;
    by_bend_[k] = row.by_bend;
  }
  return true;
}

System::Row System::at_end(std::size_t k, std::span<const double> headings, double bend) const {
  const bool first = k == 0;
  if (const auto& given = first ? polygon_.start : polygon_.end)
    return {.value = headings[k] - bend * *given, .lower = 0.0, .diagonal = 1.0, .upper = 0.0, .by_bend = -*given};
  if (first && polygon_.points() == 2 && !polygon_.end)
    return {.value = headings[k], .lower = 0.0, .diagonal = 1.0, .upper = 0.0, .by_bend = 0.0};
  const std::size_t inner = first ? 1 : k - 1;
  const double half_turn = (first ? 0.5 : -0.5) * polygon_.turns[inner];
  return {.value = headings[k] + headings[inner] + bend * half_turn,
          .lower = first ? 0.0 : 1.0,
          .diagonal = 1.0,
          .upper = first ? 1.0 : 0.0,
          .by_bend = half_turn};
}

System::Row System::between_spans(std::size_t k) const {
  const std::size_t n = polygon_.points(), before = polygon_.before(k);
  const double shorter = std::min(polygon_.lengths[before], polygon_.lengths[k]);
  const double w0 = shorter / polygon_.lengths[before], w1 = shorter / polygon_.lengths[k];
  const EndCurvature &a = spans_[before].at_end, &b = spans_[k].at_start;
  const std::vector<double>& turns = polygon_.turns;
  // A turn takes half of itself from the heading after its point, and adds half to that before.
  return {.value = w0 * a.value - w1 * b.value,
          .lower = w0 * a.by_start,
          .diagonal = w0 * a.by_end - w1 * b.by_start,
          .upper = -w1 * b.by_end,
          .by_bend = 0.5 * (-w0 * a.by_start * turns[before] + (w0 * a.by_end + w1 * b.by_start) * turns[k] -
                            w1 * b.by_end * turns[(k + 1) % n])};
}

double System::residual() const {
  double largest = 0.0;
  for (const double value : values_) largest = std::max(largest, std::abs(value));
  return largest;
}

double System::squares() const {
  double sum = 0.0;
  for (const double value : values_) sum += value * value;
  return sum;
}

bool System::solve(std::vector<double>& step, std::vector<double>& by_bend) {
  const std::size_t n = columns_.size();
  for (std::size_t k = 0; k < n; ++k) columns_[k] << -values_[k], -by_bend_[k];
  if (!solver_.solve(matrix_, std::span(columns_))) return false;
  step.resize(n);
  by_bend.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    step[k] = columns_[k](0);
    by_bend[k] = columns_[k](1);
  }
  return true;
}

}  // namespace kappabench::euler_spiral
