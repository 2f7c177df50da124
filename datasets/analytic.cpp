#include "datasets/analytic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "datasets/key_values.hpp"
#include "datasets/random_source.hpp"

namespace kappabench {
namespace {

constexpr double pi = std::numbers::pi;

/// c(u) for u in [from, to].
struct Parametric {
  std::function<Vec2(double)> at;
  double from;
  double to;
  bool closed;
};

Vec2 polar(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

/// The integral of (cos, sin)(u^2 / 2) from 0: curvature u. 30 nodes are exact to rounding up to |u| = 2.5, where
/// the direction has turned by no more than 3.2.
Vec2 clothoid(double u) {
  using Rule = boost::math::quadrature::gauss<double, 30>;
  return {Rule::integrate([](double s) { return std::cos(s * s / 2.0); }, 0.0, u),
          Rule::integrate([](double s) { return std::sin(s * s / 2.0); }, 0.0, u)};
}

Vec2 superellipse(double u) {
  const Vec2 direction(std::cos(u), std::sin(u));
  const Vec2 unit = direction / std::pow(direction.array().pow(4).sum(), 0.25);
  return {2.0 * unit.x(), unit.y()};
}

Parametric curve_of(AnalyticKind kind) {
  switch (kind) {
    case AnalyticKind::circle:
      return {[](double u) { return polar(1.0, u); }, 0.0, 2.0 * pi, true};
    case AnalyticKind::ellipse:
      return {[](double u) { return Vec2(2.0 * std::cos(u), std::sin(u)); }, 0.0, 2.0 * pi, true};
    case AnalyticKind::superellipse:
      return {superellipse, 0.0, 2.0 * pi, true};
    case AnalyticKind::clothoid:
      return {clothoid, -2.5, 2.5, false};
    case AnalyticKind::log_spiral:
      return {[](double u) { return polar(0.2 * std::exp(0.2 * u), u); }, 0.0, 4.0 * pi, false};
    case AnalyticKind::sine:
      return {[](double u) { return Vec2(u, std::sin(u)); }, -1.5 * pi, 1.5 * pi, false};
    case AnalyticKind::limacon:
      return {[](double u) { return polar(1.0 + 2.0 * std::cos(u), u); }, 0.0, 2.0 * pi, true};
  }
  throw std::logic_error("unknown AnalyticKind");
}

/// Turns fractions of the arc length into parameters, by a fine polyline.
class ArcLengthTable {
 public:
  explicit ArcLengthTable(const Parametric& curve) : curve_(curve) {
    Vec2 before = curve.at(curve.from);
    for (int i = 1; i <= pieces; ++i) {
      const Vec2 here = curve.at(parameter(i));
      length_.push_back(length_.back() + (here - before).norm());
      before = here;
    }
  }

  [[nodiscard]] double length() const { return length_.back(); }

  [[nodiscard]] double parameter_at(double fraction) const {
    const double wanted = fraction * length();
    const auto above = std::upper_bound(length_.begin() + 1, length_.end() - 1, wanted);
    const double below = *(above - 1);
    return parameter(static_cast<double>(above - length_.begin() - 1) + (wanted - below) / (*above - below));
  }

 private:
  static constexpr int pieces = 20'000;

  [[nodiscard]] double parameter(double i) const { return curve_.from + (curve_.to - curve_.from) * i / pieces; }

  const Parametric& curve_;
  std::vector<double> length_{0.0};
};

/// n ascending fractions of the length from 0; an open curve ends with 1.
std::vector<double> fractions(int n, bool closed, Sampling sampling, RandomSource& random) {
  std::vector<double> at{0.0};
  const int spans = closed ? n : n - 1;
  for (int i = 0; i < spans; ++i) {
    at.push_back(at.back() + (sampling == Sampling::uneven ? random.log_uniform(0.05, 1.0) : 1.0));
  }
  const double whole = at.back();
  for (double& x : at) x /= whole;
  at.resize(static_cast<std::size_t>(n));
  return at;
}

template <class Kind>
Kind parse_kind(std::string_view text, std::string_view what, const std::vector<Kind>& all, const Place& place) {
  std::string known;
  for (const Kind kind : all) {
    if (text == name(kind)) return kind;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", name(kind));
  }
  refuse(place, fmt::format("no {} {}", what, in_quotes(text)), fmt::format("known are {}", known));
}

}  // namespace

const std::vector<AnalyticKind>& analytic_kinds() {
  static const std::vector<AnalyticKind> kinds{
      AnalyticKind::circle,     AnalyticKind::ellipse, AnalyticKind::superellipse, AnalyticKind::clothoid,
      AnalyticKind::log_spiral, AnalyticKind::sine,    AnalyticKind::limacon};
  return kinds;
}

const std::vector<Sampling>& samplings() {
  static const std::vector<Sampling> all{Sampling::even, Sampling::uneven, Sampling::noisy};
  return all;
}

std::string_view name(AnalyticKind kind) {
  constexpr std::array<std::string_view, 7> names{"circle",     "ellipse", "superellipse", "clothoid",
                                                  "log-spiral", "sine",    "limacon"};
  return names[static_cast<std::size_t>(kind)];
}

std::string_view name(Sampling sampling) {
  constexpr std::array<std::string_view, 3> names{"even", "uneven", "noisy"};
  return names[static_cast<std::size_t>(sampling)];
}

Input analytic_input(AnalyticKind kind, int n, Sampling sampling, std::uint64_t seed) {
  if (n < 2) throw std::invalid_argument(fmt::format("analytic_input: n = {}; give at least 2", n));
  const Parametric curve = curve_of(kind);
  const ArcLengthTable table(curve);
  RandomSource random(seed);
  Input input;
  input.closed = curve.closed;
  for (const double fraction : fractions(n, curve.closed, sampling, random)) {
    input.points.push_back(curve.at(table.parameter_at(fraction)));
  }
  const double noise = sampling == Sampling::noisy ? 0.02 * table.length() / (curve.closed ? n : n - 1) : 0.0;
  for (Vec2& point : input.points) {
    if (noise > 0.0) {
      point.x() += noise * random.normal();
      point.y() += noise * random.normal();
    }
    point = on_grid(point);
  }
  return input;
}

Drawing analytic_drawing(std::string_view text) {
  const std::vector<std::string_view> parts = split(text, ':');
  const Place place{std::string(text), 0};
  if (parts.size() < 2 || parts.size() > 3 || parts[0] != "analytic") {
    refuse(place, "this names no analytic curve", "write analytic:KIND:n=12,sampling=even");
  }
  const AnalyticKind kind = parse_kind(parts[1], "analytic curve", analytic_kinds(), place);
  KeyValues options(parts.size() == 3 ? parts[2] : "", text);
  const auto n = static_cast<int>(options.take_integer("n", 12, 2, 10'000'000));
  const Sampling sampling = parse_kind(options.take_word("sampling", "even"), "sampling", samplings(), place);
  const std::uint64_t seed = options.take_seed();
  options.expect_all_taken("n, sampling, seed");

  const std::string id = fmt::format("analytic:{}:n={},sampling={},seed={}", name(kind), n, name(sampling), seed);
  return {.id = id,
          .title = fmt::format("{}, {} points, {} sampling", name(kind), n, name(sampling)),
          .source = fmt::format("generated: {}", id),
          .licence = "CC0",
          .units = "of order 1",
          .curves = {analytic_input(kind, n, sampling, seed)}};
}

}  // namespace kappabench
