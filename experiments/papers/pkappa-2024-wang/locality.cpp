#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/run/record.hpp"
#include "experiments/study/curve_marks.hpp"
#include "experiments/study/summaries.hpp"

namespace kappabench {

using namespace wang;

namespace {

constexpr std::string_view about =
    "One point moves, and every scheme fits again: which spans (from a point to the next) change, and by how much, as "
    "in Fig. 15. Schemes are fitted from scratch. A pκ-curve depends on the order in which its points came: its "
    "promise is about editing a curve that is there (refit), and both are shown. The 3-arcs clothoids are shown with "
    "both estimates of curvature. A point at distance 1 from a span is one of its ends; spans at a distance of d or "
    "less reach from the moved point to d neighbours on each side.";

constexpr int version = 1;
constexpr std::string_view shown = "blob-12";
constexpr int shown_point = 6;
constexpr double shown_move = 0.35;  ///< mean chords, outwards
/// Random closed curves, one of each kind; every fourth point moved in two directions.
constexpr int inputs = 4, points = 24, every = 4, directions = 2, farthest = points / 2;
constexpr double measured_move = 0.05;  ///< mean chords
constexpr double visible = 1e-2;        ///< deviation over displacement: what an eye sees of a move
constexpr double rounding = 1e-10;      ///< deviation over the mean chord: below it nothing changed

constexpr std::string_view before_label = "before", kept_label = "unchanged", little_label = "changed by less than 1 %",
                           changed_label = "changed by more than 1 % of the move";

/// A scheme and how it takes the new place of a point.
struct Way {
  SchemePtr scheme;
  std::string label;
  bool edit = false;
};

std::vector<Way> ways(const Context& context) {
  std::vector<std::string> texts = context.schemes;
  if (texts.empty()) {
    for (const SchemeInfo& info : context.registry.list()) {
      texts.push_back(info.id);
      if (info.id == "clothoid3") texts.push_back("clothoid3:curvature=conic");
    }
  }
  std::vector<Way> found;
  for (const std::string& text : texts) {
    const SchemePtr scheme = context.registry.parse(text);
    const bool path_dependent = !scheme->info().traits.refit_is_fit;
    found.push_back({scheme, label_of(*scheme) + (path_dependent ? ", fitted again" : ""), false});
    if (path_dependent) found.push_back({scheme, label_of(*scheme) + ", edited", true});
  }
  return found;
}

Fit after_move(const Way& way, const Fit& before, int point, const Vec2& by) {
  const Move move{point, before.input.points[static_cast<std::size_t>(point)] + by};
  return way.edit ? way.scheme->refit(before, move) : way.scheme->fit(apply(before.input, move));
}

/// Deviations of the spans of the curve after the move; nothing if there is no curve or other nodes.
std::optional<std::vector<double>> deviations_of(const Fit& before, const Fit& after) {
  if (!before.curve || !after.curve) return std::nullopt;
  return span_deviations(spans(*before.curve), spans(*after.curve), before.input.closed);
}

// --- the figure ---

std::pair<Fit, Fit> shown_fits(const Way& way, const Drawing& drawing) {
  Fit before = way.scheme->fit(drawing.curves.front());
  const double step = shown_move * mean_chord(before.input);
  Fit after = after_move(way, before, shown_point, step * Vec2(1.0, 1.0).normalized());
  return {std::move(before), std::move(after)};
}

/// Spans of the new curve whose deviation is in (from, to], in units of the move, unless the change is rounding.
void draw_spans(const Way& way, const Drawing& drawing, double from, double to, store::CellRecord& cell) {
  const auto [before, after] = shown_fits(way, drawing);
  const auto deviations = deviations_of(before, after);
  if (!deviations) return;
  const double chord = mean_chord(before.input), step = shown_move * chord;
  const store::CurveRecord whole = record_of(*way.scheme, after, {});
  // Spans begin at the first node of the curve: on a closed curve each node starts one.
  std::vector<double> starts = whole.node_s;
  std::ranges::sort(starts);
  for (std::size_t k = 0; k < deviations->size() && k < starts.size(); ++k) {
    const double deviation = (*deviations)[k];
    if (!(deviation > from * step && deviation <= to * step) || deviation <= rounding * chord) continue;
    const double end = k + 1 < starts.size() ? starts[k + 1] : starts.front() + whole.sample_s.back();
    cell.curves.push_back(stretch_of(whole, starts[k], end));
  }
}

void add_drawn_jobs(std::vector<CellJob>& jobs, const Way& way, const Drawing& drawing) {
  const auto job = [&](std::string_view label, std::function<void(const Drawing&, store::CellRecord&)> draw) {
    jobs.push_back(study::study_job(drawing, way.scheme, fmt::format("locality of {}: {}", way.label, label), version,
                                    std::move(draw)));
    jobs.back().label = label;
    jobs.back().dataset = way.label;
  };
  job(before_label, [way](const Drawing& d, store::CellRecord& cell) {
    cell.curves.push_back(record_of(*way.scheme, shown_fits(way, d).first, {}));
  });
  job(kept_label, [way](const Drawing& d, store::CellRecord& cell) {
    cell.curves.push_back(record_of(*way.scheme, shown_fits(way, d).second, {}));
  });
  job(little_label, [way](const Drawing& d, store::CellRecord& cell) { draw_spans(way, d, 0.0, visible, cell); });
  job(changed_label, [way](const Drawing& d, store::CellRecord& cell) { draw_spans(way, d, visible, HUGE_VAL, cell); });
}

store::FigureRecord shown_figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{.id = "pkappa-locality",
                             .title = "Moving one point",
                             .caption = fmt::format("The upper right point of {} moved outwards by {} mean chords. Two "
                                                    "colours for the spans that change: by more than 1 % of the move, "
                                                    "and by less but more than rounding. Stand-in for Fig. 15.",
                                                    shown, shown_move),
                             .columns = 4,
                             .panels = {}};
  for (std::size_t i = 0; i < record.cells.size(); ++i) {
    if (record.cells[i].label != before_label) continue;
    const std::string& way = record.cells[i].dataset;
    std::vector<int> cells;
    for (const std::string_view label : {before_label, kept_label, little_label, changed_label})
      for (std::size_t k = 0; k < record.cells.size(); ++k)
        if (record.cells[k].dataset == way && record.cells[k].label == label && !record.cells[k].curves.empty())
          cells.push_back(static_cast<int>(k));
    store::PanelRecord panel = curve_panel(std::move(cells), way, false);
    panel.joints = false;
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

// --- the numbers ---

/// One move: the deviation by distance over the displacement, and how far a visible and any change reach.
void measure_move(const Way& way, const Fit& before, int point, const Vec2& by, store::CellRecord& cell) {
  const Fit after = after_move(way, before, point, by);
  const auto deviations = deviations_of(before, after);
  if (!deviations || !study::solved(after)) {
    study::put(cell, "failed", 1.0);
    return;
  }
  const auto largest = study::largest_by_distance(spans(*before.curve), *deviations, point, true, farthest);
  const double noise = rounding * mean_chord(before.input);
  double seen = 0.0, any = 0.0;
  for (int d = 1; d <= farthest; ++d) {
    const double deviation = largest[static_cast<std::size_t>(d) - 1];
    if (std::isnan(deviation)) continue;
    if (deviation > visible * by.norm()) seen = d;
    if (deviation > noise) any = d;
    study::put(cell, fmt::format("influence {}", d), deviation / by.norm(), Method::sampled);
  }
  study::put(cell, "visible reach", seen, Method::sampled);
  study::put(cell, "reach", any, Method::sampled);
}

void measure_input(const Way& way, const Input& input, store::CellRecord& cell) {
  const Fit before = way.scheme->fit(input);
  for (int point = 0; point < input.size(); point += every)
    for (int k = 0; k < directions; ++k) {
      if (!study::solved(before)) {
        study::put(cell, "failed", 1.0);
        continue;
      }
      const double angle = 2.4 * (point + k);
      const Vec2 by = measured_move * mean_chord(input) * Vec2(std::cos(angle), std::sin(angle));
      measure_move(way, before, point, by, cell);
    }
}

std::string numbers_dataset(std::uint64_t seed) { return fmt::format("random, {} points, seed {}", points, seed); }

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const Drawing blob = drawing(shown);
  const std::uint64_t seed = context.seed;
  for (const Way& way : ways(context)) {
    add_drawn_jobs(jobs, way, blob);
    jobs.push_back(sweep_job(numbers_dataset(seed), way.scheme, way.label, version, inputs,
                             [way, seed](int index, store::CellRecord& cell) {
                               measure_input(way, random_curve(seed, index, points, true), cell);
                             }));
  }
  return jobs;
}

constexpr std::string_view conic_label = "clothoid3 curvature=conic";

/// The cells of numbers: one a way.
std::vector<const store::CellRecord*> measured_cells(const store::ExperimentRecord& record) {
  std::vector<const store::CellRecord*> cells;
  for (const store::CellRecord& cell : record.cells)
    if (cell.dataset.starts_with("random")) cells.push_back(&cell);
  return cells;
}

std::vector<double> of(const store::ExperimentRecord& record, std::string_view label, std::string_view column) {
  std::vector<double> all;
  for (const store::CellRecord* cell : measured_cells(record))
    if (cell->label == label)
      for (const store::MeasurementRecord& m : cell->measurements)
        if (m.column == column) all.push_back(m.value);
  return all;
}

store::TableRecord influence_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "influence", "Influence of a point by distance",
      fmt::format("Deviation of the spans at a distance over the displacement ({} mean chords): median "
                  "and largest over moves of single points of random closed curves of {} points.",
                  measured_move, points));
  builder.words("scheme").counts("distance").numbers("median").numbers("largest");
  for (const store::CellRecord* cell : measured_cells(record))
    for (int d = 1; d <= farthest && cell->label != conic_label; ++d)  // the twelve colours are for schemes
      if (const auto values = of(record, cell->label, fmt::format("influence {}", d)); !values.empty())
        builder.row({cell->label, static_cast<double>(d), median(values), largest(values)});
  return builder.table();
}

