// Wang 2024, Figs. 6 to 8: which segments change when a point is inserted or moved, or the curve closed?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/papers/pkappa-2024-wang/inputs.hpp"
#include "experiments/run/record.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "schemes/segments/polynomial.hpp"

namespace kappabench {
namespace {

using namespace wang;
using study::Findings, study::Notes, study::Panel, study::Rows, study::Table;

constexpr std::string_view about =
    "What changes when a point is appended, when the curve is closed and when a point is moved. Segments are compared "
    "bit for bit with those before, and the changed ones are drawn in another colour (G2 curves). The same is counted "
    "on random curves, with windows made robust (mode=local, which widens a window where no good solution is found) "
    "and as printed (mode=paper).";

bool same(const Segment& a, const Segment& b) {
  const auto points = [](const Segment& segment) {
    return dynamic_cast<const PolynomialSegment&>(segment).control_points();
  };
  return std::ranges::equal(points(a), points(b));
}

/// The segments of the new curve that the old one does not have bit for bit.
std::vector<int> changed_segments(const Fit& before, const Fit& after) {
  // Segment i passes point i if closed, point i + 1 if open.
  const int shift = after.input.closed && !before.input.closed ? 1 : 0;
  std::vector<int> found;
  for (int i = 0; i < after.curve->size(); ++i) {
    const int old = i - shift;
    const bool there = old >= 0 && old < before.curve->size();
    if (!there || !same(before.curve->segment(old), after.curve->segment(i))) found.push_back(i);
  }
  return found;
}

Move move_by(const Input& input, int point, const Vec2& by) {
  return {point, input.points[static_cast<std::size_t>(point)] + mean_chord(input) * by};
}

// ---- what is drawn: four steps, each before and after

struct Step {
  std::string title;
  Drawing before, after;
  std::optional<int> moved{};  ///< the point, if the curve is edited; otherwise `after` is fitted from scratch
};

std::vector<Step> steps() {
  const Drawing closed = drawing("construction-closed");
  Drawing open = drawing("construction-open"), fewer = open, unclosed = closed;
  for (Drawing* d : {&open, &fewer, &unclosed}) d->curves.front().closed = false;
  fewer.curves.front().points.pop_back();
  const auto moved = [&open](int point, const Vec2& by) {
    Drawing after = open;
    after.curves.front() = apply(open.curves.front(), move_by(open.curves.front(), point, by));
    return after;
  };
  return {{"a point is appended", fewer, open},
          {"the curve is closed", unclosed, closed},
          {"the second point moves", open, moved(1, {-0.25, 0.35}), 1},
          {"an inner point moves", open, moved(3, {0.35, 0.3}), 3}};
}

std::pair<Fit, Fit> fits_of(const Uses& uses) {
  const Scheme& scheme = *uses.schemes.front();
  const Input& points = uses.drawings[1].curves.front();
  Fit before = scheme.fit(uses.drawings[0].curves.front());
  const auto moved = uses.numbers.find("moved point");
  if (moved == uses.numbers.end()) return {std::move(before), scheme.fit(points)};
  const int point = static_cast<int>(moved->second);
  Fit after = scheme.refit(before, Move{point, points.points[static_cast<std::size_t>(point)]});
  return {std::move(before), std::move(after)};
}

void draw_after(const Uses& uses, store::CellRecord& cell) {
  cell.curves.push_back(record_of(*uses.schemes.front(), fits_of(uses).second, {}));
}

/// The fit reduced to one segment and its point, to draw it in its own colour.
Fit only(const Fit& fit, int segment) {
  const auto node = std::ranges::find_if(
      fit.curve->nodes(), [segment](const Node& n) { return n.segment == segment && n.t > 0.0 && n.t < 1.0; });
  return {.input = {.points = {fit.input.points[static_cast<std::size_t>(node->point)]},
                    .closed = false,
                    .options = {},
                    .ids = {}},
          .curve = Curve({fit.curve->segments()[static_cast<std::size_t>(segment)]}, {},
                         {{.point = 0, .segment = 0, .t = node->t}}, false),
          .report = fit.report};
}

void draw_changed(const Uses& uses, store::CellRecord& cell) {
  const auto [before, after] = fits_of(uses);
  for (const int segment : changed_segments(before, after))
    cell.curves.push_back(record_of(*uses.schemes.front(), only(after, segment), {}));
}

constexpr std::string_view initial = "before", kept = "unchanged", changed = "changed";

std::string dataset_of(const Step& step) { return fmt::format("{}: {}", step.before.id, step.title); }

void add_jobs(std::vector<CellJob>& jobs, const Step& step, const SchemePtr& scheme) {
  jobs.push_back(fit_job(step.before, scheme, {}, std::string(initial)));
  jobs.back().dataset = dataset_of(step);
  Uses uses{.work = "step of a construction: after", .schemes = {scheme}, .drawings = {step.before, step.after}};
  if (step.moved) uses.numbers["moved point"] = *step.moved;
  jobs.push_back({.dataset = dataset_of(step), .label = std::string(kept), .uses = uses, .compute = draw_after});
  uses.work = "step of a construction: changed segments";
  jobs.push_back({.dataset = dataset_of(step), .label = std::string(changed), .uses = uses, .compute = draw_changed});
}

// ---- what is measured

constexpr int curves = 10, points = 10;
const study::Key edit{"edit"};
const study::Quantity changed_count = study::count_of("changed segments");

struct EditKind {
  std::string_view claim, words;
  double bound;  ///< of changed segments
};
/// A closing appends the first point (three segments) and inserts one between the ends (three, one in common).
constexpr std::array<EditKind, 4> edits{{{"insertion-changes-three", "a point appended", 3},
                                         {"closing-changes-five", "the curve closed", 5},
                                         {"move-changes-three", "a point moved", 3},
                                         {"move-at-end-changes-two", "one of the two at an open end moved", 2}}};
constexpr auto &appending = edits[0], &closing = edits[1], &moving = edits[2], &moving_at_end = edits[3];

void note_change(const EditKind& what, const Fit& before, const Fit& after, Notes& notes) {
  notes.row({edit(what.words)}, {changed_count(changed_segments(before, after).size())});
}

/// Appends the points one by one.
void measure_insertions(const Scheme& scheme, const Input& input, Notes& notes) {
  std::optional<Fit> before;
  for (int n = 5; n <= input.size(); ++n) {
    Input part = input;
    part.points.resize(static_cast<std::size_t>(n));
    Fit fit = scheme.fit(part);
    if (before && study::solved(*before) && study::solved(fit)) note_change(appending, *before, fit, notes);
    before = std::move(fit);
  }
}

void measure_closing(const Scheme& scheme, const Input& open, const Input& once_closed, Notes& notes) {
  const Fit before = scheme.fit(open), after = scheme.fit(once_closed);
  if (study::solved(before) && study::solved(after)) note_change(closing, before, after, notes);
}

/// Moves every point in turn by a fifth of the mean chord.
void measure_moves(const Scheme& scheme, const Input& input, Notes& notes) {
  const Fit fit = scheme.fit(input);
  if (!study::solved(fit)) return;
  const int n = input.size();
  for (int i = 0; i < n; ++i) {
    const double angle = 2.4 * i;
    const Fit edited = scheme.refit(fit, move_by(input, i, 0.2 * Vec2(std::cos(angle), std::sin(angle))));
    const bool near_end = !input.closed && (i < 2 || i >= n - 2);
    if (edited.curve) note_change(near_end ? moving_at_end : moving, fit, edited, notes);
  }
}

void measure_edits(const Uses& uses, Notes& notes) {
  const Scheme& scheme = *uses.schemes.front();
  for (int i = 0; i < curves; ++i) {
    const Input open = random_curve(uses.seed, i, points, false);
    Input once_closed = open;
    once_closed.closed = true;
    measure_insertions(scheme, open, notes);
    measure_closing(scheme, open, once_closed, notes);
    measure_moves(scheme, open, notes);
    measure_moves(scheme, random_curve(uses.seed, i, points, true), notes);
  }
}

struct Windows {
  std::string_view mode, words;
};
constexpr std::array<Windows, 2> windows{{{"local", "robust"}, {"paper", "as printed"}}};
constexpr auto &robust = windows[0], &as_printed = windows[1];

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  // G2: closing a C2 curve leaves so little freedom that a loop may come of it.
  for (const Step& step : steps()) add_jobs(jobs, step, pkappa(context.registry, "continuity=g2"));
  for (const Windows& each : windows)
    jobs.push_back(study::numbers_job<measure_edits>(
        {.work = "edits of random curves",
         .schemes = {pkappa(context.registry, fmt::format("mode={}", each.mode))},
         .seed = context.seed},
        fmt::format("random, {} points, seed {}", points, context.seed), std::string(each.words)));
  return jobs;
}

// ---- what follows

/// The edits of one kind, and how many of them changed no more than the bound.
struct Counts {
  study::Tally within;
  double most = 0.0;

