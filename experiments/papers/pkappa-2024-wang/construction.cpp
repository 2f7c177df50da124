#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/run/record.hpp"
#include "experiments/study/summaries.hpp"

namespace kappabench {

using namespace wang;

namespace {

constexpr std::string_view about =
    "What changes when a point is appended, when the curve is closed and when a point is moved. Segments are compared "
    "bit for bit with those before, and the changed ones are drawn in another colour (G2 curves). The same is counted "
    "on random curves, with windows made robust (mode=local, which widens a window where no good solution is found) "
    "and as printed (mode=paper).";

constexpr int version = 1, curves = 10, points = 10;
constexpr std::string_view initial = "before", kept = "unchanged", changed = "changed";

/// How segments of a new curve match those of the old one: old index for each new segment, or nothing for a new one.
using Match = std::function<std::optional<int>(int)>;

std::vector<int> changed_segments(const Curve& before, const Curve& after, const Match& match) {
  std::vector<int> found;
  for (int i = 0; i < after.size(); ++i) {
    const auto old = match(i);
    const bool there = old && *old >= 0 && *old < before.size();
    if (!there || !same(before.segment(*old), after.segment(i))) found.push_back(i);
  }
  return found;
}

/// The fit reduced to one segment and its point, to draw it in its own colour.
Fit only(const Fit& fit, int segment) {
  const auto node = std::ranges::find_if(
      fit.curve->nodes(), [segment](const Node& n) { return n.segment == segment && n.t > 0.0 && n.t < 1.0; });
  Fit part{.input = {.points = {fit.input.points[static_cast<std::size_t>(node->point)]},
                     .closed = false,
                     .options = {},
                     .ids = {}},
           .curve = Curve({fit.curve->segments()[static_cast<std::size_t>(segment)]}, {},
                          {{.point = 0, .segment = 0, .t = node->t}}, false),
           .report = fit.report};
  return part;
}

/// What one panel shows.
struct Step {
  std::string_view title, dataset;
  std::function<std::pair<Fit, Fit>(const Scheme&)> fits;  ///< before, after
  Match match;
};

Input open_input(std::string_view id) {
  Input input = drawing(id).curves.front();
  input.closed = false;
  return input;
}

Edit move_by(const Input& input, int point, const Vec2& by) {
  return Move{point, input.points[static_cast<std::size_t>(point)] + mean_chord(input) * by};
}

std::pair<Fit, Fit> moved(const Scheme& scheme, int point, const Vec2& by) {
  Fit before = scheme.fit(open_input("construction-open"));
  Fit after = scheme.refit(before, move_by(before.input, point, by));
  return {std::move(before), std::move(after)};
}

const std::vector<Step>& steps() {
  const Match same_place = [](int i) { return std::optional(i); };
  static const std::vector<Step> all{{"a point is appended", "construction-open",
                                      [](const Scheme& scheme) {
                                        const Input input = open_input("construction-open");
                                        Input fewer = input;
                                        fewer.points.pop_back();
                                        return std::pair(scheme.fit(fewer), scheme.fit(input));
                                      },
                                      same_place},
                                     {"the curve is closed", "construction-closed",
                                      [](const Scheme& scheme) {
                                        const Input input = drawing("construction-closed").curves.front();
                                        return std::pair(scheme.fit(open_input("construction-closed")),
                                                         scheme.fit(input));
                                      },
                                      // Segment i passes point i if closed, point i + 1 if open.
                                      [](int i) { return i == 0 ? std::nullopt : std::optional(i - 1); }},
                                     {"the second point moves", "construction-open",
                                      [](const Scheme& scheme) {
                                        return moved(scheme, 1, {-0.25, 0.35});
                                      },
                                      same_place},
                                     {"an inner point moves", "construction-open",
                                      [](const Scheme& scheme) {
                                        return moved(scheme, 3, {0.35, 0.3});
                                      },
                                      same_place}};
  return all;
}

std::vector<CellJob> step_jobs(const Registry& registry) {
  std::vector<CellJob> jobs;
  // G2: closing a C2 curve leaves so little freedom that a loop may come of it.
  const SchemePtr scheme = pkappa(registry, "continuity=g2");
  for (std::size_t k = 0; k < steps().size(); ++k) {
    const auto job = [&](std::string_view label, auto fill) {
      jobs.push_back(other_job(fmt::format("{}: {}", steps()[k].dataset, steps()[k].title), scheme,
                               fmt::format("construction {} {}", version, label), fill));
      jobs.back().label = label;
    };
    const auto draw_old = [scheme, k](store::CellRecord& cell) {
      cell.curves.push_back(record_of(*scheme, steps()[k].fits(*scheme).first, {}));
    };
    const auto draw_whole = [scheme, k](store::CellRecord& cell) {
      cell.curves.push_back(record_of(*scheme, steps()[k].fits(*scheme).second, {}));
    };
    const auto draw_changed = [scheme, k](store::CellRecord& cell) {
      const auto [before, after] = steps()[k].fits(*scheme);
      for (const int segment : changed_segments(*before.curve, *after.curve, steps()[k].match))
        cell.curves.push_back(record_of(*scheme, only(after, segment), {}));
    };
    job(initial, draw_old);
    job(kept, draw_whole);
    job(changed, draw_changed);
  }
  return jobs;
}

/// Appends the points of a random curve one by one and counts the segments that change.
void count_insertions(const Scheme& scheme, const Input& input, store::CellRecord& cell) {
  std::optional<Fit> before;
  for (int n = 5; n <= input.size(); ++n) {
    Input part = input;
    part.points.resize(static_cast<std::size_t>(n));
    Fit fit = scheme.fit(part);
    if (before && study::solved(*before) && study::solved(fit)) {
      const auto found = changed_segments(*before->curve, *fit.curve, [](int i) { return std::optional(i); });
      study::put(cell, "changed by an insertion", static_cast<double>(found.size()));
    }
    before = std::move(fit);
  }
}

void count_closing(const Scheme& scheme, Input input, store::CellRecord& cell) {
  const Fit open = scheme.fit(input);
  input.closed = true;
  const Fit closed = scheme.fit(input);
  if (!study::solved(open) || !study::solved(closed)) return;
  const auto found =
      changed_segments(*open.curve, *closed.curve, [](int i) { return i == 0 ? std::nullopt : std::optional(i - 1); });
  study::put(cell, "changed by closing", static_cast<double>(found.size()));
}

/// Moves every point in turn by a fifth of the mean chord.
void count_moves(const Scheme& scheme, const Input& input, store::CellRecord& cell) {
  const Fit fit = scheme.fit(input);
  if (!study::solved(fit)) return;
  const int n = input.size();
  for (int i = 0; i < n; ++i) {
    const double angle = 2.4 * i;
    const Fit edited = scheme.refit(fit, move_by(input, i, 0.2 * Vec2(std::cos(angle), std::sin(angle))));
    if (!edited.curve) continue;
    const auto found = changed_segments(*fit.curve, *edited.curve, [](int k) { return std::optional(k); });
    const bool near_end = !input.closed && (i < 2 || i >= n - 2);
    study::put(cell, near_end ? "changed by moving near an end" : "changed by moving",
               static_cast<double>(found.size()));
  }
}

std::string_view mode_words(std::string_view mode) { return mode == "paper" ? "as printed" : "robust"; }

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs = step_jobs(context.registry);
  const std::uint64_t seed = context.seed;
  for (const std::string_view mode : {"local", "paper"}) {
    const SchemePtr scheme = pkappa(context.registry, fmt::format("mode={}", mode));
    jobs.push_back(sweep_job(fmt::format("random, {} points, seed {}", points, seed), scheme, mode_words(mode), version,
                             curves, [scheme, seed](int index, store::CellRecord& cell) {
                               const Input open = random_curve(seed, index, points, false);
                               count_insertions(*scheme, open, cell);
                               count_closing(*scheme, open, cell);
                               count_moves(*scheme, open, cell);
                               Input closed = random_curve(seed, index, points, true);
                               count_moves(*scheme, closed, cell);
                             }));
  }
  return jobs;
}

struct What {
  std::string_view column, words;
  double bound;
};
/// A closing appends the first point (three segments) and inserts one between the ends (three, one in common).
constexpr std::array<What, 4> whats{{{"changed by an insertion", "a point appended", 3},
                                     {"changed by closing", "the curve closed", 5},
                                     {"changed by moving", "a point moved", 3},
                                     {"changed by moving near an end", "one of the two at an open end moved", 2}}};

std::vector<double> counts_of(const store::ExperimentRecord& record, std::string_view mode, const What& what) {
  std::vector<double> all;
  for (const int c : cells_labelled(record, mode_words(mode)))
    for (const store::MeasurementRecord& m : record.cells[static_cast<std::size_t>(c)].measurements)
      if (m.column == what.column) all.push_back(m.value);
  return all;
}

double above(const std::vector<double>& counts, const What& what) {
  return static_cast<double>(std::ranges::count_if(counts, [&what](double n) { return n > what.bound; }));
}

store::TableRecord table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "changes", "Segments that change",
      fmt::format("{} random C2 curves of {} points, open and closed; segments compared bit for bit. The "
                  "bound is what the windows of Section 5.1 allow: a closing appends the first point, "
                  "then solves for three segments around it.",
                  curves, points));
  builder.words("edit").words("windows").counts("edits").counts("most").counts("bound").counts("above");
  for (const What& what : whats)
    for (const std::string_view mode : {"local", "paper"})
      if (const auto counts = counts_of(record, mode, what); !counts.empty())
        builder.row({std::string(what.words), std::string(mode_words(mode)), static_cast<double>(counts.size()),
                     largest(counts), what.bound, above(counts, what)});
  return builder.table();
}

