#include "schemes/fpc/fpc.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "schemes/api/registry.hpp"
#include "schemes/fpc/assemble.hpp"
#include "schemes/fpc/condition.hpp"
#include "schemes/fpc/marks.hpp"
#include "schemes/fpc/published_iteration.hpp"
#include "schemes/fpc/tasks.hpp"
#include "schemes/fpc/windows.hpp"
#include "schemes/segments/open_curve.hpp"

namespace kappabench {
namespace {

Fit refusal(const Input& input, std::string why) {
  return {input, std::nullopt, {.outcome = Outcome::unsupported_input, .message = std::move(why)}};
}

Fit failure(const Input& input, std::string why) {
  return {input, std::nullopt, {.outcome = Outcome::failed, .message = std::move(why)}};
}

/// All points on one line: every segment is degenerate (A = 0), and no curvature is left to agree on.
Fit fit_line(const Input& input, const std::vector<fpc::PointTask>& tasks, bool in_order) {
  const bool cusp_or_loop = std::ranges::any_of(
      tasks, [](const fpc::PointTask& t) { return t.type == PointType::cusp || t.type == PointType::loop; });
  if (cusp_or_loop) return refusal(input, "the points lie on one line, where there are no cusps and loops");
  if (!in_order)
    return refusal(input, "the points lie on one line and turn back on it; the curve would have cusps not asked for");
  return {
      input,
      straight_line(input.points),
      {.outcome = Outcome::converged, .message = "the points lie on one line: the curve is that line", .trace = {0.0}}};
}

std::string unsolved_message(const fpc::CubicChain& chain, const fpc::Solution& solution) {
  const std::vector<double> log_ratio = fpc::System(chain).log_ratios(solution.state);
  const double condition = fpc::joint_condition(chain, log_ratio);
  return fmt::format("not solved: the residual is {:.2g}, {:.0e} is asked for; condition of the joint system {:.1e}",
                     solution.residual, fpc::accuracy, condition);
}

}  // namespace

SchemeInfo FpcScheme::describe() {
  const std::string size_help = ", in the segment's parameter; 0: half of min(t, 1 - t); a point's own goes before";
  return {
      .id = "fpc",
      .title = "FPC-curve: cubic pieces with cusps, loops and inflections at chosen points",
      .citation = "Chen, Huang, Cao, Zhang, Interpolatory curve modeling with feature points control, CAD 114, 2019",
      .parameters = {{.name = "h",
                      .default_value = 0.5,
                      .help = "shape at inflections, half the distance to the second root; a point's own goes before"},
                     {.name = "h_sign",
                      .default_value = std::string("rule"),
                      .help = "of h: by rule (positive for t <= 1/2, else negative; never singular) or as given",
                      .choices = {"rule", "given"}},
                     {.name = "alpha",
                      .default_value = 0.0,
                      .help = "loop size before the point" + size_help,
                      .least = 0.0,
                      .most = 1.0,
                      .most_included = false},
                     {.name = "beta",
                      .default_value = 0.0,
                      .help = "loop size after the point" + size_help,
                      .least = 0.0,
                      .most = 1.0,
                      .most_included = false},
                     {.name = "iteration",
                      .default_value = std::string("newton"),
                      .help = "how the equations are solved: Newton with path following, or the paper's Algorithm 1",
                      .choices = {"newton", "published"}},
                     {.name = "max_iterations",
                      .default_value = 50L,
                      .help = "the most steps of iteration=published, 0 for its start (newton has its own bounds)",
                      .least = 0,
                      .most = 1000000}},
      .traits = {.fewest_open_points = 2,
                 .continuity = Continuity::g2,
                 .continuity_exceptions = "where the curvature changes sign at a joint: G1 with equal |curvature|; "
                                          "where a segment has shrunk to its point: G1, or G0 if the path turns back "
                                          "there; cusps at points of that type",
                 .reversal_invariant = false},
      .version = 2,
      .marks = {{std::string(fpc::marks::at_inflection),
                 "the point's own segment has shrunk to nothing at an inflection; the node is the joint of its "
                 "neighbours"}}};
}

FpcScheme::FpcScheme(Parameters parameters) : Scheme(describe(), std::move(parameters)) {}

Fit FpcScheme::solve(const Input& input) const {
  const fpc::Tasks read = fpc::read_tasks(input, {.h = parameters().real("h"),
                                                  .h_sign_by_rule = parameters().text("h_sign") == "rule",
                                                  .alpha = parameters().real("alpha"),
                                                  .beta = parameters().real("beta")});
  if (!read.problem.empty()) return refusal(input, read.problem);
  if (const Line line = line_of(input.points, input.closed); line.straight)
    return fit_line(input, read.tasks, line.in_order);

  const fpc::CubicChain chain = fpc::make_chain(input.points, read.tasks, input.closed);
  fpc::Published published;
  const bool newton = parameters().text("iteration") == "newton";
  if (!newton) published = fpc::iterate_published(chain, static_cast<int>(parameters().integer("max_iterations")));
  const fpc::Solution solution = newton ? fpc::solve(chain) : std::move(published.solution);
  if (published.singular)
    return failure(input, fmt::format("the linear system for the joints is singular to working precision at step {}",
                                      solution.effort.sweeps));
  if (!std::isfinite(solution.residual)) return failure(input, "the iteration left the range of numbers");

  Fit fit{.input = input, .curve = std::nullopt, .report = {}};
  Report& report = fit.report;
  report.outcome = solution.converged ? Outcome::converged : Outcome::not_converged;
  if (!solution.converged) report.message = unsolved_message(chain, solution);
  report.iterations = static_cast<int>(std::lround(solution.iterations));
  report.residual = solution.residual;
  report.trace = solution.trace;
  fpc::Assembled assembled = fpc::assemble(input, chain, solution.state);
  fit.curve = std::move(assembled.curve);
  report.counters = std::move(assembled.counters);
  report.counters["sweeps"] = solution.effort.sweeps;
  report.counters["newton"] = solution.effort.newton;
  if (newton) report.counters["attempts"] = solution.effort.attempts;
  return fit;
}

void register_fpc(Registry& registry) { registry.add<FpcScheme>(); }

}  // namespace kappabench
