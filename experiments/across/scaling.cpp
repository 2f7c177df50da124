#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "datasets/datasets.hpp"
#include "experiments/study/study.hpp"
#include "experiments/study/summaries.hpp"
#include "experiments/study/timing.hpp"

namespace kappabench {

namespace {

constexpr std::string_view about =
    "Every scheme with its default parameters on closed random stars of growing size: processor time of a cold fit, "
    "time of an evaluated jet (position and two derivatives), and by how much the resident set of the cell's own "
    "process grew during the fit. The exponent of growth is the slope of a least-squares line through the logarithms "
    "of the medians from 100 points on, with its 95 % interval (Student's t). Raw samples are in the results file. A "
    "size is not tried when the fit of a tenth of the points says that it would take more than two seconds; sizes "
    "that a plan names are always tried (experiments/plans/scaling-full.toml goes to a million). Run with -j 1 on an "
    "idle machine for clean numbers: two cells at a time share caches and memory.";

constexpr int version = 1;
constexpr double longest_expected = 2.0;  ///< seconds a default fit may be expected to take
constexpr double longest_repeated = 0.5;  ///< seconds of a fit that is timed more than once
constexpr double cell_budget = 0.12;      ///< seconds of samples a cell, more if one fit takes more
constexpr double least_points = 100.0;    ///< from where growth is fitted

std::string dataset_of(int n) { return fmt::format("random:star:n={},seed=1,closed=true", n); }

double points_in(const Drawing& drawing) {
  std::size_t points = 0;
  for (const Input& input : drawing.curves) points += input.points.size();
  return static_cast<double>(points);
}

/// Fits of all curves of a drawing.
struct Fits {
  std::vector<Fit> fits;
  double seconds = 0.0;
};

Fits fit_all(const Scheme& scheme, const Drawing& drawing) {
  Fits result;
  const double start = processor_seconds();
  for (const Input& input : drawing.curves) result.fits.push_back(scheme.fit(input));
  result.seconds = processor_seconds() - start;
  return result;
}

/// Jets of order 2 at the same parameters of at most `most` segments, again and again into the same place.
class JetWork {
 public:
  explicit JetWork(const Fits& fits) : jets_(parameters_.size()) {
    constexpr std::size_t most = 200;
    for (const Fit& fit : fits.fits)
      if (fit.curve)
        for (const SegmentPtr& segment : fit.curve->segments())
          if (segments_.size() < most) segments_.push_back(segment);
    for (std::size_t k = 0; k < parameters_.size(); ++k)
      parameters_[k] = static_cast<double>(k) / static_cast<double>(parameters_.size() - 1);
  }
  [[nodiscard]] double count() const { return static_cast<double>(segments_.size() * parameters_.size()); }
  void run() {
    for (const SegmentPtr& segment : segments_) segment->jets(parameters_, 2, jets_);
  }

