// A scheme that crashes, throws, returns nothing or never ends, in the way that a definition says.
#include <csignal>
#include <memory>
#include <stdexcept>
#include <utility>

#include "schemes/api/registry.hpp"

namespace {

#if defined(TAKEN_ID)
constexpr const char* id = "kappa";
#elif defined(BAD_ID)
constexpr const char* id = "My Spline:a=1";
#else
constexpr const char* id = "trouble";
#endif

class Trouble final : public kappabench::Scheme {
 public:
  static kappabench::SchemeInfo describe() { return {.id = id, .title = "Trouble", .citation = "none"}; }
  explicit Trouble(kappabench::Parameters parameters) : Scheme(describe(), std::move(parameters)) {
#ifdef CRASH_WHEN_MADE
    std::raise(SIGSEGV);
#endif
  }

 private:
  [[nodiscard]] kappabench::Fit solve(const kappabench::Input& input) const override {
#if defined(CRASH)
    std::raise(SIGSEGV);
#elif defined(THROW)
    throw std::runtime_error("no such\nluck");
#elif defined(NO_CURVE)
    return {.input = input, .curve = {}, .report = {.outcome = kappabench::Outcome::converged }};
#else
    for (volatile int i = 0; input.size() > 0;) i = i + 1;
#endif
    return {};
  }
};

}  // namespace

void register_schemes(kappabench::Registry& registry) { registry.add<Trouble>(); }
