// What benchmark.py holds the module against: the same work in C++ alone.
#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

#include "experiments/python/binding/bind.hpp"
#include "experiments/python/binding/fitted.hpp"

namespace kappabench::python {

namespace py = pybind11;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The median time of Scheme::fit.
double fit_seconds(const ChosenScheme& chosen, const Input& input, int repetitions) {
  std::vector<double> seconds(static_cast<std::size_t>(std::max(1, repetitions)));
  for (double& one : seconds) {
    const auto start = Clock::now();
    const Fit fit = chosen.scheme->fit(input);
    one = seconds_since(start);
  }
  std::ranges::nth_element(seconds, seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2));
  return seconds[seconds.size() / 2];
}

/// Evaluates about `count` uniform parameters in batches and adds up the derivatives of this order, so that none can be
/// left out.
double checksum(const Fitted& fitted, std::size_t count, int order) {
  const Curve& curve = curve_in(fitted);
  constexpr std::size_t batch = 256;
  const std::size_t per_segment = std::max<std::size_t>(1, count / static_cast<std::size_t>(curve.size()));
  std::array<double, batch> t;
  std::array<Jet, batch> jets;
  Vec2 sum = Vec2::Zero();
  for (const SegmentPtr& segment : curve.segments())
    for (std::size_t done = 0; done < per_segment; done += batch) {
      const std::size_t now = std::min(batch, per_segment - done);
      for (std::size_t j = 0; j < now; ++j) t[j] = static_cast<double>(done + j) / static_cast<double>(per_segment);
      segment->jets(std::span{t}.first(now), order, std::span{jets}.first(now));
      for (std::size_t j = 0; j < now; ++j) sum += jets[j].d[static_cast<std::size_t>(order)];
    }
  return sum.sum();
}

}  // namespace

void bind_baseline(py::module_& module) {
  module.def("fit_seconds", &fit_seconds, py::call_guard<py::gil_scoped_release>());
  module.def("checksum", &checksum, py::call_guard<py::gil_scoped_release>());
}

}  // namespace kappabench::python
