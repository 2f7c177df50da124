#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "datasets/datasets.hpp"
#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/papers/fpc-2019-chen/inputs.hpp"
#include "experiments/study/summaries.hpp"
#include "schemes/fpc/condition.hpp"
#include "schemes/fpc/marks.hpp"
#include "schemes/fpc/tasks.hpp"

namespace kappabench {

using namespace fpc;

namespace {

constexpr std::string_view about =
    "At an inflection, h is half the distance to the second root of the curvature's numerator. Drawn for the three "
    "values of Fig. 6. On random typed inputs, one inflection at a time gets other values: do h = 0.5 and -0.5 bend it "
    "opposite ways, and does a large |h| (its sign by the rule) stretch it? A segment has no solution at h = t(1 - t) "
    "/ (2(2t - 1)), which lies in the range that the paper allows; and there are lambdas at which the linear system "
    "for the joints is singular. What the rule for the sign of h is worth is measured on closed curves of inflections, "
    "with h = 0.5 throughout and with the sign by rule.";

constexpr int version = 1;
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> shown{
    {{"inflection-h-half", "h = 0.5"}, {"inflection-h-three", "h = 3"}, {"inflection-h-minus-half", "h = −0.5"}}};
constexpr std::array growing{0.5, 1.0, 2.0, 3.0};
constexpr int inputs = 150, rings = 300;

/// What the segment of point `i` does with h there.
struct Bend {
  double before;  ///< sign of the curvature before the inflection
  double length;  ///< over the mean chord
};

std::optional<Bend> bend_with(const Scheme& scheme, Input input, int i, double h) {
  input.options[static_cast<std::size_t>(i)].h = h;
  const Fit fit = scheme.fit(input);
  if (!study::solved(fit)) return std::nullopt;
  const std::vector<Node> nodes = nodes_of(*fit.curve, i);
  if (nodes.size() != 1 || nodes[0].has(fpc::marks::at_inflection)) return std::nullopt;
  const Segment& segment = fit.curve->segment(nodes[0].segment);
  const double k = curvature(segment.jet(0.5 * nodes[0].t, 2));
  return Bend{k > 0.0 ? 1.0 : -1.0, length_between(segment, 0.0, 1.0) / mean_chord(input)};
}

/// The sign of h that keeps away from the singular value.
double sign_by_rule(const Input& input, int i) {
  const int n = input.size();
  const auto at = [&](int k) { return input.points[static_cast<std::size_t>((k + n) % n)]; };
  return (at(i) - at(i - 1)).norm() <= (at(i + 1) - at(i)).norm() ? 1.0 : -1.0;
}

/// The first inflection of the input, or -1.
int first_inflection(const Input& input) {
  for (int i = 0; i < input.size(); ++i)
    if (input.options_of(i).type == PointType::inflection) return i;
  return -1;
}

void measure(const Scheme& scheme, const Input& input, store::CellRecord& cell) {
  const int i = first_inflection(input);
  if (i < 0) return;
  study::put(cell, "inflections", 1.0);
  const auto left = bend_with(scheme, input, i, 0.5), right = bend_with(scheme, input, i, -0.5);
  if (left && right) study::put(cell, "bends the other way", left->before != right->before ? 1.0 : 0.0);
  std::vector<double> lengths;
  const double sign = sign_by_rule(input, i);
  for (const double h : growing)
    if (const auto bend = bend_with(scheme, input, i, sign * h)) lengths.push_back(bend->length);
  if (lengths.size() == growing.size()) {
    study::put(cell, "stretches", lengths.back() > lengths.front() ? 1.0 : 0.0);
    study::put(cell, "stretch", lengths.back() / lengths.front());
  }
}

/// A closed star of inflections, solved with both signs.
void measure_ring(const Scheme& as_given, const Scheme& by_rule, std::uint64_t seed, store::CellRecord& cell) {
  const Input input =
      typed_random_input(RandomKind::star, 4 + static_cast<int>(seed % 9), seed, true, {PointType::inflection});
  study::put(cell, "solved as given", study::solved(as_given.fit(input)) ? 1.0 : 0.0);
  study::put(cell, "solved by rule", study::solved(by_rule.fit(input)) ? 1.0 : 0.0);
}

/// Three inflections on a triangle, all with h = 1/2, and three lambdas: the joints' system is singular there.
void measure_triangle(store::CellRecord& cell) {
  constexpr std::array edges{1.22014622, 1.12488513, 1.00859008};  // the first one closes the triangle
  const double x = (edges[0] * edges[0] + edges[1] * edges[1] - edges[2] * edges[2]) / (2.0 * edges[1]);
  Input input{.points = {{0, 0}, {edges[1], 0}, {x, std::sqrt(edges[0] * edges[0] - x * x)}},
              .closed = true,
              .options = {},
              .ids = {}};
  input.options.assign(3, PointOptions{.type = PointType::inflection});
  const std::array log_ratio{std::log(3.3569898250224233), std::log(1.25357562), std::log(9.15856176)};
  for (const bool by_rule : {false, true}) {
    const Tasks read = read_tasks(input, {.h_sign_by_rule = by_rule});
    const Chain chain = make_chain(input.points, read.tasks, true);
    study::put(cell, by_rule ? "condition by rule" : "condition as given", joint_condition(chain, log_ratio));
  }
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  jobs.reserve(shown.size() + 3);
  const SchemePtr scheme = context.registry.create("fpc"), as_given = context.registry.parse("fpc:h_sign=given");
  for (const auto& [id, words] : shown)
    jobs.push_back(study::drawn_job(open_drawings(id).front(), scheme, std::string(words)));
  const std::uint64_t seed = context.seed;
  jobs.push_back(random_job(scheme, fmt::format("h, seed {}", seed), version, inputs,
                            [scheme, seed](std::uint64_t index, store::CellRecord& cell) {
                              measure(*scheme, typed_random_input(seed, index), cell);
                            }));
  jobs.push_back(random_job(as_given, fmt::format("rings of inflections, seed {}", seed), version, rings,
                            [scheme, as_given, seed](std::uint64_t index, store::CellRecord& cell) {
                              measure_ring(*as_given, *scheme, seed + index, cell);
                            }));
  jobs.push_back(
      other_job("triangle of inflections", as_given, fmt::format("condition {}", version), measure_triangle));
  return jobs;
}

double sum(const store::ExperimentRecord& record, std::string_view column) { return study::total(record, column); }
double count(const store::ExperimentRecord& record, std::string_view column) {
  return static_cast<double>(study::values(record, column).size());
}

store::ClaimRecord general_claim(const store::ExperimentRecord& record, std::string_view id, std::string_view column,
                                 std::string_view words, std::string evidence) {
  const double agree = sum(record, column), cases = count(record, column);
  return claim(id, study::verdict_in_general(agree, cases), fmt::format("{} {}", words, study::share(agree, cases)),
               std::move(evidence));
}

store::ClaimRecord range_claim() {
  constexpr int grid = 999;
  double singular = 0.0;
  for (int i = 1; i <= grid; ++i) {
    const double t = static_cast<double>(i) / (grid + 1);
    singular += std::isfinite(singular_h(t)) && admissible_h(t, singular_h(t)) ? 1.0 : 0.0;
  }
  return claim(
      "h-range", singular > 0.0 ? "contradicted" : "reproduced",
      fmt::format("for {:.0f} of {} values of t a singular h is allowed", singular, grid),
      "h = t(1 - t)/(2(2t - 1)) makes the segment's three conditions dependent. At the default h = 0.5 that is "
      "t = 0.618..., the golden ratio; nearby the segment runs off.");
}

store::ClaimRecord singular_claim(const store::ExperimentRecord& record) {
  const double given = largest(study::values(record, "condition as given"));
  const double rule = largest(study::values(record, "condition by rule"));
  const double solved = sum(record, "solved as given"), cases = count(record, "solved as given");
  const bool known = given > 0.0;
  return claim(
      "joint-system-regular",
      !known        ? "not reproduced"
      : given > 1e8 ? "contradicted"
                    : "reproduced",
      fmt::format("condition {:.2g} for a triangle of inflections with h = 0.5", given),
      fmt::format("With lambda = (3.357, 1.254, 9.159); with the sign of h by rule the same system has condition "
                  "{:.3g}. Closed curves of inflections: h = 0.5 throughout solves {}, the rule {}.",
                  rule, study::share(solved, cases),
                  study::share(sum(record, "solved by rule"), count(record, "solved by rule"))));
}

store::TableRecord table(const store::ExperimentRecord& record) {
  TableBuilder builder("inflection-h", "What h does", "Random typed inputs, and closed curves of inflections alone.");
  builder.words("what").counts("cases").counts("so").numbers("share");
  const auto row = [&](std::string_view words, std::string_view column) {
    const double cases = count(record, column), so = sum(record, column);
    builder.row({std::string(words), cases, so, so / cases});
  };
  row("h = -0.5 bends the other way than h = 0.5", "bends the other way");
  row("the segment is longer with |h| = 3 than with 0.5, sign by rule", "stretches");
  row("closed curves of inflections solved, h = 0.5", "solved as given");
  row("closed curves of inflections solved, sign of h by rule", "solved by rule");
  return builder.table();
}

store::FigureRecord figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{.id = "fpc-inflection-h",
                             .title = "The shape parameter h at an inflection",
                             .caption = "The same points with h = 0.5, 3 and −0.5 at the middle one, an inflection.",
                             .columns = 3,
                             .panels = {}};
  for (const auto& [id, words] : shown)
    if (const auto cell = study::drawn_cell(record, id, words)) {
      figure.panels.push_back(curve_panel(*cell, std::string(words)));
    }
  return figure;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {table(record)};
  if (auto drawn = figure(record); !drawn.panels.empty()) record.figures = {std::move(drawn)};
  const std::string how = fmt::format(
      "The first inflection of {:.0f} random typed inputs, all else unchanged; inputs that are not solved for all "
      "values are left out.",
      sum(record, "inflections"));
  record.claims = {
      general_claim(record, "h-sign", "bends the other way",
                    "h = 0.5 and -0.5 bend opposite ways before the point:", how),
      general_claim(record, "h-size", "stretches", "longer with |h| = 3 than with |h| = 0.5, its sign by rule:",
                    fmt::format("{} Median ratio of lengths {:.3g}.", how, median(study::values(record, "stretch")))),
      range_claim(), singular_claim(record)};
}

}  // namespace

Experiment fpc_inflection_h_experiment() {
  return {.id = "fpc-inflection-h",
          .title = "The parameter h at inflections (Chen 2019, Fig. 6)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
