#include "experiments/study/timing.hpp"

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <array>
#include <ctime>
#include <ostream>

namespace kappabench {

namespace {

using Samples = std::map<std::string, std::vector<double>>;

/// Keeps the samples, prints nothing.
class Collector final : public benchmark::BenchmarkReporter {
 public:
  Collector() {
    SetOutputStream(&nowhere_);
    SetErrorStream(&nowhere_);
  }

  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration)
        samples_[run.run_name.function_name].push_back(run.cpu_accumulated_time / static_cast<double>(run.iterations));
  }

  [[nodiscard]] const Samples& samples() const { return samples_; }

 private:
  std::ostream nowhere_{nullptr};
  Samples samples_;
};

/// Google Benchmark takes this setting from a command line only.
void interleave_at_random(bool on) {
  std::string program = "kappabench";
  std::string flag =
      on ? "--benchmark_enable_random_interleaving=true" : "--benchmark_enable_random_interleaving=false";
  std::array<char*, 3> arguments{program.data(), flag.data(), nullptr};
  int count = 2;
  benchmark::Initialize(&count, arguments.data());
}

}  // namespace

Samples time_all(std::span<const TimedWork> works, const TimingOptions& options) {
  interleave_at_random(true);
  for (const TimedWork& work : works)
    benchmark::RegisterBenchmark(work.name.c_str(),
                                 [&work](benchmark::State& state) {
                                   for ([[maybe_unused]] auto once : state) work.run();
                                 })
        ->MeasureProcessCPUTime()
        ->MinTime(options.least_seconds)
        ->Repetitions(options.repetitions)
        ->ReportAggregatesOnly(false);
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector, std::string("."));
  benchmark::ClearRegisteredBenchmarks();
  interleave_at_random(false);
  return collector.samples();
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double peak_resident_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);  // Linux counts kilobytes
}

}  // namespace kappabench
