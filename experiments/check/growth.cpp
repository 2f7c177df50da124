#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <vector>

#include "experiments/check/all_claims.hpp"
#include "schemes/api/timed_outside.hpp"

namespace kappabench::check {

namespace {

// Cubic growth fails, quadratic growth, with what a busy machine adds to it, does not.
constexpr double largest_exponent = 2.5;
constexpr int repetitions = 3;
constexpr double most_seconds = 2.0;     // of all fits
constexpr double enough_seconds = 2e-3;  // of one sample, against the steps of the clock
constexpr std::size_t sizes_used = 4;    // the largest ones: what grows slower is gone there

/// Processor seconds of this thread.
double thread_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Sample {
  double n, median, least;  ///< seconds
};

/// Seconds that a fit took.
double seconds_of_fit(const SchemeUnderTest& subject, const Input& input) {
  const double start = thread_seconds();
  const Fit fit = subject.fit(input);
  return is_timed_outside(fit.report) ? fit.report.seconds : thread_seconds() - start;
}

Sample timed(const SchemeUnderTest& subject, const Input& input) {
  std::array<double, repetitions> samples{};
  for (double& sample : samples) {
    double seconds = 0.0;
    int fits = 0;
    do {
      seconds += seconds_of_fit(subject, input);
      ++fits;
    } while (seconds < enough_seconds);
    sample = seconds / fits;
  }
  std::ranges::sort(samples);
  return {static_cast<double>(input.size()), samples[repetitions / 2], samples.front()};
}

/// Slope of log seconds over log n, by least squares.
double exponent(const std::vector<Sample>& samples, double Sample::*seconds) {
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Sample& sample : samples) {
    const double a = std::log(sample.n), b = std::log(sample.*seconds);
    x += a, y += b, xx += a * a, xy += a * b;
  }
  const auto n = static_cast<double>(samples.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  const bool closed = subject.traits().closed;
  std::vector<Sample> samples;
  double spent = 0.0, next = 0.0;
  // The short ones are for schemes that take too long for the others.
  for (const int n : {31, 62, 125, 250, 500, 1000, 2000}) {
    if (spent + repetitions * next > most_seconds) break;
    const Case shown = random_star(n, 1, closed);
    samples.push_back(timed(subject, shown.input));
    notes.count("sizes");
    const double seconds = samples.back().median;
    spent += repetitions * seconds;
    next = seconds * (samples.size() < 2 ? 4.0 : seconds / samples[samples.size() - 2].median);
  }
  if (samples.size() > sizes_used) samples.erase(samples.begin(), samples.end() - sizes_used);
  if (samples.size() < 3) {
    notes.say("too slow to tell");
    return {.verdict = Verdict::not_tried, .tried = notes.finding().tried, .note = notes.finding().note};
  }
  const double found = exponent(samples, &Sample::median);
  const std::string numbers = fmt::format("n^{:.2f}: {:.2g} s at {}, {:.2g} s at {}", found, samples.front().median,
                                          samples.front().n, samples.back().median, samples.back().n);
  notes.say(numbers);
  const Case longest = random_star(static_cast<int>(samples.back().n), 1, closed);
  // A busy machine makes single fits slow, but not the fastest of each size.
  if (found > largest_exponent && exponent(samples, &Sample::least) > largest_exponent)
    notes.refute({longest.name, fmt::format("{}; allowed is n^{}", numbers, largest_exponent),
                  "time " + fit_command(longest, subject.text())});
  return notes.finding();
}

}  // namespace

Claim growth_claim() { return {"growth", "time of a fit grows more slowly than n^2.5", always, test}; }

}  // namespace kappabench::check
