// Wang 2024, Fig. 15: how far does the move of one point reach, by scheme?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/papers/pkappa-2024-wang/inputs.hpp"
#include "experiments/run/record.hpp"
#include "experiments/study/curve_marks.hpp"
#include "experiments/study/distance.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"

namespace kappabench {
namespace {

using namespace wang;
using study::Findings, study::Notes, study::Panel, study::Quantity, study::Rows, study::Table, study::Tally;

constexpr std::string_view about =
    "One point moves, and every scheme fits again: which spans (from a point to the next) change, and by how much, as "
    "in Fig. 15. Schemes are fitted from scratch. A pκ-curve depends on the order in which its points came: its "
    "promise is about editing a curve that is there (refit), and both are shown. The 3-arcs clothoids are shown with "
    "both estimates of curvature. A point at distance 1 from a span is one of its ends; spans at a distance of d or "
    "less reach from the moved point to d neighbours on each side.";

constexpr double visible = 1e-2;    ///< deviation over displacement: what an eye sees of a move
constexpr double rounding = 1e-10;  ///< deviation over the mean chord: below it nothing changed

/// A scheme and how it takes the new place of a point: by an edit of the curve that is there, or fitted again.
struct Way {
  SchemePtr scheme;
  std::string label;
  bool edit = false;

