#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "datasets/random_source.hpp"
#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/study/summaries.hpp"
#include "metrics/correspondence.hpp"

namespace kappabench {

using namespace wang;

namespace {

constexpr std::string_view about =
    "Does the order of insertion show? Random open curves are fitted forwards and backwards, and mirrored; random "
    "points that are symmetric about an axis are fitted, and the curve is compared with its own mirror image. Window "
    "by window (mode=local, after stage 1 and after stage 2) against the whole curve at once (mode=global). Deviations "
    "are the largest distance of corresponding points over the mean chord.";

struct Mode {
  std::string_view words, options;
};
constexpr std::array<Mode, 3> modes{
    {{"local, stage 1", "stage2_iterations=0"}, {"local", ""}, {"global", "mode=global"}}};
constexpr std::size_t local = 1, global = 2;
constexpr std::array<std::string_view, 4> questions{"reversed", "mirrored", "symmetric, open", "symmetric, closed"};

constexpr int version = 1, points = 9, curves = 16, shown = 1;
/// Beyond rounding and the optimiser's tolerance, and enough to see: a thousandth of a chord.
constexpr double visible = 1e-3;
constexpr std::string_view shown_order = "row-open-7";
constexpr std::string_view forwards = "forwards", backwards = "backwards";

Input reversed_input(Input input) {
  std::ranges::reverse(input.points);
  return input;
}

Input mirrored_input(Input input) {
  for (Vec2& point : input.points) point.x() = -point.x();
  return input;
}

/// Points that the reflection x -> -x turns into themselves in reverse order.
Input symmetric_input(std::uint64_t seed, int index, bool closed) {
  RandomSource random(1000 * seed + static_cast<std::uint64_t>(index));
  constexpr int half = points / 2;
  std::array<Vec2, half> right;
  double along = 0.0;
  for (int k = 0; k < half; ++k) {
    if (closed) {
      const double angle = (k + 1 + random.uniform(-0.2, 0.2)) * 2.0 * std::numbers::pi / points;
      const double radius = 1.4 + random.uniform(-0.4, 0.4);
      right[static_cast<std::size_t>(k)] = radius * Vec2(std::sin(angle), std::cos(angle));
    } else {
      along += random.uniform(0.6, 1.4);
      right[static_cast<std::size_t>(k)] = {along, random.uniform(-0.8, 0.8)};
    }
  }
  Input input{.points = {}, .closed = closed, .options = {}, .ids = {}};
  for (int k = half; k-- > 0;)
    input.points.emplace_back(-right[static_cast<std::size_t>(k)].x(), right[static_cast<std::size_t>(k)].y());
  input.points.emplace_back(0.0, closed ? 1.4 : random.uniform(-0.8, 0.8));
  for (const Vec2& point : right) input.points.push_back(point);
  return input;
}

/// The spans of a curve run backwards, with the points counted from the other end.
std::vector<Span> backwards_spans(const Curve& curve, int n) {
  std::vector<Span> all = reversed(spans(curve));
  for (Span& span : all) {
    if (span.from != no_point) span.from = n - 1 - span.from;
    if (span.to != no_point) span.to = n - 1 - span.to;
  }
  return all;
}

std::vector<Span> mirrored(std::vector<Span> all) {
  for (Span& span : all)
    for (Vec2& sample : span.samples) sample.x() = -sample.x();
  return all;
}

/// The deviation that answers a question for input number `index`; NaN where a fit is not solved.
double answer(const Scheme& scheme, std::size_t question, std::uint64_t seed, int index) {
  const bool symmetric = question >= 2, closed = question == 3;
  const Input input = symmetric ? symmetric_input(seed, index, closed) : random_curve(seed, index, points, closed);
  const Fit fit = scheme.fit(input);
  if (!study::solved(fit)) return std::nan("");
  const std::vector<Span> own = spans(*fit.curve);
  const double chord = mean_chord(input);
  if (symmetric) return deviation(own, mirrored(backwards_spans(*fit.curve, points)), closed) / chord;
  const Fit other = scheme.fit(question == 0 ? reversed_input(input) : mirrored_input(input));
  if (!study::solved(other)) return std::nan("");
  const auto theirs = question == 0 ? backwards_spans(*other.curve, points) : mirrored(spans(*other.curve));
  return deviation(own, theirs, closed) / chord;
}

Drawing as_drawing(std::string id, Input input) {
  Drawing drawing{.id = std::move(id)};
  drawing.curves = {std::move(input)};
  return drawing;
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const std::uint64_t seed = context.seed;
  const Input input = drawing(shown_order).curves.front();
  for (const Mode& mode : {modes[local], modes[global]}) {
    const SchemePtr scheme = pkappa(context.registry, mode.options);
    const auto draw = [&](std::string_view what, Input of, std::string_view label) {
      jobs.push_back(fit_job(as_drawing(fmt::format("{}, {}", what, mode.words), std::move(of)), scheme, {}));
      jobs.back().label = label;
    };
    draw("order", input, forwards);
    draw("order", reversed_input(input), backwards);
    draw("symmetric", symmetric_input(seed, shown, false), mode.words);
  }
  for (const Mode& mode : modes) {
    const SchemePtr scheme = pkappa(context.registry, mode.options);
    jobs.push_back(sweep_job(
        fmt::format("random, {} points, seed {}", points, seed), scheme, fmt::format("numbers: {}", mode.words),
        version, curves, [scheme, seed](int index, store::CellRecord& cell) {
          for (std::size_t q = 0; q < questions.size(); ++q)
            study::put(cell, std::string(questions[q]), answer(*scheme, q, seed, index), Method::sampled);
        }));
  }
  return jobs;
}

std::vector<double> answers(const store::ExperimentRecord& record, std::size_t mode, std::string_view question) {
  std::vector<double> all;
  for (const int c : cells_labelled(record, fmt::format("numbers: {}", modes[mode].words)))
    for (const store::MeasurementRecord& m : record.cells[static_cast<std::size_t>(c)].measurements)
      if (m.column == question) all.push_back(m.value);
  return all;
}

Tally beyond(const std::vector<double>& values, double limit) {
  Tally tally;
  for (const double v : values)
    if (!std::isnan(v)) tally.add(v > limit);
  return tally;
}

store::TableRecord table(const store::ExperimentRecord& record) {
  TableBuilder builder("deviations", "Order and symmetry",
                       fmt::format("{} random curves of {} points for each row, C2. Largest distance of corresponding "
                                   "points over the mean chord; visible: above {:g}.",
                                   curves, points, visible));
  builder.words("question").words("mode").counts("curves").counts("visible").numbers("median").numbers("largest");
  for (const std::string_view question : questions)
    for (std::size_t m = 0; m < modes.size(); ++m)
      if (const auto values = answers(record, m, question); !values.empty()) {
        const Tally tally = beyond(values, visible);
        builder.row({std::string(question), std::string(modes[m].words), tally.cases, tally.agree, median(values),
                     largest(values)});
      }
  return builder.table();
}

store::ClaimRecord limitation_claim(const store::ExperimentRecord& record) {
  Tally all;
  std::vector<double> values;
  for (const std::size_t q : {2UL, 3UL})
    for (const double v : answers(record, local, questions[q])) {
      if (std::isnan(v)) continue;
      all.add(v > visible);
      values.push_back(v);
    }
  return claim("symmetry-not-ensured",
               all.cases == 0.0  ? "not reproduced"
               : all.agree > 0.0 ? "reproduced"
                                 : "contradicted",
               fmt::format("asymmetric by more than {:g} chords on {}; median {:.2g}, largest {:.2g}", visible,
                           study::share(all.agree, all.cases), median(values), largest(values)),
               "Symmetric random points, open and closed, window by window; the curve against its mirror image.");
}

store::ClaimRecord global_claim(const store::ExperimentRecord& record) {
  Tally better;
  std::vector<double> ours;
  for (const std::string_view question : {questions[0], questions[2], questions[3]}) {
    const auto by_windows = answers(record, local, question), at_once = answers(record, global, question);
    for (std::size_t i = 0; i < std::min(by_windows.size(), at_once.size()); ++i) {
      if (std::isnan(by_windows[i]) || std::isnan(at_once[i])) continue;
      better.add(at_once[i] < by_windows[i]);
      ours.push_back(at_once[i]);
    }
  }
  return claim("global-may-improve", study::verdict_in_general(better.agree, better.cases),
               fmt::format("less asymmetry, or less effect of reversal, on {}; median {:.2g}, largest {:.2g} chords",
                           study::share(better.agree, better.cases), median(ours), largest(ours)),
               "Random points forwards against backwards, and symmetric points against their mirror image: the whole "
               "curve at once against window by window.");
}

store::FigureRecord figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{.id = "pkappa-order-and-symmetry",
                             .title = "Order of insertion and symmetry",
                             .caption =
                                 "Left: the same points inserted forwards and backwards. Right: points that are "
                                 "symmetric about a vertical axis, with combs. Above window by window, below the "
                                 "whole curve at once.",
                             .columns = 2,
                             .panels = {}};
  for (const Mode& mode : {modes[local], modes[global]}) {
    const auto there = study::drawn_cell(record, fmt::format("order, {}", mode.words), forwards);
    const auto back = study::drawn_cell(record, fmt::format("order, {}", mode.words), backwards);
    const auto own = study::drawn_cell(record, fmt::format("symmetric, {}", mode.words), mode.words);
    if (!there || !back || !own) continue;
    figure.panels.push_back(curve_panel({*there, *back}, fmt::format("two orders, {}", mode.words), true));
    figure.panels.push_back(curve_panel({*own}, fmt::format("symmetric points, {}", mode.words), true));
  }
  return figure;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {table(record)};
  record.claims = {limitation_claim(record), global_claim(record)};
  if (auto drawn = figure(record); !drawn.panels.empty()) record.figures = {std::move(drawn)};
}

}  // namespace

Experiment pkappa_order_and_symmetry_experiment() {
  return {.id = "pkappa-order-and-symmetry",
          .title = "Order of insertion and symmetry (Wang 2024, Section 7)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
