#include "schemes/pkappa/pkappa.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "schemes/api/registry.hpp"
#include "schemes/pkappa/global.hpp"
#include "schemes/pkappa/local.hpp"
#include "schemes/pkappa/soundness.hpp"
#include "schemes/pkappa/spans.hpp"
#include "schemes/segments/open_curve.hpp"
#include "schemes/segments/polynomial.hpp"

namespace kappabench {
namespace {

using pkappa::ControlPolygon;
using pkappa::Layout;
using pkappa::Spline;
using pkappa::WindowSettings;

constexpr long by_mode = -1;

std::vector<ParameterSpec> parameter_specs() {
  return {
      {.name = "continuity",
       .default_value = std::string("c2"),
       .help = "at the joints; c1 and g1 with quartic, c2 and g2 with quintic segments",
       .choices = {"c1", "g1", "c2", "g2"}},
      {.name = "mode",
       .default_value = std::string("local"),
       .help = "windows made robust, the whole curve at once, or windows as printed",
       .choices = {"local", "global", "paper"}},
      {.name = "unit",
       .default_value = std::string("auto"),
       .help = "unit of length in the energies: each span's own chords, the mean chord, or that of the input; auto is "
               "paper for mode=paper, else span",
       .choices = {"auto", "span", "chord", "paper"}},
      {.name = "lambda_e", .default_value = 0.1, .help = "weight of the differences of edges, Eq. (4)", .least = 0.0},
      {.name = "lambda_c", .default_value = 0.1, .help = "weight of the edges, Eq. (5)", .least = 0.0},
      {.name = "quadrature",
       .default_value = std::string("auto"),
       .help = "Gauss with 32 nodes or Simpson with 201; auto is simpson201 for mode=paper",
       .choices = {"auto", "gauss", "simpson201"}},
      {.name = "solver",
       .default_value = std::string("lm"),
       .help = "what minimises a window: Levenberg-Marquardt of our own, Ceres, SLSQP of NLopt, Ipopt",
       .choices = pkappa::solver_names()},
      {.name = "stage2_iterations",
       .default_value = by_mode,
       .help = "at most so many in stage 2; -1 is 10 for mode=paper, else until it converges",
       .least = -1.0,
       .most = 1e6},
  };
}

Continuity continuity_of(const Parameters& parameters) {
  const std::string& word = parameters.text("continuity");
  if (word == "c1") return Continuity::c1;
  if (word == "g1") return Continuity::g1;
  return word == "c2" ? Continuity::c2 : Continuity::g2;
}

/// Calls `f.operator()<K>()` with the continuity as a constant.
template <class F>
auto with_continuity(Continuity continuity, F f) {
  switch (continuity) {
    case Continuity::c1:
      return f.template operator()<Continuity::c1>();
    case Continuity::g1:
      return f.template operator()<Continuity::g1>();
    case Continuity::g2:
      return f.template operator()<Continuity::g2>();
    default:
      return f.template operator()<Continuity::c2>();
  }
}

bool is_global(const Parameters& parameters) { return parameters.text("mode") == "global"; }

pkappa::Unit unit_of(const Parameters& parameters) {
  const std::string& word = parameters.text("unit");
  if (word == "auto") return parameters.text("mode") == "paper" ? pkappa::Unit::paper : pkappa::Unit::span;
  if (word == "paper") return pkappa::Unit::paper;
  return word == "chord" ? pkappa::Unit::chord : pkappa::Unit::span;
}

WindowSettings settings_of(const Parameters& parameters) {
  const bool printed = parameters.text("mode") == "paper";
  const std::string& quadrature = parameters.text("quadrature");
  WindowSettings s;
  s.weights = {parameters.real("lambda_e"), parameters.real("lambda_c")};
  s.unit = unit_of(parameters);
  s.rule =
      quadrature == "simpson201" || (quadrature == "auto" && printed) ? &pkappa::simpson_rule() : &pkappa::gauss_rule();
  s.robust = !printed;
  s.solver = pkappa::solver_named(parameters.text("solver"));
  if (printed) {
    // The paper's epsilon and N_iter are not printed; stage 2 is Eq. (3) alone.
    s.second_weights = 0.0;
    s.second_iterations = 10;
  }
  if (const long most = parameters.integer("stage2_iterations"); most != by_mode)
    s.second_iterations = static_cast<int>(most);
  return s;
}

SchemeInfo adapt(SchemeInfo info, const Parameters& parameters) {
  const bool global = is_global(parameters);
  info.traits.continuity = continuity_of(parameters);
  info.traits.similarity_invariant = unit_of(parameters) != pkappa::Unit::paper;
  info.traits.refit_is_fit = global;
  return info;
}

template <Continuity K>
Curve assemble(const Input& input, const Spline<K>& spline) {
  const int n = static_cast<int>(spline.t.size());
  std::vector<SegmentPtr> segments;
  std::vector<Joint> joints;
  std::vector<Node> nodes;
  for (int i = 0; i < n; ++i) {
    const auto& control = spline.control[static_cast<std::size_t>(i)];
    std::array<Vec2, Layout<K>::degree + 1> points;
    for (std::size_t j = 0; j < points.size(); ++j) points[j] = control.col(static_cast<Eigen::Index>(j));
    segments.push_back(std::make_shared<PolynomialSegment>(points));
    if (input.closed || i + 1 < n) joints.push_back({i, K});
    nodes.push_back({.point = input.closed ? i : i + 1, .segment = i, .t = spline.t[static_cast<std::size_t>(i)]});
  }
  if (!input.closed) add_end_nodes(nodes, input.size(), n);
  return {std::move(segments), std::move(joints), std::move(nodes), input.closed};
}

/// The spline of a curve that `assemble` made.
template <Continuity K>
Spline<K> disassemble(const Curve& curve) {
  Spline<K> spline;
  for (const SegmentPtr& segment : curve.segments()) {
    const auto& bezier = dynamic_cast<const PolynomialSegment&>(*segment);
    ControlPolygon<Layout<K>::degree> control;
    for (Eigen::Index j = 0; j <= Layout<K>::degree; ++j)
      control.col(j) = bezier.control_points()[static_cast<std::size_t>(j)];
    spline.control.push_back(control);
  }
  const std::size_t skip = curve.closed() ? 0 : 1;
  for (std::size_t k = skip; k + skip < curve.nodes().size(); ++k) spline.t.push_back(curve.nodes()[k].t);
  return spline;
}

/// How far the curve misses its points, over the mean chord.
double interpolation_residual(const Input& input, const Curve& curve) {
  double largest = 0.0;
  for (const Node& node : curve.nodes()) {
    const Vec2 at = curve.segment(node.segment).jet(node.t, 0).position();
    largest = std::max(largest, (at - input.points[static_cast<std::size_t>(node.point)]).norm());
  }
  return largest / mean_chord(input);
}

template <Continuity K>
Fit finish(const Input& input, const Spline<K>& spline, int iterations) {
  constexpr double accuracy = 1e-10;
  Fit fit{.input = input, .curve = std::nullopt, .report = {.iterations = iterations}};
  const auto finite = [](const auto& control) { return control.allFinite(); };
  if (spline.control.empty() || !std::ranges::all_of(spline.control, finite)) {
    fit.report.outcome = Outcome::failed;
    fit.report.message = "the optimisation left the range of numbers";
    return fit;
  }
  fit.curve = assemble<K>(input, spline);
  fit.report.residual = interpolation_residual(input, *fit.curve);
  const bool interpolates = fit.report.residual <= accuracy;
  constexpr int degree = Layout<K>::degree;
  const std::span<const Vec2> points(input.points);
  const std::vector<pkappa::SegmentCheck> checks = pkappa::check_segments<degree>(
      std::span<const ControlPolygon<degree>>(spline.control), spline.t, input.closed ? points : points.subspan(1),
      pkappa::chords_of(points, input.closed), input.closed, pkappa::fine_gauss_rule());
  const auto unsound = std::ranges::find(checks, false, &pkappa::SegmentCheck::sound);
  const bool sound = unsound == checks.end();
  fit.report.outcome = sound && interpolates ? Outcome::converged : Outcome::not_converged;
  if (!interpolates)
    fit.report.message = fmt::format("misses its points by {:.2g} mean chords", fit.report.residual);
  else if (!sound && unsound->near_cusp)
    fit.report.message = fmt::format("segment {} has a near-cusp at t = {:.6g}, too narrow for the quadrature",
                                     unsound - checks.begin(), *unsound->near_cusp);
  else if (!sound)
    fit.report.message = fmt::format(
        "segment {} has a cusp, a tight loop or a far detour that the quadrature does not "
        "see",
        unsound - checks.begin());
  return fit;
}

template <Continuity K>
Fit finish_local(const Input& input, const Spline<K>& spline, const pkappa::LocalReport& report) {
  Fit fit = finish<K>(input, spline, report.iterations);
  fit.report.counters = {{"windows", report.windows},           {"fallbacks", report.fallbacks},
                         {"widened", report.widened},           {"stage2_reverted", report.reverted},
                         {"whole", report.whole ? 1 : 0},       {"unsound_windows", report.unsound},
                         {"iteration_limit", report.unfinished}};
  return fit;
}

/// In words if the curve is that of stage 1, else empty.
std::string where_it_rests(const pkappa::GlobalReport& report) {
  if (report.second_stage_reverted) return "rests on stage 1: stage 2 was not sound";
  if (report.second_stage_at_rest) return "rests on stage 1: stage 2 found no step down";
  return "";
}

}  // namespace

SchemeInfo PkappaScheme::describe() {
  return {.id = "pkappa",
          .title = "pkappa-curve: Bezier segments whose curvature approximates a parabola",
          .citation =
              "Wang, Cao, Guan, Chen, Zhang, pkappa-curves: interpolatory curves with curvature approximating a "
              "parabola, Computer Aided Geometric Design, 2024",
          .parameters = parameter_specs(),
          .traits = {.fewest_open_points = 2,
                     .continuity = Continuity::c2,
                     .reversal_invariant = false,
                     .cyclic_shift_invariant = false,
                     .refit_is_fit = false},
          .version = 3,
          .libraries = pkappa::solver_libraries()};
}

PkappaScheme::PkappaScheme(const Parameters& parameters) : Scheme(adapt(describe(), parameters), parameters) {
  if (is_global(this->parameters()) && this->parameters().text("solver") != "lm")
    throw std::invalid_argument(
        "pkappa: mode=global has solver=lm only; the other solvers are for mode=local and paper");
}

Fit PkappaScheme::solve(const Input& input) const {
  if (input.size() == 2)
    return {.input = input, .curve = straight_line(input.points), .report = {.outcome = Outcome::converged}};
  const WindowSettings settings = settings_of(parameters());
  return with_continuity(continuity_of(parameters()), [&]<Continuity K>() {
    if (is_global(parameters())) {
      pkappa::GlobalReport report;
      const Spline<K> spline = pkappa::solve_globally<K>(input, settings, report);
      Fit fit = finish<K>(input, spline, report.iterations);
      fit.report.trace = std::move(report.trace);
      if (fit.report.message.empty()) fit.report.message = where_it_rests(report);
      fit.report.counters = {{"repaired", report.repaired},
                             {"from_local", report.from_local ? 1 : 0},
                             {"stage2_reverted", report.second_stage_reverted ? 1 : 0},
                             {"stage2_at_rest", report.second_stage_at_rest ? 1 : 0},
                             {"iteration_limit", report.converged ? 0 : 1}};
      return fit;
    }
    pkappa::LocalReport report;
    const Spline<K> spline = pkappa::solve_locally<K>(input, settings, report);
    return finish_local<K>(input, spline, report);
  });
}

Fit PkappaScheme::resolve(const Fit& fit, const Edit& edit) const {
  const Input edited = apply(fit.input, edit);
  const bool line = fit.input.size() == 2 || edited.size() == 2;
  if (is_global(parameters()) || !fit.curve || line) return solve(edited);
  return with_continuity(continuity_of(parameters()), [&]<Continuity K>() {
    Spline<K> spline = disassemble<K>(*fit.curve);
    pkappa::LocalReport report;
    const WindowSettings settings = settings_of(parameters());
    if (!pkappa::edit_locally<K>(spline, edited.points, edited.closed, edit, settings, report)) return solve(edited);
    return finish_local<K>(edited, spline, report);
  });
}

void register_pkappa(Registry& registry) { registry.add<PkappaScheme>(); }

}  // namespace kappabench
