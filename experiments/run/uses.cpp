#include "experiments/run/uses.hpp"

#include <fmt/format.h>

#include <bit>
#include <string_view>

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
  /// Lists are told apart by their lengths.
  template <class Items, class Add>
  void add_all(std::string_view what, const Items& items, Add add_one) {
    add(fmt::format("{} {}", what, items.size()));
    for (const auto& item : items) add_one(item);
  }
  [[nodiscard]] std::string hex() const { return fmt::format("{:016x}", state_); }

 private:
  void add_byte(unsigned char byte) { state_ = (state_ ^ byte) * 0x100000001b3ULL; }
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

void add_scheme(Hash& hash, const Scheme& scheme) {
  hash.add(fmt::format("{} {}", scheme.info().id, scheme.info().version));
  hash.add(scheme.parameters().canonical());
  if (!scheme.info().plugin_digest.empty()) hash.add(scheme.info().plugin_digest);
}

void add_options(Hash& hash, const PointOptions& options) {
  hash.add(options.type ? name(*options.type) : "-");
  for (const PointNumber& number : point_numbers) {
    const std::optional<double>& value = options.*number.member;
    value ? hash.add(*value) : hash.add("-");
  }
}

void add_input(Hash& hash, const Input& input) {
  hash.add(input.closed ? "closed" : "open");
  hash.add_all("points", input.points, [&](const Vec2& p) { hash.add(p.x()), hash.add(p.y()); });
  hash.add_all("options", input.options, [&](const PointOptions& options) { add_options(hash, options); });
}

}  // namespace

std::string key_of(const Uses& uses) {
  Hash hash;
  hash.add(fmt::format("{} {}, seed {}", uses.work, uses.version, uses.seed));
  hash.add_all("schemes", uses.schemes, [&](const SchemePtr& scheme) { add_scheme(hash, *scheme); });
  hash.add_all("drawings", uses.drawings, [&](const Drawing& drawing) {
    hash.add_all("curves", drawing.curves, [&](const Input& input) { add_input(hash, input); });
  });
  hash.add_all("metrics", uses.metrics,
               [&](const Metric* metric) { hash.add(fmt::format("{} {}", metric->id, metric->version)); });
  hash.add_all("numbers", uses.numbers, [&](const auto& number) { hash.add(number.first), hash.add(number.second); });
  hash.add_all("words", uses.words, [&](const auto& word) { hash.add(word.first), hash.add(word.second); });
  return hash.hex();
}

}  // namespace kappabench