  [[nodiscard]] Uses uses(std::string work) const {
    return {.work = std::move(work),
            .schemes = {scheme},
            .metrics = {&find_metric("locality")},
            .numbers = {{"edited", edit ? 1.0 : 0.0}}};
  }
};

constexpr std::string_view conic_label = "clothoid3 curvature=conic";

std::vector<Way> ways(const Context& context) {
  std::vector<std::string> texts = context.schemes;
  if (texts.empty())
    for (const SchemeInfo& info : context.registry.list()) {
      texts.push_back(info.id);
      if (info.id == "clothoid3") texts.emplace_back("clothoid3:curvature=conic");
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

Fit after_move(const Uses& uses, const Fit& before, int point, const Vec2& by) {
  const Scheme& scheme = *uses.schemes.front();
  const Move move{point, before.input.points[static_cast<std::size_t>(point)] + by};
  return uses.numbers.at("edited") > 0.0 ? scheme.refit(before, move) : scheme.fit(apply(before.input, move));
}

/// Deviations of the spans of the curve after the move; nothing if there is no curve or other nodes.
std::optional<std::vector<double>> deviations_of(const Fit& before, const Fit& after) {
  if (!before.curve || !after.curve) return std::nullopt;
  return span_deviations(spans(*before.curve), spans(*after.curve), before.input.closed);
}

// ---- what is drawn: one move, and the spans that it changes

constexpr std::string_view shown = "blob-12";
constexpr int shown_point = 6;
constexpr double shown_move = 0.35;  ///< mean chords, outwards
constexpr std::string_view before_label = "before", kept_label = "unchanged", little_label = "changed by less than 1 %",
                           changed_label = "changed by more than 1 % of the move";

std::pair<Fit, Fit> shown_fits(const Uses& uses) {
  Fit before = uses.schemes.front()->fit(uses.drawings.front().curves.front());
  const double step = shown_move * mean_chord(before.input);
  Fit after = after_move(uses, before, shown_point, step * Vec2(1.0, 1.0).normalized());
  return {std::move(before), std::move(after)};
}

void draw_after(const Uses& uses, store::CellRecord& cell) {
  cell.curves.push_back(record_of(*uses.schemes.front(), shown_fits(uses).second, {}));
}

/// Spans of the new curve whose deviation is visible, or is not, unless the change is rounding.
template <bool Visible>
void draw_spans(const Uses& uses, store::CellRecord& cell) {
  const auto [before, after] = shown_fits(uses);
  const auto deviations = deviations_of(before, after);
  if (!deviations) return;
  const double chord = mean_chord(before.input);
  const store::CurveRecord whole = record_of(*uses.schemes.front(), after, {});
  // Spans begin at the first node of the curve: on a closed curve each node starts one.
  std::vector<double> starts = whole.node_s;
  std::ranges::sort(starts);
  for (std::size_t k = 0; k < deviations->size() && k < starts.size(); ++k) {
    const double deviation = (*deviations)[k];
    if (!(deviation > rounding * chord) || (deviation > visible * shown_move * chord) != Visible) continue;
    const double end = k + 1 < starts.size() ? starts[k + 1] : starts.front() + whole.sample_s.back();
    cell.curves.push_back(stretch_of(whole, starts[k], end));
  }
}

void add_drawn_jobs(std::vector<CellJob>& jobs, const Way& way) {
  CellJob before = fit_job(drawing(shown), way.scheme, {}, std::string(before_label));
  before.dataset = way.label;
  jobs.push_back(std::move(before));
  const auto add = [&](std::string_view label, void (*draw)(const Uses&, store::CellRecord&)) {
    Uses uses = way.uses(fmt::format("locality: {}", label));
    uses.drawings = {drawing(shown)};
    jobs.push_back({.dataset = way.label, .label = std::string(label), .uses = std::move(uses), .compute = draw});
  };
  add(kept_label, draw_after);
  add(little_label, draw_spans<false>);
  add(changed_label, draw_spans<true>);
}

// ---- what is measured

/// Random closed curves, one of each kind; every fourth point moved in two directions.
constexpr int inputs = 4, points = 24, every = 4, directions = 2, farthest = points / 2;
constexpr double measured_move = 0.05;  ///< mean chords
const study::Key moved_point{"point"}, direction{"direction"}, distance{"distance"};
const Quantity influence{"influence", "1", Method::sampled}, visible_reach{"visible reach", "spans", Method::sampled},
    reach{"reach", "spans", Method::sampled}, failed = study::count_of("failed");

/// The deviation by distance over the displacement, and how far a visible and any change reach.
void measure_move(const Uses& uses, const Fit& before, int point, const Vec2& by, const std::vector<study::KeyIs>& keys,
                  Notes& notes) {
  const Fit after = study::solved(before) ? after_move(uses, before, point, by) : Fit{};
  const auto deviations = deviations_of(before, after);
  if (!deviations || !study::solved(after)) return notes.row(keys, {failed(1)});
  const auto largest = study::largest_by_distance(spans(*before.curve), *deviations, point, true, farthest);
  int seen = 0, any = 0;
  for (int d = 1; d <= farthest; ++d) {
    const double deviation = largest[static_cast<std::size_t>(d) - 1];
    if (std::isnan(deviation)) continue;
    if (deviation > visible * by.norm()) seen = d;
    if (deviation > rounding * mean_chord(before.input)) any = d;
    auto with_distance = keys;
    with_distance.push_back(distance(d));
    notes.row(with_distance, {influence(deviation / by.norm())});
  }
  notes.row(keys, {visible_reach(seen), reach(any)});
}

void measure_moves(const Uses& uses, Notes& notes) {
  for (int i = 0; i < inputs; ++i) {
    const Fit before = uses.schemes.front()->fit(random_curve(uses.seed, i, points, true));
    for (int point = 0; point < points; point += every)
      for (int k = 0; k < directions; ++k) {
        const double angle = 2.4 * (point + k);
        const Vec2 by = measured_move * mean_chord(before.input) * Vec2(std::cos(angle), std::sin(angle));
        measure_move(uses, before, point, by, {curve_number(i), moved_point(point), direction(k)}, notes);
      }
  }
}

std::string numbers_dataset(const Context& context) {
  return fmt::format("random, {} points, seed {}", points, context.seed);
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  for (const Way& way : ways(context)) {
    add_drawn_jobs(jobs, way);
    Uses uses = way.uses("reach of moves of random curves");
    uses.seed = context.seed;
    jobs.push_back(study::numbers_job<measure_moves>(std::move(uses), numbers_dataset(context), way.label));
  }
  return jobs;
}

// ---- what follows

Rows rows_of(const Findings& found, std::string_view label) { return found.rows().where({study::key::label(label)}); }

/// The ways that were measured, as they are labelled.
std::vector<std::string> measured_ways(const Findings& found) {
  std::vector<std::string> labels;
  for (const store::CellRecord& cell : found.cells())
    if (cell.dataset == numbers_dataset(found.context())) labels.push_back(cell.label);
  return labels;
}

Table influence_table(const Findings& found) {
  Table table("influence", "Influence of a point by distance",
              fmt::format("Deviation of the spans at a distance over the displacement ({} mean chords): median "
                          "and largest over moves of single points of random closed curves of {} points.",
                          measured_move, points));
  table.words("scheme").counts("distance").numbers("median").numbers("largest");
  for (const std::string& label : measured_ways(found)) {
    if (label == conic_label) continue;  // the twelve colours are for schemes
    for (int d = 1; d <= farthest; ++d)
      if (const Rows own = rows_of(found, label).where({distance(d)}); !own.empty())
        table.row({label, d, own.median(influence), own.largest(influence)});
  }
  return table;
}

Table reach_table(const Findings& found) {
  Table table(
      "reach", "How far a move reaches",
      fmt::format(
          "Spans on one side of the moved point, which are neighbours on one side. Visible: deviation above 1 % "
          "of the displacement. Any: above {:g} mean chords. {} is the farthest there can be.",
          rounding, farthest));
  table.words("scheme").counts("moves").counts("failed");
  table.numbers("visible, median").counts("visible, most").numbers("any, median").counts("any, most");
  for (const std::string& label : measured_ways(found)) {
    const Rows own = rows_of(found, label);
    const double lost = own.total(failed), moves = static_cast<double>(own.values(reach).size()) + lost;
    table.row({label, moves, lost, own.median(visible_reach), own.largest(visible_reach), own.median(reach),
               own.largest(reach)});
  }
  return table;
}

/// Reaches that are not within what is printed count against it.
void claim_kappa(Findings& found) {
  constexpr int printed = 3;
  const Rows own = rows_of(found, "kappa");
  Tally far;
  for (const double d : own.values(visible_reach)) far.add(d >= printed);
  found.judge(
      "kappa-reaches-six", far,
      {fmt::format("at least {} neighbours on each side in {} moves", printed, far.words()),
       fmt::format("Random closed curves of {} points; a change is visible above 1 % of the displacement. "
                   "Visible reach: median {:.3g}, most {:.0f} neighbours on each side; any change above rounding: "
                   "median {:.3g}, most {:.0f}.",
                   points, own.median(visible_reach), own.largest(visible_reach), own.median(reach),
                   own.largest(reach))});
}

/// At most `printed` neighbours on each side, and that many in some move.
struct Reach {
  std::string_view label;
  int printed;
};

void claim_local(Findings& found, std::string_view id, std::initializer_list<Reach> reaches) {
  Tally within;
  std::vector<std::string> ours;
  for (const auto& [label, printed] : reaches) {
    const Rows own = rows_of(found, label);
    for (const double d : own.values(reach)) within.add(d <= printed);
    if (!own.values(reach).empty()) within.add(own.largest(reach) >= printed);
    if (!own.values(reach).empty()) ours.push_back(fmt::format("{}: {:.0f} on each side", label, own.largest(reach)));
  }
  found.judge(id, within,
              {fmt::format("{}", fmt::join(ours, "; ")),
               "Most neighbours that a change above rounding reaches in moves of single points of random closed "
               "curves; that the printed number is reached in some move is one more case."});
}

store::FigureRecord shown_figure(const Findings& found) {
  store::FigureRecord figure{.id = "pkappa-locality",
                             .title = "Moving one point",
                             .caption = fmt::format("The upper right point of {} moved outwards by {} mean chords. Two "
                                                    "colours for the spans that change: by more than 1 % of the move, "
                                                    "and by less but more than rounding. Stand-in for Fig. 15.",
                                                    shown, shown_move),
                             .columns = 4,
                             .panels = {}};
  for (const int first : found.labelled(before_label)) {
    const std::string& way = found.cell(first).dataset;
    std::vector<int> cells;
    for (const std::string_view label : {before_label, kept_label, little_label, changed_label})
      if (const auto cell = found.find(way, label); cell && !found.cell(*cell).curves.empty()) cells.push_back(*cell);
    figure.panels.push_back(Panel::curves(std::move(cells), way).without_joints());
  }
  return figure;
}

store::FigureRecord decay_figure() {
  const auto over_moves = [](const std::string& column) {
    return Panel::graph("influence", "distance", {column}, column + " over moves")
        .series("scheme")
        .labels("distance in spans", "deviation / displacement")
        .log_y();
  };
  return {.id = "pkappa-locality-decay",
          .title = "Influence by distance",
          .caption =
              "Median and largest deviation over the displacement against the distance of the span "
              "from the moved point. What is near 1e-14 is rounding; spans that stay the same bit "
              "for bit cannot be shown on a logarithmic scale.",
          .columns = 2,
          .panels = {over_moves("median"), over_moves("largest")}};
}

void conclude(Findings& found) {
  found.add(reach_table(found));
  found.add(influence_table(found));
  found.add(shown_figure(found));
  found.add(decay_figure());
  claim_kappa(found);
  claim_local(found, "yuksel-reaches-five", {{"yuksel", 2}});
  claim_local(found, "clothoid3-reaches-six-or-eight", {{"clothoid3", 4}, {conic_label, 3}});
}

}  // namespace

Experiment pkappa_locality_experiment() {
  return study::experiment({.id = "pkappa-locality",
                            .title = "Locality of all schemes (Wang 2024, Fig. 15)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"kappa-reaches-six", "yuksel-reaches-five", "clothoid3-reaches-six-or-eight"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
