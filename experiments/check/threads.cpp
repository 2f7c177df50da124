#include <fmt/format.h>

#include <array>
#include <atomic>
#include <thread>
#include <vector>

#include "experiments/check/all_claims.hpp"
#include "experiments/check/same_curve.hpp"

namespace kappabench::check {

namespace {

constexpr std::size_t threads = 8;
constexpr std::size_t rounds = 3;

/// Fits input i in thread i, all starting together.
std::array<Fit, threads> fit_at_once(const SchemeUnderTest& subject, const std::array<Input, threads>& given) {
  std::array<Fit, threads> fits{};
  std::atomic<std::size_t> waiting{threads};
  std::vector<std::thread> running;
  for (std::size_t i = 0; i < threads; ++i)
    running.emplace_back([&, i] {
      --waiting;
      while (waiting > 0) std::this_thread::yield();
      fits[i] = subject.fit(given[i]);
    });
  for (std::thread& thread : running) thread.join();
  return fits;
}

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  const bool closed = subject.traits().closed;
  std::array<Case, threads> cases;
  std::array<Input, threads> given;
  std::vector<Fit> alone;
  for (std::size_t i = 0; i < threads; ++i) {
    // Different points, lengths in pairs: state that is shared shows in numbers, and in sizes.
    cases[i] = random_star(8 + static_cast<int>(i / 2) * 3, 11 + static_cast<int>(i), closed);
    given[i] = cases[i].input;
    alone.push_back(subject.fit(given[i]));
  }
  for (std::size_t round = 0; round < rounds; ++round) {
    const std::array<Fit, threads> together = fit_at_once(subject, given);
    for (std::size_t i = 0; i < threads; ++i) {
      notes.count("fits");
      if (const std::string what = difference(alone[i], together[i]); !what.empty())
        notes.refute({fmt::format("{}, beside {} other fits", cases[i].name, threads - 1), what,
                      fit_command(cases[i], subject.text())});
    }
  }
  return notes.finding();
}

}  // namespace

Claim threads_claim() { return {"threads", "8 fits at once, each equal bit for bit to itself alone", always, test}; }

}  // namespace kappabench::check
