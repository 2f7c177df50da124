// Wang 2024, Section 7: does the order of insertion show, and is the curve of symmetric points symmetric?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "datasets/random_source.hpp"
#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/papers/pkappa-2024-wang/inputs.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "metrics/correspondence.hpp"

namespace kappabench {
namespace {

using namespace wang;
using study::Findings, study::Notes, study::Panel, study::Rows, study::Table, study::Tally;

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
constexpr auto &local = modes[1], &global = modes[2];

// ---- what is measured

constexpr int points = 9, curves = 16;
const study::Key question{"question"};
const study::Quantity departure{"deviation", "mean chords", Method::sampled};
constexpr std::string_view backwards_question = "reversed", mirror_question = "mirrored",
                           open_question = "symmetric, open", closed_question = "symmetric, closed";
constexpr std::array questions{backwards_question, mirror_question, open_question, closed_question};

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
  Input right{.points = {}, .closed = closed, .options = {}, .ids = {}};
  double along = 0.0;
  for (int k = 0; k < half; ++k) {
    if (closed) {
      const double angle = (k + 1 + random.uniform(-0.2, 0.2)) * 2.0 * std::numbers::pi / points;
      const double radius = 1.4 + random.uniform(-0.4, 0.4);
      right.points.emplace_back(radius * Vec2(std::sin(angle), std::cos(angle)));
    } else {
      along += random.uniform(0.6, 1.4);
      right.points.emplace_back(along, random.uniform(-0.8, 0.8));
    }
  }
  Input input = mirrored_input(reversed_input(right));
  input.points.emplace_back(0.0, closed ? 1.4 : random.uniform(-0.8, 0.8));
  std::ranges::copy(right.points, std::back_inserter(input.points));
  return input;
}

/// The spans of a curve run backwards, with the points counted from the other end.
std::vector<Span> backwards_spans(const Curve& curve) {
  std::vector<Span> all = reversed(spans(curve));
  for (Span& span : all)
    for (int* end : {&span.from, &span.to})
      if (*end != no_point) *end = points - 1 - *end;
  return all;
}

std::vector<Span> mirrored_spans(std::vector<Span> all) {
  for (Span& span : all)
    for (Vec2& sample : span.samples) sample.x() = -sample.x();
  return all;
}

/// How far the curve through points that are symmetric is from its mirror image; NaN where it is not solved.
double asymmetry(const Scheme& scheme, const Input& input) {
  const Fit fit = scheme.fit(input);
  if (!study::solved(fit)) return undefined;
  return deviation(spans(*fit.curve), mirrored_spans(backwards_spans(*fit.curve)), input.closed) / mean_chord(input);
}

void measure_departures(const Uses& uses, Notes& notes) {
  const Scheme& scheme = *uses.schemes.front();
  for (int i = 0; i < curves; ++i) {
    const auto note = [&](std::string_view what, double value) {
      notes.row({curve_number(i), question(what)}, {departure(value)});
    };
    const Input input = random_curve(uses.seed, i, points, false);
    const Fit fit = scheme.fit(input), back = scheme.fit(reversed_input(input)),
              mirrored = scheme.fit(mirrored_input(input));
    const auto between = [&](const Fit& other, auto&& as_own) {
      if (!study::solved(fit) || !study::solved(other)) return undefined;
      return deviation(spans(*fit.curve), as_own(*other.curve), false) / mean_chord(input);
    };
    note(backwards_question, between(back, backwards_spans));
    note(mirror_question, between(mirrored, [](const Curve& curve) { return mirrored_spans(spans(curve)); }));
    note(open_question, asymmetry(scheme, symmetric_input(uses.seed, i, false)));
    note(closed_question, asymmetry(scheme, symmetric_input(uses.seed, i, true)));
  }
}

constexpr std::string_view forwards = "forwards", backwards = "backwards";

std::string order_name(const Mode& mode) { return fmt::format("order, {}", mode.words); }
std::string symmetric_name(const Mode& mode) { return fmt::format("symmetric, {}", mode.words); }

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const Input input = drawing("row-open-7").curves.front(), symmetric = symmetric_input(context.seed, 1, false);
  for (const Mode& mode : {local, global}) {
    const SchemePtr scheme = pkappa(context.registry, mode.options);
    const auto draw = [&](std::string dataset, Input of, std::string_view label) {
      jobs.push_back(fit_job(drawing_of(std::move(dataset), std::move(of)), scheme, {}, std::string(label)));
    };
    draw(order_name(mode), input, forwards);
    draw(order_name(mode), reversed_input(input), backwards);
    draw(symmetric_name(mode), symmetric, mode.words);
  }
  for (const Mode& mode : modes)
    jobs.push_back(study::numbers_job<measure_departures>(
        {.work = "order and symmetry",
         .schemes = {pkappa(context.registry, mode.options)},
         .metrics = {&find_metric("invariance")},
         .seed = context.seed},
        fmt::format("random, {} points, seed {}", points, context.seed), std::string(mode.words)));
  return jobs;
}