store::TableRecord reach_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "reach", "How far a move reaches",
      fmt::format(
          "Spans on one side of the moved point, which are neighbours on one side. Visible: deviation above 1 % "
          "of the displacement. Any: above {:g} mean chords. {} is the farthest there can be.",
          rounding, farthest));
  builder.words("scheme").counts("moves").counts("failed");
  builder.numbers("visible, median").counts("visible, most").numbers("any, median").counts("any, most");
  for (const store::CellRecord* cell : measured_cells(record)) {
    const auto seen = of(record, cell->label, "visible reach"), any = of(record, cell->label, "reach");
    const auto failed = static_cast<double>(of(record, cell->label, "failed").size());
    builder.row({cell->label, static_cast<double>(seen.size()) + failed, failed, median(seen), largest(seen),
                 median(any), largest(any)});
  }
  return builder.table();
}

/// Reaches that are not within what is printed count against it.
store::ClaimRecord kappa_claim(const store::ExperimentRecord& record) {
  constexpr int printed = 3;
  const auto seen = of(record, "kappa", "visible reach"), any = of(record, "kappa", "reach");
  const auto agree = static_cast<double>(std::ranges::count_if(seen, [](double d) { return d >= printed; }));
  const auto cases = static_cast<double>(seen.size());
  return claim(
      "kappa-reaches-six", study::verdict_in_general(agree, cases),
      fmt::format("at least {} neighbours on each side in {} moves", printed, study::share(agree, cases)),
      fmt::format("Random closed curves of {} points; a change is visible above 1 % of the displacement. "
                  "Visible reach: median {:.3g}, most {:.0f} neighbours on each side; any change above rounding: "
                  "median {:.3g}, most {:.0f}.",
                  points, median(seen), largest(seen), median(any), largest(any)));
}

