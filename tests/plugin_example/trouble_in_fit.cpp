// A scheme that crashes, or never ends.
#include <csignal>
#include <memory>
#include <utility>

#include "schemes/api/registry.hpp"

namespace {

class Trouble final : public kappabench::Scheme {
 public:
  static kappabench::SchemeInfo describe() { return {.id = "trouble", .title = "Trouble", .citation = "none"}; }
  explicit Trouble(kappabench::Parameters parameters) : Scheme(describe(), std::move(parameters)) {}

 private:
  [[nodiscard]] kappabench::Fit solve(const kappabench::Input& input) const override {
#ifdef CRASH
    std::raise(SIGSEGV);
#else
    for (volatile int i = 0; input.size() > 0;) i = i + 1;
#endif
    return {};
  }
};

}  // namespace

void register_schemes(kappabench::Registry& registry) { registry.add<Trouble>(); }