 private:
  std::array<double, 33> parameters_{};
  std::vector<Jet> jets_;
  std::vector<SegmentPtr> segments_;
};

void put(store::CellRecord& cell, const char* column, double value, const char* unit = "1") {
  cell.measurements.push_back({column, value, "sampled", unit});
}

/// What the first fit says; an unsolved curve is no obstacle to timing.
void report(store::CellRecord& cell, const Fits& first) {
  int iterations = 0;
  for (const Fit& fit : first.fits) {
    iterations = std::max(iterations, fit.report.iterations);
    if (fit.report.outcome == Outcome::converged) continue;
    cell.outcome = name(fit.report.outcome);
    cell.message = fit.report.message;
  }
  put(cell, "iterations", iterations);
}

void measure(const Scheme& scheme, const Drawing& drawing, const Drawing* tenth, store::CellRecord& cell) {
  put(cell, "points", points_in(drawing));
  if (tenth != nullptr) {
    const double expected = 10.0 * fit_all(scheme, *tenth).seconds;
    if (expected > longest_expected) {
      cell.outcome = name(Outcome::not_converged);
      cell.message = fmt::format("not tried: a tenth of the points says that it takes {:.2g} s or more", expected);
      return;
    }
  }
  (void)fit_all(scheme, open_drawings(dataset_of(10)).front());  // pages that any fit touches
  const double resident = peak_resident_bytes();
  const Fits first = fit_all(scheme, drawing);
  put(cell, "memory", peak_resident_bytes() - resident, "B");
  report(cell, first);
  if (std::ranges::none_of(first.fits, [](const Fit& fit) { return fit.curve.has_value(); })) return;
  if (first.seconds > longest_repeated) {
    cell.timings["fit"] = {first.seconds};  // too long to be taken again: the one sample there is
  } else {
    const int repetitions = std::clamp(static_cast<int>(cell_budget / std::max(first.seconds, 1e-6)), 3, 10);
    const TimedWork work{"fit", [&] { (void)fit_all(scheme, drawing); }};
    cell.timings = time_all(std::span(&work, 1), {.repetitions = repetitions, .least_seconds = cell_budget / 10.0});
  }
  JetWork jets(first);
  const TimedWork work{"jet", [&jets] { jets.run(); }};
  auto samples = time_all(std::span(&work, 1), {.repetitions = 5, .least_seconds = 0.002});
  for (double& seconds : samples["jet"]) seconds /= jets.count();
  cell.timings.merge(samples);
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<SchemePtr> schemes;
  for (const std::string& text : context.schemes) schemes.push_back(context.registry.parse(text));
  if (schemes.empty())
    for (const SchemeInfo& info : context.registry.list()) schemes.push_back(context.registry.create(info.id));

  std::vector<CellJob> jobs;
  const auto add = [&](const Drawing& drawing, const Drawing* tenth) {
    for (const SchemePtr& scheme : schemes)
      jobs.push_back(
          other_job(drawing.id, scheme, fmt::format("scaling {}, {}", version, study::contents_of({drawing})),
                    [scheme, drawing, probe = tenth == nullptr ? Drawing{} : *tenth](store::CellRecord& cell) {
                      measure(*scheme, drawing, probe.curves.empty() ? nullptr : &probe, cell);
                    }));
  };
  for (const std::string& dataset : context.datasets)
    for (const Drawing& drawing : open_drawings(dataset)) add(drawing, nullptr);
  if (!context.datasets.empty()) return jobs;
  for (const int n : {10, 32, 100, 320, 1000, 3200, 10000}) {
    const Drawing drawing = open_drawings(dataset_of(n)).front();
    if (n < 100) {
      add(drawing, nullptr);
    } else {
      const Drawing tenth = open_drawings(dataset_of(n / 10)).front();
      add(drawing, &tenth);
    }
  }
  return jobs;
}

double points_of(const store::CellRecord& cell) { return measured(cell, "points").value_or(std::nan("")); }

double median_of(const store::CellRecord& cell, const char* timing) {
  const auto found = cell.timings.find(timing);
  return found == cell.timings.end() ? std::nan("") : median(found->second);
}

store::TableRecord cell_table(const store::ExperimentRecord& record) {
  TableBuilder builder("scaling", "Time and memory against the number of points",
                       "Medians over the samples of each cell; spread: quotient of the largest and least sample.");
  builder.words("scheme").counts("points").words("outcome").counts("iterations").counts("samples");
  builder.numbers("fit", "s").numbers("spread").numbers("fit a point", "s").numbers("jet", "s");
  builder.numbers("memory", "B").numbers("memory a point", "B");
  for (const store::CellRecord& cell : record.cells) {
    const double n = points_of(cell), fit = median_of(cell, "fit");
    const double memory = measured(cell, "memory").value_or(std::nan(""));
    const auto found = cell.timings.find("fit");
    const bool sampled = found != cell.timings.end() && !found->second.empty();
    builder.row(
        {cell.label, n, cell.message.starts_with("not tried") ? "not tried" : cell.outcome,
         measured(cell, "iterations").value_or(0.0), sampled ? static_cast<double>(found->second.size()) : 0.0, fit,
         sampled ? *std::ranges::max_element(found->second) / *std::ranges::min_element(found->second) : std::nan(""),
         fit / n, median_of(cell, "jet"), memory, memory / n});
  }
  return builder.table();
}

/// Slope of y over x by least squares, with its 95 % interval.
struct Exponent {
  double value = std::nan(""), low = std::nan(""), high = std::nan("");
};

Exponent exponent_of(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  if (x.size() < 2) return {};
  const double mean_x = mean(x), mean_y = mean(y);
  double xx = 0.0, xy = 0.0, rest = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  const double slope = xy / xx;
  if (x.size() < 3) return {.value = slope};
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double off = y[i] - mean_y - slope * (x[i] - mean_x);
    rest += off * off;
  }
  const double quantile = boost::math::quantile(boost::math::students_t(n - 2.0), 0.975);
  const double half = quantile * std::sqrt(rest / (n - 2.0) / xx);
  return {slope, slope - half, slope + half};
}

store::TableRecord exponent_table(const store::ExperimentRecord& record) {
  TableBuilder builder("exponents", "Exponents of growth",
                       fmt::format("Fit time grows like (points)^exponent; least squares in logarithms over the sizes "
                                   "from {:.0f} points on, 95 % interval. The jet is the median over all sizes.",
                                   least_points));
  builder.words("scheme").counts("sizes").numbers("exponent").numbers("low").numbers("high").counts("most points");
  builder.numbers("its fit", "s").numbers("jet", "s");
  std::vector<std::string> labels;
  for (const store::CellRecord& cell : record.cells)
    if (std::ranges::find(labels, cell.label) == labels.end()) labels.push_back(cell.label);
  for (const std::string& label : labels) {
    std::vector<double> x, y, jets;
    double most = std::nan(""), its_fit = std::nan("");
    for (const store::CellRecord& cell : record.cells) {
      const double n = points_of(cell), fit = median_of(cell, "fit");
      if (cell.label != label || std::isnan(fit)) continue;
      jets.push_back(median_of(cell, "jet"));
      if (!(most >= n)) most = n, its_fit = fit;
      if (n < least_points) continue;
      x.push_back(std::log(n));
      y.push_back(std::log(fit));
    }
    const Exponent exponent = exponent_of(x, y);
    builder.row({label, static_cast<double>(x.size()), exponent.value, exponent.low, exponent.high, most, its_fit,
                 median(jets)});
  }
  return builder.table();
}

store::PanelRecord panel(std::string y, std::string y_label, bool slope) {
  return {.kind = "graph",
          .table = "scaling",
          .x = "points",
          .y = {std::move(y)},
          .series = "scheme",
          .log_x = true,
          .log_y = true,
          .slope = slope,
          .x_label = "points",
          .y_label = std::move(y_label)};
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {exponent_table(record), cell_table(record)};
  record.figures = {{.id = "scaling",
                     .title = "Time of a fit against the number of points",
                     .caption = "Medians of cold fits. The slopes in the legend are over all sizes, those of the table "
                                "of exponents from 100 points on.",
                     .panels = {panel("fit", "seconds", true)}},
                    {.id = "scaling-memory",
                     .title = "Memory against the number of points",
                     .caption = "Growth of the resident set during the first fit of that size in its process.",
                     .panels = {panel("memory", "bytes", false)}}};
}

}  // namespace

Experiment scaling_experiment() {
  return {.id = "scaling",
          .title = "Growth of time and memory",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
