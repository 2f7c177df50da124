// Chen 2019, Fig. 6: what does h do at an inflection, and which values of it are safe?
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "datasets/datasets.hpp"
#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/papers/fpc-2019-chen/inputs.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "schemes/curve/arc_length.hpp"
#include "schemes/fpc/condition.hpp"
#include "schemes/fpc/marks.hpp"
#include "schemes/fpc/tasks.hpp"

namespace kappabench {
namespace {

using namespace chen;
using study::count_of, study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Table,
    study::Tally;

constexpr std::string_view about =
    "At an inflection, h is half the distance to the second root of the curvature's numerator. Drawn for the three "
    "values of Fig. 6. On random typed inputs, one inflection at a time gets other values: do h = 0.5 and -0.5 bend it "
    "opposite ways, and does a large |h| (its sign by the rule) stretch it? A segment has no solution at h = t(1 - t) "
    "/ (2(2t - 1)), which lies in the range that the paper allows. Does Algorithm 1 with h = 0.5 throughout meet a "
    "singular system for the joints on these inputs and on closed curves of inflections? There are lambdas at which it "
    "is singular. What the rule for the sign of h is worth is measured on the closed curves.";

// ---- what is measured

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> shown{
    {{"inflection-h-half", "h = 0.5"}, {"inflection-h-three", "h = 3"}, {"inflection-h-minus-half", "h = −0.5"}}};
constexpr int inputs = 500, rings = 300;

const Quantity place{"t", "1", Method::exact};  ///< of the inflection, Eq. (20)
// NaN where one of the two is not solved.
const Quantity opposite{"bends the other way", "1", Method::exact};  ///< h = -0.5 against 0.5; 1 or 0
const Quantity stretch{"stretch", "1", Method::sampled};             ///< length with |h| = 3 over that with 0.5
const Key sign{"sign of h"};
const Quantity solved = count_of("solved"), condition{"condition", "1", Method::sampled};
/// Of runs of Algorithm 1.
const Quantity systems = count_of("systems"), regular{"no singular system", "1", Method::exact};
const auto as_given = sign("as given"), by_rule = sign("by rule");

/// What the segment of point `i` does with h there.
struct Bend {
  bool left;      ///< before the inflection
  double length;  ///< over the mean chord
};

std::optional<Bend> bend_with(const Scheme& scheme, Input input, int i, double h) {
  input.options[static_cast<std::size_t>(i)].h = h;
  const Fit fit = scheme.fit(input);
  if (!study::solved(fit)) return std::nullopt;
  const std::vector<Node> nodes = nodes_of(*fit.curve, i);
  if (nodes.size() != 1 || nodes[0].has(fpc::marks::at_inflection)) return std::nullopt;
  const Segment& segment = fit.curve->segment(nodes[0].segment);
  return Bend{curvature(segment.jet(0.5 * nodes[0].t, 2)) > 0.0, arc_length(segment, 0.0, 1.0) / mean_chord(input)};
}

double place_of(const Input& input, int i) {
  const int n = input.size();
  const auto at = [&](int k) { return input.points[static_cast<std::size_t>((k + n) % n)]; };
  const double before = (at(i) - at(i - 1)).norm();
  return before / (before + (at(i + 1) - at(i)).norm());
}

/// The first inflection of the input, with other h.
void measure_bends(const Uses& uses, const Input& input, Notes& notes) {
  int i = 0;
  while (i < input.size() && input.options_of(i).type != PointType::inflection) ++i;
  if (i == input.size()) return;
  const auto with = [&](double h) { return bend_with(*uses.schemes.front(), input, i, h); };
  const double t = place_of(input, i);
  const bool positive = t <= 0.5;  // the sign that keeps away from the singular value
  const auto plus = with(0.5), minus = with(-0.5), &small = positive ? plus : minus,
             large = with(positive ? 3.0 : -3.0);
  notes.row({}, {place(t), opposite(plus && minus ? (plus->left != minus->left ? 1.0 : 0.0) : undefined),
                 stretch(small && large ? large->length / small->length : undefined)});
}

/// Closed stars of inflections.
Drawing random_rings(std::uint64_t seed) {
  Drawing drawing{.id = fmt::format("rings of inflections, seed {}", seed)};
  for (std::uint64_t s = seed; s < seed + rings; ++s)
    drawing.curves.push_back(
        typed_random_input(RandomKind::star, 4 + static_cast<int>(s % 9), s, true, {PointType::inflection}));
  return drawing;
}

/// Solved with both signs.
void measure_ring(const Uses& uses, const Input& input, Notes& notes) {
  notes.row({as_given}, {solved(study::solved(uses.schemes[0]->fit(input)))});
  notes.row({by_rule}, {solved(study::solved(uses.schemes[1]->fit(input)))});
}

/// A run of Algorithm 1, if there is a system: an h at which a segment has no solution is refused before. What leaves
/// the range of numbers counts as singular, too.
void measure_iteration(const Uses& uses, const Input& input, Notes& notes) {
  const Report report = uses.schemes.front()->fit(input).report;
  if (report.outcome == Outcome::unsupported_input) return;
  notes.row({}, {systems(report.iterations + 1), regular(report.outcome == Outcome::failed ? 0 : 1)});
}

/// Three inflections on a triangle, all with h = 1/2, and three lambdas: the joints' system is singular there.
void measure_triangle(const Uses&, Notes& notes) {
  constexpr std::array edges{1.22014622, 1.12488513, 1.00859008};  // the first one closes the triangle
  const double x = (edges[0] * edges[0] + edges[1] * edges[1] - edges[2] * edges[2]) / (2.0 * edges[1]);
  Input input{.points = {{0, 0}, {edges[1], 0}, {x, std::sqrt(edges[0] * edges[0] - x * x)}}, .closed = true};
  input.options.assign(3, PointOptions{.type = PointType::inflection});
  const std::array log_ratio{std::log(3.3569898250224233), std::log(1.25357562), std::log(9.15856176)};
  for (const bool rule : {false, true}) {
    const fpc::Tasks read = fpc::read_tasks(input, {.h_sign_by_rule = rule});
    const fpc::CubicChain chain = fpc::make_chain(input.points, read.tasks, true);
    notes.row({rule ? by_rule : as_given}, {condition(fpc::joint_condition(chain, log_ratio))});
  }
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  jobs.reserve(shown.size() + 5);
  const SchemePtr scheme = context.registry.create("fpc"), given = context.registry.parse("fpc:h_sign=given"),
                  published = context.registry.parse("fpc:h_sign=given,iteration=published");
  const Drawing mixed = typed_random_inputs("h", context.seed, inputs), all_inflections = random_rings(context.seed);
  for (const auto& [id, words] : shown)
    jobs.push_back(fit_job(open_drawings(id).front(), scheme, {}, std::string(words)));
  jobs.push_back(
      study::curves_job<measure_bends>({.work = "h", .version = 2, .schemes = {scheme}, .drawings = {mixed}}));
  jobs.push_back(study::curves_job<measure_ring>(
      {.work = "sign of h", .schemes = {given, scheme}, .drawings = {all_inflections}}));
  for (const Drawing& drawing : {mixed, all_inflections})
    jobs.push_back(
        study::curves_job<measure_iteration>({.work = "Algorithm 1", .schemes = {published}, .drawings = {drawing}}));
  jobs.push_back(study::numbers_job<measure_triangle>({.work = "condition", .schemes = {given, scheme}},
                                                      "triangle of inflections"));
  return jobs;
}

// ---- what follows

Tally bends_otherwise(const study::Rows& rows) {
  return study::tally_of(rows.values(opposite), [](double other_way) { return other_way == 1.0; });
}
/// Inflections at which neither sign of h is beyond its singular t, (3 - sqrt 5)/2 and (sqrt 5 - 1)/2; or the others.
study::Rows between_singular(const Findings& found, bool between) {
  return found.rows().where_row([between](const study::Row& row) {
    return row.has(place) && (std::abs(row[place] - 0.5) < 0.5 * std::sqrt(5.0) - 1.0) == between;
  });
}
Tally stretches(const Findings& found) {
  return study::tally_of(found.rows().values(stretch), [](double ratio) { return ratio > 1.0; });
}
Tally solved_rings(const Findings& found, const study::KeyIs& rule) {
  return study::tally_of(found.rows().where({rule}).values(solved));
}

Table table(const Findings& found) {
  Table table("inflection-h", "What h does", "Random typed inputs, and closed curves of inflections alone.");
  table.words("what").counts("cases").counts("so").numbers("share");
  const auto row = [&table](std::string_view words, const Tally& so) {
    table.row({words, so.cases, so.agree, so.share()});
  };
  row("h = -0.5 bends the other way than h = 0.5", bends_otherwise(found.rows()));
  row("the same, t between 0.382 and 0.618", bends_otherwise(between_singular(found, true)));
  row("the same, other t", bends_otherwise(between_singular(found, false)));
  row("the segment is longer with |h| = 3 than with 0.5, sign by rule", stretches(found));
  row("closed curves of inflections solved, h = 0.5", solved_rings(found, as_given));
  row("closed curves of inflections solved, sign of h by rule", solved_rings(found, by_rule));
  return table;
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{.id = "fpc-inflection-h",
                             .title = "The shape parameter h at an inflection",
                             .caption = "The same points with h = 0.5, 3 and −0.5 at the middle one, an inflection.",
                             .columns = 3};
  for (const auto& [id, words] : shown)
    if (const auto cell = found.find(id, words)) figure.panels.push_back(Panel::curves({*cell}, std::string(words)));
  return figure;
}

void claim_bends(Findings& found) {
  const Tally other_way = bends_otherwise(found.rows()), longer = stretches(found);
  const std::string how = fmt::format(
      "The first inflection of random typed inputs, all else unchanged; one that is not solved for both values is a "
      "miss, {:.0f} and {:.0f} for the two statements.",
      study::tally_of(found.rows().values(opposite), [](double v) { return !std::isnan(v); }).misses(),
      study::tally_of(found.rows().values(stretch), [](double v) { return !std::isnan(v); }).misses());
  found.judge(
      "h-sign", other_way,
      {fmt::format("h = 0.5 and -0.5 bend opposite ways before the point: {}; with t between 0.382 and 0.618 {}, "
                   "with other t {}",
                   other_way.words(), bends_otherwise(between_singular(found, true)).words(),
                   bends_otherwise(between_singular(found, false)).words()),
       "h = 0.5 is singular at t = 0.618 and -0.5 at t = 0.382 (h-range): beyond, the bend of one of the two is "
       "turned over, and both bend the same way. " +
           how});
  found.judge("h-size", longer,
              {"longer with |h| = 3 than with |h| = 0.5, its sign by rule: " + longer.words(),
               fmt::format("{} Median ratio of lengths {:.3g}.", how, found.rows().median(stretch))});
}

/// Follows from the equations alone; no cell is asked.
void claim_range(Findings& found) {
  constexpr int grid = 999;
  Tally solvable;
  for (int i = 1; i <= grid; ++i) {
    const double t = static_cast<double>(i) / (grid + 1), h = fpc::singular_h(t);
    solvable.add(!std::isfinite(h) || !fpc::admissible_h(t, h));
  }
  found.judge(
      "h-range", solvable,
      {fmt::format("for {:.0f} of {} values of t a singular h is allowed", solvable.misses(), grid),
       "h = t(1 - t)/(2(2t - 1)) makes the segment's three conditions dependent. At the default h = 0.5 that is "
       "t = 0.618..., the golden ratio; nearby the segment runs off."});
}

/// The paper says what its authors met: runs of Algorithm 1, with their h, are what it is judged by.
void claim_regular(Findings& found) {
  const Tally runs = study::tally_of(found.rows().values(regular));
  found.judge(
      "joint-system-regular", runs,
      {fmt::format("{} runs of Algorithm 1 met no singular system", runs.words()),
       fmt::format("{:.0f} systems, random typed inputs and closed curves of inflections, h = 0.5 as printed. "
                   "Singular systems do exist: a triangle of inflections has condition {:.2g} with lambda = "
                   "(3.357, 1.254, 9.159) set by hand, {:.3g} with the sign of h by rule. By Newton's method h = "
                   "0.5 throughout solves {} of the closed curves, the rule {}.",
                   found.rows().total(systems), found.rows().where({as_given}).largest(condition),
                   found.rows().where({by_rule}).largest(condition), solved_rings(found, as_given).words(),
                   solved_rings(found, by_rule).words())});
}

void conclude(Findings& found) {
  found.add(table(found));
  found.add(figure(found));
  claim_bends(found);
  claim_range(found);
  claim_regular(found);
}

}  // namespace

Experiment fpc_inflection_h_experiment() {
  return study::experiment({.id = "fpc-inflection-h",
                            .title = "The parameter h at inflections (Chen 2019, Fig. 6)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"h-sign", "h-size", "h-range", "joint-system-regular"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