  Counts(const Rows& rows, const EditKind& what, const Windows& by) {
    const Rows own = rows.where({edit(what.words), study::key::label(by.words)});
    for (const double n : own.values(changed_count)) {
      within.add(n <= what.bound);
      most = std::max(most, n);
    }
  }
};

Table changes(const Rows& rows) {
  Table table("changes", "Segments that change",
              fmt::format("{} random C2 curves of {} points, open and closed; segments compared bit for bit. The "
                          "bound is what the windows of Section 5.1 allow: a closing appends the first point, "
                          "then solves for three segments around it.",
                          curves, points));
  table.words("edit").words("windows").counts("edits").counts("most").counts("bound").counts("above");
  for (const EditKind& what : edits)
    for (const Windows& by : windows)
      if (const Counts counts(rows, what, by); counts.within.cases > 0.0)
        table.row({what.words, by.words, counts.within.cases, counts.most, what.bound, counts.within.misses()});
  return table;
}

/// The printed algorithm is that of mode=paper; the evidence tells of the robust one.
void claim_bound(Findings& found, const EditKind& what) {
  const Counts printed(found.rows(), what, as_printed), ours(found.rows(), what, robust);
  found.judge(
      what.claim, printed.within,
      {fmt::format("at most {:.0f} segments in {:.0f} edits", printed.most, printed.within.cases),
       fmt::format("Windows as printed, random curves, bit for bit. With robust windows at most {:.0f}, and above "
                   "{:.0f} in {:.0f} of {:.0f} edits.",
                   ours.most, what.bound, ours.within.misses(), ours.within.cases),
       "as printed"});
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{.id = "pkappa-construction",
                             .title = "What an edit changes",
                             .caption =
                                 "The curve before and after each step, the segments that differ in another "
                                 "colour: a point appended, the curve closed, a point near the end and one inside "
                                 "moved. Stand-ins for Figs. 6 to 8.",
                             .columns = 4,
                             .panels = {}};
  for (const Step& step : steps()) {
    std::vector<int> cells;
    for (const std::string_view label : {initial, kept, changed})
      if (const auto cell = found.find(dataset_of(step), label)) cells.push_back(*cell);
    if (cells.size() == 3) figure.panels.push_back(Panel::curves(std::move(cells), step.title));
  }
  return figure;
}

void conclude(Findings& found) {
  found.add(changes(found.rows()));
  for (const EditKind& what : edits) claim_bound(found, what);
  found.add(figure(found));
}

}  // namespace

Experiment pkappa_construction_experiment() {
  std::vector<std::string> claims;
  claims.reserve(edits.size());
  for (const EditKind& what : edits) claims.emplace_back(what.claim);
  return study::experiment({.id = "pkappa-construction",
                            .title = "Inserting, closing and moving (Wang 2024, Figs. 6 to 8)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = std::move(claims),
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