/// At most `printed` neighbours on each side, and that many in some move.
struct Reach {
  std::string_view label;
  int printed;
};

store::ClaimRecord local_claim(const store::ExperimentRecord& record, std::string_view id,
                               std::initializer_list<Reach> reaches) {
  double against = 0.0, cases = 0.0;
  bool attained = true;
  std::vector<std::string> ours;
  for (const auto& [label, printed] : reaches) {
    const auto any = of(record, label, "reach");
    cases += static_cast<double>(any.size());
    against += static_cast<double>(std::ranges::count_if(any, [&](double d) { return d > printed; }));
    attained = attained && !any.empty() && largest(any) >= printed;
    if (!any.empty()) ours.push_back(fmt::format("{}: {:.0f} on each side", label, largest(any)));
  }
  std::string verdict = study::verdict_for_all(against, cases);
  if (against == 0.0 && !attained) verdict = "not reproduced";
  return claim(id, std::move(verdict), fmt::format("{}", fmt::join(ours, "; ")),
               fmt::format("Most neighbours that a change above rounding reaches in {:.0f} moves of single points of "
                           "random closed curves; {:.0f} moves reach farther than printed.",
                           cases, against));
}

store::FigureRecord decay_figure() {
  store::FigureRecord figure{.id = "pkappa-locality-decay",
                             .title = "Influence by distance",
                             .caption =
                                 "Median and largest deviation over the displacement against the distance of the span "
                                 "from the moved point. What is near 1e-14 is rounding; spans that stay the same bit "
                                 "for bit cannot be shown on a logarithmic scale.",
                             .columns = 2,
                             .panels = {}};
  for (const std::string column : {"median", "largest"}) {
    store::PanelRecord graph{.kind = "graph", .title = column + " over moves"};
    graph.table = "influence";
    graph.x = "distance";
    graph.y = {column};
    graph.series = "scheme";
    graph.log_y = true;
    graph.x_label = "distance in spans";
    graph.y_label = "deviation / displacement";
    figure.panels.push_back(std::move(graph));
  }
  return figure;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {reach_table(record), influence_table(record)};
  record.figures = {shown_figure(record), decay_figure()};
  record.claims = {kappa_claim(record), local_claim(record, "yuksel-reaches-five", {{"yuksel", 2}}),
                   local_claim(record, "clothoid3-reaches-six-or-eight", {{"clothoid3", 4}, {conic_label, 3}})};
}

}  // namespace

Experiment pkappa_locality_experiment() {
  return {.id = "pkappa-locality",
          .title = "Locality of all schemes (Wang 2024, Fig. 15)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
