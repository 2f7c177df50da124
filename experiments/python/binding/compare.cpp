#include "experiments/python/binding/compare.hpp"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <exception>
#include <thread>

#include "experiments/across/compare.hpp"
#include "experiments/run/cell.hpp"
#include "experiments/run/record.hpp"

namespace kappabench::python {

namespace {

store::CurveRecord thrown(const Scheme& scheme, const Input& input, const std::exception& error) {
  const Fit lost{.input = input, .curve = {}, .report = {.outcome = Outcome::failed, .message = error.what()}};
  return record_of(scheme, lost, {});
}

store::CellRecord cell_of(const CellJob& job) {
  store::CellRecord cell{.dataset = job.dataset, .label = job.label};
  const Scheme& scheme = *job.uses.schemes.front();
  for (const Input& input : job.uses.drawings.front().curves) {
    try {
      cell.curves.push_back(record_of(scheme, scheme.fit(input), job.uses.metrics));
    } catch (const std::exception& error) {
      cell.curves.push_back(thrown(scheme, input, error));
    }
  }
  return cell;
}

/// Threads that each take the next cell until none is left. Whoever destroys them waits for the cells at hand alone.
class Crew {
 public:
  Crew(const std::vector<CellJob>& jobs, std::vector<store::CellRecord>& cells, int threads) {
    for (int i = 0; i < threads; ++i)
      threads_.emplace_back([&](const std::stop_token& stop) {
        for (std::size_t k = next_++; k < jobs.size() && !stop.stop_requested(); k = next_++) {
          cells[k] = cell_of(jobs[k]);
          ++done_;
        }
      });
  }
  [[nodiscard]] std::size_t done() const { return done_; }

 private:
  std::atomic<std::size_t> next_ = 0, done_ = 0;
  std::vector<std::jthread> threads_;
};

}  // namespace

store::TableRecord compare(const std::vector<Drawing>& drawings, const std::vector<SchemePtr>& schemes,
                           const std::vector<const Metric*>& metrics, int threads,
                           const std::function<void()>& checked) {
  std::vector<CellJob> jobs;
  for (const Drawing& drawing : drawings)
    for (const SchemePtr& scheme : schemes) jobs.push_back(fit_job(drawing, scheme, metrics));
  store::ExperimentRecord record;
  record.cells.resize(jobs.size());
  {
    const Crew crew(jobs, record.cells, threads);
    for (auto pause = std::chrono::microseconds(100); crew.done() < jobs.size(); checked()) {
      std::this_thread::sleep_for(pause);
      if (pause < std::chrono::milliseconds(50)) pause *= 2;
    }
  }
  const Registry none;
  const Context context{.registry = none};
  return comparison::curve_table(study::Findings(context, {}, record)).record();
}

}  // namespace kappabench::python