// ---- what follows

/// Beyond rounding and the optimiser's tolerance, and enough to see: a thousandth of a chord.
constexpr double visible = 1e-3;

Rows answers(const Rows& rows, std::string_view to, const Mode& mode) {
  return rows.where({question(to), study::key::label(mode.words)});
}

Tally visible_ones(const std::vector<double>& values) {
  Tally tally;
  for (const double v : values)
    if (!std::isnan(v)) tally.add(v > visible);
  return tally;
}

Table table(const Rows& rows) {
  Table table("deviations", "Order and symmetry",
              fmt::format("{} random curves of {} points for each row, C2. Largest distance of corresponding "
                          "points over the mean chord; visible: above {:g}.",
                          curves, points, visible));
  table.words("question").words("mode").counts("curves").counts("visible").numbers("median").numbers("largest");
  for (const std::string_view what : questions)
    for (const Mode& mode : modes)
      if (const Rows own = answers(rows, what, mode); !own.empty()) {
        const Tally seen = visible_ones(own.values(departure));
        table.row({what, mode.words, seen.cases, seen.agree, own.median(departure), own.largest(departure)});
      }
  return table;
}

void claim_limitation(Findings& found) {
  std::vector<double> values = answers(found.rows(), open_question, local).values(departure);
  std::ranges::copy(answers(found.rows(), closed_question, local).values(departure), std::back_inserter(values));
  const Tally seen = visible_ones(values);
  found.judge("symmetry-not-ensured", seen,
              {fmt::format("asymmetric by more than {:g} chords on {}; median {:.2g}, largest {:.2g}", visible,
                           seen.words(), median(values), largest(values)),
               "Symmetric random points, open and closed, window by window; the curve against its mirror image."});
}

void claim_global(Findings& found) {
  Tally better;
  std::vector<double> ours;
  for (const std::string_view what : {backwards_question, open_question, closed_question})
    for (const auto& [by_windows, at_once] :
         found.rows()
             .where({question(what)})
             .pairs(departure, study::key::label(local.words), study::key::label(global.words))) {
      if (std::isnan(by_windows) || std::isnan(at_once)) continue;
      better.add(at_once < by_windows);
      ours.push_back(at_once);
    }
  found.judge("global-may-improve", better,
              {fmt::format("less asymmetry, or less effect of reversal, on {}; median {:.2g}, largest {:.2g} chords",
                           better.words(), median(ours), largest(ours)),
               "Random points forwards against backwards, and symmetric points against their mirror image: the whole "
               "curve at once against window by window."});
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{.id = "pkappa-order-and-symmetry",
                             .title = "Order of insertion and symmetry",
                             .caption =
                                 "Left: the same points inserted forwards and backwards. Right: points that are "
                                 "symmetric about a vertical axis, with combs. Above window by window, below the "
                                 "whole curve at once.",
                             .columns = 2,
                             .panels = {}};
  for (const Mode& mode : {local, global}) {
    const auto there = found.find(order_name(mode), forwards), back = found.find(order_name(mode), backwards),
               own = found.find(symmetric_name(mode), mode.words);
    if (!there || !back || !own) continue;
    figure.panels.push_back(Panel::curves({*there, *back}, fmt::format("two orders, {}", mode.words)).comb());
    figure.panels.push_back(Panel::curves({*own}, fmt::format("symmetric points, {}", mode.words)).comb());
  }
  return figure;
}

void conclude(Findings& found) {
  found.add(table(found.rows()));
  claim_limitation(found);
  claim_global(found);
  found.add(figure(found));
}

}  // namespace

Experiment pkappa_order_and_symmetry_experiment() {
  return study::experiment({.id = "pkappa-order-and-symmetry",
                            .title = "Order of insertion and symmetry (Wang 2024, Section 7)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"symmetry-not-ensured", "global-may-improve"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
