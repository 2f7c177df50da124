#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace kappabench {

/// A piece of work to be timed. `name` has no '/'.
struct TimedWork {
  std::string name;
  std::function<void()> run;
};

struct TimingOptions {
  int repetitions = 10;         ///< samples of each work, >= 1
  double least_seconds = 0.02;  ///< a sample repeats the work until this much processor time has passed
};

/// Times each work with Google Benchmark: it finds how often to run the work in a sample, and takes the samples of
/// all works in random order, so that a slow spell of the machine hits all of them alike. Returns the raw samples by
/// name: processor seconds of the whole process, all threads together, for one run of the work. Waiting for a busy
/// machine does not count, though its effect on caches and clock rates does. Writes nothing to any stream.
///
/// The numbers tell about this machine at this time: compare medians, as ratios. Not safe to call from several
/// threads: Google Benchmark keeps one list of benchmarks (empty again on return).
[[nodiscard]] std::map<std::string, std::vector<double>> time_all(std::span<const TimedWork> works,
                                                                  const TimingOptions& options);

/// Processor seconds that this process has used so far, all threads together.
[[nodiscard]] double processor_seconds();

/// Bytes of the largest resident set that this process had so far.
[[nodiscard]] double peak_resident_bytes();

}  // namespace kappabench