/// The printed algorithm is that of mode=paper; the evidence tells of the robust one.
store::ClaimRecord count_claim(const store::ExperimentRecord& record, std::string_view id, const What& what) {
  const auto counts = counts_of(record, "paper", what), robust = counts_of(record, "local", what);
  return claim(
      id, study::verdict_for_all(above(counts, what), static_cast<double>(counts.size())),
      fmt::format("at most {:.0f} segments in {} edits", counts.empty() ? 0.0 : largest(counts), counts.size()),
      fmt::format("Windows as printed, random curves, bit for bit. With robust windows at most {:.0f}, and above "
                  "{:.0f} in {:.0f} of {} edits.",
                  robust.empty() ? 0.0 : largest(robust), what.bound, above(robust, what), robust.size()));
}

store::FigureRecord figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{.id = "pkappa-construction",
                             .title = "What an edit changes",
                             .caption =
                                 "The curve before and after each step, the segments that differ in another "
                                 "colour: a point appended, the curve closed, a point near the end and one inside "
                                 "moved. Stand-ins for Figs. 6 to 8.",
                             .columns = 4,
                             .panels = {}};
  for (const Step& step : steps()) {
    const std::string dataset = fmt::format("{}: {}", step.dataset, step.title);
    std::vector<int> cells;
    for (const std::string_view label : {initial, kept, changed})
      if (const auto cell = study::drawn_cell(record, dataset, label)) cells.push_back(*cell);
    if (cells.size() == 3) figure.panels.push_back(curve_panel(std::move(cells), std::string(step.title), false));
  }
  return figure;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {table(record)};
  record.claims = {
      count_claim(record, "insertion-changes-three", whats[0]), count_claim(record, "closing-changes-five", whats[1]),
      count_claim(record, "move-changes-three", whats[2]), count_claim(record, "move-at-end-changes-two", whats[3])};
  if (auto drawn = figure(record); !drawn.panels.empty()) record.figures = {std::move(drawn)};
}

}  // namespace

Experiment pkappa_construction_experiment() {
  return {.id = "pkappa-construction",
          .title = "Inserting, closing and moving (Wang 2024, Figs. 6 to 8)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
