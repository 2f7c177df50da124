// How time and memory of a fit grow with the number of points.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "datasets/datasets.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/selection.hpp"
#include "experiments/study/timing.hpp"
#include "schemes/api/frame.hpp"
#include "schemes/api/soundness.hpp"
#include "schemes/api/timed_outside.hpp"
#include "schemes/api/warnings.hpp"

namespace kappabench {
namespace {

using study::Findings, study::Notes, study::Panel, study::Quantity, study::Table;

constexpr std::string_view about =
    "Every scheme with its default parameters on closed random stars of growing size: processor time of a cold fit, "
    "time of an evaluated jet (position and two derivatives), the part of a fit in which the framework holds the curve "
    "against its claims and looks for wild spans, and by how much the resident set of the cell's own "
    "process grew during the fit. The exponent of growth is the slope of a least-squares line through the logarithms "
    "of the medians from 100 points on, with its 95 % interval (Student's t). Raw samples are in the results file. A "
    "size is not tried when the fit of a tenth of the points says that it would take more than two seconds; sizes "
    "that a plan names are always tried (experiments/plans/scaling-full.toml goes to a million). Run with -j 1 on an "
    "idle machine for clean numbers: two cells at a time share caches and memory.";

// ---- what is measured

const Quantity points = study::count_of("points"), iterations = study::count_of("iterations");
const Quantity memory{"memory", "B", Method::sampled};

constexpr double longest_expected = 2.0;  ///< seconds a default fit may be expected to take
constexpr double longest_repeated = 0.5;  ///< seconds of a fit that is timed more than once
constexpr double cell_budget = 0.12;      ///< seconds of samples a cell, more if one fit takes more
constexpr double least_points = 100.0;    ///< from where growth is fitted

double points_in(const Drawing& drawing) {
  std::size_t count = 0;
  for (const Input& input : drawing.curves) count += input.points.size();
  return static_cast<double>(count);
}

/// Fits of all curves of a drawing.
struct Fits {
  std::vector<Fit> fits;
  double seconds = 0.0;
};

Fits fit_all(const Scheme& scheme, const Drawing& drawing) {
  Fits result;
  for (const Input& input : drawing.curves) {
    const double start = processor_seconds();
    result.fits.push_back(scheme.fit(input));
    const Report& report = result.fits.back().report;
    result.seconds += is_timed_outside(report) ? report.seconds : processor_seconds() - start;
  }
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

/// What Scheme::fit does besides the scheme's own work: frame, soundness, warnings.
void check_all(const Fits& fits) {
  for (const Fit& fit : fits.fits) {
    if (!fit.curve || !frame_of(fit.input).is_identity()) continue;
    (void)unsoundness(*fit.curve, fit.input);
    (void)warnings_of(*fit.curve);
  }
}

/// What the first fit says; an unsolved curve is no obstacle to timing. The most iterations.
int report(store::CellRecord& cell, const Fits& first) {
  int most = 0;
  for (const Fit& fit : first.fits) {
    most = std::max(most, fit.report.iterations);
    if (fit.report.outcome == Outcome::converged) continue;
    cell.outcome = name(fit.report.outcome);
    cell.message = fit.report.message;
  }
  return most;
}

/// The drawings: the one that is timed, a small one, and perhaps one of a tenth of the points.
void measure(const Uses& uses, Notes& notes) {
  const Scheme& scheme = *uses.schemes.front();
  const Drawing &drawing = uses.drawings.at(0), &small = uses.drawings.at(1);
  store::CellRecord& cell = notes.cell();
  notes.put(points(points_in(drawing)));
  if (uses.drawings.size() > 2) {
    const double expected = 10.0 * fit_all(scheme, uses.drawings[2]).seconds;
    if (expected > longest_expected) {
      cell.outcome = name(Outcome::not_converged);
      cell.message = fmt::format("not tried: a tenth of the points says that it takes {:.2g} s or more", expected);
      return;
    }
  }
  (void)fit_all(scheme, small);  // pages that any fit touches
  const double resident = peak_resident_bytes();
  const Fits first = fit_all(scheme, drawing);
  const double grown = peak_resident_bytes() - resident;
  notes.row({}, {memory(grown), iterations(report(cell, first))});
  if (std::ranges::none_of(first.fits, [](const Fit& fit) { return fit.curve.has_value(); })) return;
  const int repetitions = std::clamp(static_cast<int>(cell_budget / std::max(first.seconds, 1e-6)), 3, 10);
  if (first.seconds > longest_repeated) {
    cell.timings["fit"] = {first.seconds};  // too long to be taken again: the one sample there is
  } else if (is_timed_outside(first.fits.front().report)) {
    if (cell.message.empty()) cell.message = "fits are timed by another process, in wall time";
    for (int i = 0; i < repetitions; ++i) cell.timings["fit"].push_back(fit_all(scheme, drawing).seconds);
  } else {
    const TimedWork work{"fit", [&] { (void)fit_all(scheme, drawing); }};
    cell.timings = time_all(std::span(&work, 1), {.repetitions = repetitions, .least_seconds = cell_budget / 10.0});
  }
  JetWork jets(first);
  const std::array works{TimedWork{"jet", [&jets] { jets.run(); }}, TimedWork{"check", [&first] { check_all(first); }}};
  auto samples = time_all(works, {.repetitions = 5, .least_seconds = 0.002});
  for (double& seconds : samples["jet"]) seconds /= jets.count();
  cell.timings.merge(samples);
}

Drawing star(int n) { return open_drawings(fmt::format("random:star:n={},seed=1,closed=true", n)).front(); }

std::vector<CellJob> jobs(const Context& context) {
  const std::vector<SchemePtr> schemes = study::schemes_of(context);
  const Drawing small = star(10);
  std::vector<CellJob> jobs;
  const auto add = [&](std::vector<Drawing> drawings) {
    for (const SchemePtr& scheme : schemes)
      jobs.push_back(
          study::numbers_job<measure>({.work = "scaling", .version = 2, .schemes = {scheme}, .drawings = drawings},
                                      drawings.front().id, label_of(*scheme)));
  };
  for (const std::string& dataset : context.datasets)
    for (const Drawing& drawing : open_drawings(dataset)) add({drawing, small});
  if (!context.datasets.empty()) return jobs;
  for (const int n : {10, 32, 100, 320, 1000, 3200, 10000})
    n < 100 ? add({star(n), small}) : add({star(n), small, star(n / 10)});
  return jobs;
}

// ---- what follows

/// A finished cell; what it does not have is NaN.
struct Timed {
  std::string label, outcome;
  double points, iterations, memory;
  std::vector<double> fits;
  double fit, jet, check;  ///< medians
};

std::vector<Timed> timed(const Findings& found) {
  std::vector<Timed> all;
  for (const store::CellRecord& cell : found.cells()) {
    const study::Rows rows({cell});
    const auto samples = [&](const char* work) {
      const auto known = cell.timings.find(work);
      return known == cell.timings.end() ? std::vector<double>{} : known->second;
    };
    const std::vector<double> fits = samples("fit");
    all.push_back({.label = cell.label,
                   .outcome = cell.message.starts_with("not tried") ? "not tried" : cell.outcome,
                   .points = rows.largest(points),
                   .iterations = rows.total(iterations),
                   .memory = rows.largest(memory),
                   .fits = fits,
                   .fit = median(fits),
                   .jet = median(samples("jet")),
                   .check = median(samples("check"))});
  }
  return all;
}

Table cell_table(const std::vector<Timed>& cells) {
  Table table("scaling", "Time and memory against the number of points",
              "Medians over the samples of each cell; spread: quotient of the largest and least sample.");
  table.words("scheme").counts("points").words("outcome").counts("iterations").counts("samples");
  table.numbers("fit", "s").numbers("spread").numbers("fit a point", "s").numbers("jet", "s");
  table.numbers("check over fit").numbers("memory", "B").numbers("memory a point", "B");
  for (const Timed& c : cells) {
    const double spread = c.fits.empty() ? undefined : std::ranges::max(c.fits) / std::ranges::min(c.fits);
    table.row({c.label, c.points, c.outcome, c.iterations, c.fits.size(), c.fit, spread, c.fit / c.points, c.jet,
               c.check / c.fit, c.memory, c.memory / c.points});
  }
  return table;
}

/// Slope of y over x by least squares, with its 95 % interval.
struct Exponent {
  double value = undefined, low = undefined, high = undefined;
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

Table exponent_table(const std::vector<Timed>& cells) {
  Table table("exponents", "Exponents of growth",
              fmt::format("Fit time grows like (points)^exponent; least squares in logarithms over the sizes from "
                          "{:.0f} points on, 95 % interval. The jet is the median over all sizes.",
                          least_points));
  table.words("scheme").counts("sizes").numbers("exponent").numbers("low").numbers("high").counts("most points");
  table.numbers("its fit", "s").numbers("jet", "s");
  std::vector<std::string> labels;
  for (const Timed& c : cells)
    if (std::ranges::find(labels, c.label) == labels.end()) labels.push_back(c.label);
  for (const std::string& label : labels) {
    std::vector<double> x, y, jets;
    const Timed* largest = nullptr;
    for (const Timed& c : cells) {
      if (c.label != label || std::isnan(c.fit)) continue;
      jets.push_back(c.jet);
      if (largest == nullptr || c.points > largest->points) largest = &c;
      if (c.points < least_points) continue;
      x.push_back(std::log(c.points));
      y.push_back(std::log(c.fit));
    }
    const Exponent exponent = exponent_of(x, y);
    table.row({label, x.size(), exponent.value, exponent.low, exponent.high, largest ? largest->points : undefined,
               largest ? largest->fit : undefined, median(jets)});
  }
  return table;
}

Panel growth(std::string of, std::string axis) {
  return Panel::graph("scaling", "points", {std::move(of)}, "")
      .labels("points", std::move(axis))
      .series("scheme")
      .log_x()
      .log_y();
}

void conclude(Findings& found) {
  const std::vector<Timed> cells = timed(found);
  found.add(exponent_table(cells));
  found.add(cell_table(cells));
  found.add({.id = "scaling",
             .title = "Time of a fit against the number of points",
             .caption = "Medians of cold fits. The slopes in the legend are over all sizes, those of the table of "
                        "exponents from 100 points on.",
             .panels = {growth("fit", "seconds").slope()}});
  found.add({.id = "scaling-memory",
             .title = "Memory against the number of points",
             .caption = "Growth of the resident set during the first fit of that size in its process.",
             .panels = {growth("memory", "bytes")}});
}

}  // namespace

Experiment scaling_experiment() {
  return study::experiment({.id = "scaling",
                            .title = "Growth of time and memory",
                            .about = std::string(about),
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
