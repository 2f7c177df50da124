#include "experiments/cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string_view>
#include <utility>

#include "experiments/record.hpp"

namespace kappabench {

namespace {

/// FNV-1a, 64 bits: stable over platforms and versions, unlike std::hash and boost::hash.
class Hash {
 public:
  void add(std::string_view text) {
    for (const char c : text) add_byte(static_cast<unsigned char>(c));
    add_byte(0);
  }
  void add(double value) { add(fmt::format("{:016x}", std::bit_cast<std::uint64_t>(value))); }
  [[nodiscard]] std::string hex() const { return fmt::format("{:016x}", state_); }

 private:
  void add_byte(unsigned char byte) { state_ = (state_ ^ byte) * 0x100000001b3ULL; }
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

void add_scheme(Hash& hash, const Scheme& scheme) {
  hash.add(fmt::format("{} {}", scheme.info().id, scheme.info().version));
  hash.add(scheme.parameters().canonical());
}

void add_input(Hash& hash, const Input& input) {
  hash.add(input.closed ? "closed" : "open");
  for (const Vec2& p : input.points) {
    hash.add(p.x());
    hash.add(p.y());
  }
  for (const PointOptions& options : input.options) {
    hash.add(options.type ? name(*options.type) : "-");
    for (const auto& value : {options.a, options.h, options.alpha, options.beta, options.tangent, options.curvature})
      value ? hash.add(*value) : hash.add("-");
  }
}

/// From best to worst: the outcome of a cell is the worst of its curves.
int severity(std::string_view outcome) {
  constexpr std::array<Outcome, 6> order{Outcome::converged, Outcome::unsupported_input, Outcome::not_converged,
                                         Outcome::failed,    Outcome::timed_out,         Outcome::crashed};
  return static_cast<int>(std::ranges::find(order, outcome, [](Outcome o) { return name(o); }) - order.begin());
}

store::CellRecord fit_cell(const Drawing& drawing, const Scheme& scheme, const std::vector<const Metric*>& metrics) {
  store::CellRecord cell;
  cell.outcome = name(Outcome::converged);
  for (std::size_t i = 0; i < drawing.curves.size(); ++i) {
    cell.curves.push_back(record_of(scheme, scheme.fit(drawing.curves[i]), metrics));
    const store::CurveRecord& curve = cell.curves.back();
    if (severity(curve.outcome) <= severity(cell.outcome)) continue;
    cell.outcome = curve.outcome;
    cell.message = drawing.curves.size() == 1 ? curve.message : fmt::format("curve {}: {}", i, curve.message);
  }
  return cell;
}

}  // namespace

std::string label_of(const Scheme& scheme) {
  const std::string brief = scheme.parameters().brief();
  return brief.empty() ? scheme.info().id : fmt::format("{} {}", scheme.info().id, brief);
}

CellJob fit_job(const Drawing& drawing, SchemePtr scheme, std::vector<const Metric*> metrics) {
  Hash hash;
  add_scheme(hash, *scheme);
  for (const Input& input : drawing.curves) add_input(hash, input);
  for (const Metric* metric : metrics) hash.add(fmt::format("{} {}", metric->id, metric->version));
  CellJob job{.dataset = drawing.id,
              .scheme = scheme->info().id,
              .parameters = scheme->parameters().canonical(),
              .label = label_of(*scheme),
              .key = hash.hex(),
              .compute = {}};
  job.compute = [drawing, scheme = std::move(scheme), metrics = std::move(metrics)] {
    return fit_cell(drawing, *scheme, metrics);
  };
  return job;
}

CellJob other_job(std::string dataset, const SchemePtr& scheme, const std::string& what,
                  std::function<void(store::CellRecord&)> compute) {
  Hash hash;
  add_scheme(hash, *scheme);
  hash.add(dataset);
  hash.add(what);
  CellJob job{.dataset = std::move(dataset),
              .scheme = scheme->info().id,
              .parameters = scheme->parameters().canonical(),
              .label = label_of(*scheme),
              .key = hash.hex(),
              .compute = {}};
  job.compute = [compute = std::move(compute)] {
    store::CellRecord cell;
    cell.outcome = name(Outcome::converged);
    compute(cell);
    return cell;
  };
  return job;
}

}  // namespace kappabench
