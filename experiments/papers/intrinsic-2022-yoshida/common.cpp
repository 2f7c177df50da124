#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "datasets/key_values.hpp"
#include "experiments/run/record.hpp"
#include "experiments/study/panel.hpp"
#include "schemes/segments/intrinsic.hpp"

namespace kappabench::yoshida {

using namespace intrinsic;
using std::numbers::pi;

StandardData angles_of_figure_6() { return {pi / 9.0, pi / 3.0, {}, {}}; }
StandardData angles_of_figure_5() { return {7.0 * pi / 36.0, 4.0 * pi / 9.0, {}, {}}; }

StandardData condition_of_figure_3() {
  constexpr double degree = pi / 180.0;
  return {25.0 * degree, 75.0 * degree, {}, {}};
}

StandardData with_curvatures(StandardData angles, double start, double end) {
  angles.start_curvature = start;
  angles.end_curvature = end;
  return angles;
}

HermiteData placed_at_origin(const StandardData& data) {
  return {{Vec2::Zero(), 0.0, data.start_curvature},
          {{std::cos(data.chord_angle), std::sin(data.chord_angle)}, data.turning, data.end_curvature}};
}

Settings FixedFamily::settings() const {
  Settings settings;
  settings.automatic = false;
  settings.basis = basis;
  settings.p = p;
  return settings;
}

const std::vector<FixedFamily>& families_of_figure_6() {
  // The printed knots of (e) have one 0 too many for 6 control curvatures.
  static const std::vector<FixedFamily> families{
      {"(a) m = 4", uniform_basis(3, 4), 0.0},
      {"(b) m = 6, p = 0", uniform_basis(3, 6), 0.0},
      {"(c) m = 6, p = 0.5", uniform_basis(3, 6), 0.5},
      {"(d) m = 6, p = 1", uniform_basis(3, 6), 1.0},
      {"(e) m = 6, p = 1, knots at ends", {3, {0.0, 0.0, 0.0, 0.0333, 0.966, 1.0, 1.0, 1.0}}, 1.0}};
  return families;
}

Settings settings_of(std::string_view family) {
  if (family == automatic) return {};
  return std::ranges::find(families_of_figure_6(), family, &FixedFamily::title)->settings();
}

namespace {

/// Is the quadratic with these Bernstein coefficients non-negative on [0, 1]? Its least value there is at an end, or,
/// if the middle coefficient is the lowest, (b0 b2 - b1^2) / (b0 - 2 b1 + b2).
bool non_negative(double b0, double b1, double b2) { return b0 >= 0.0 && b2 >= 0.0 && b1 >= -std::sqrt(b0 * b2); }

/// Does the cubic B-spline rise on every span? Differences of the controls within `rounding` are none.
bool rises_on_spans(const StandardCurve& curve, double rounding) {
  for (const KnotSpan& span : spans_of(curve.basis)) {
    const auto controls = Eigen::Map<const Eigen::VectorXd>(curve.controls.data() + span.first, 4);
    const Eigen::VectorXd b = span.to_bernstein * controls;
    const auto step = [&b, rounding](int i) {
      const double d = b[i + 1] - b[i];
      return std::abs(d) <= rounding ? 0.0 : d;
    };
    if (!non_negative(step(0), step(1), step(2))) return false;
  }
  return true;
}

}  // namespace

bool rises(const HermiteFit& fit) {
  if (fit.outcome != Outcome::converged || !fit.curve) return false;
  const std::vector<double>& k = fit.curve->controls;
  if (!(k.back() > k.front())) return false;
  if (fit.curve->basis.degree == 3) return rises_on_spans(*fit.curve, 1e-12 * largest_control(*fit.curve));
  return verdict_of(*fit.curve).trend == Trend::rising;
}

bool monotone(const HermiteFit& fit) {
  if (!fit.curve || fit.outcome != Outcome::converged) return false;
  if (rises(fit)) return true;
  HermiteFit other = fit;
  other.curve = mirrored(*fit.curve);
  return rises(other) || verdict_of(*fit.curve).trend == Trend::constant;
}

std::vector<long> amounts(const Context& context, std::string_view experiment, const std::vector<Amount>& defaults) {
  std::vector<long> numbers;
  std::vector<std::string_view> names;
  for (const Amount& amount : defaults) {
    numbers.push_back(amount.n);
    names.push_back(amount.name);
  }
  for (const std::string& text : context.datasets) {
    const auto colon = text.find(':');
    const auto found = std::ranges::find(names, std::string_view(text).substr(0, colon));
    if (found == names.end())
      throw std::invalid_argument(fmt::format("{}: '{}' is nothing to compute; write {}:n=1000", experiment, text,
                                              fmt::join(names, ":n=1000 or ")));
    KeyValues options(colon == std::string::npos ? "" : text.substr(colon + 1), text);
    long& n = numbers[static_cast<std::size_t>(found - names.begin())];
    n = options.take_integer("n", n, 1, 100000000);
    options.expect_all_taken("n");
  }
  return numbers;
}

std::vector<std::pair<long, long>> parts_of(long n) {
  constexpr long part = 5000;
  std::vector<std::pair<long, long>> parts;
  for (long from = 0; from < n; from += part) parts.emplace_back(from, std::min(from + part, n));
  return parts;
}

Fit as_fit(const StandardData& data, const HermiteFit& solution) {
  const HermiteData ends = placed_at_origin(data);
  Fit fit{.input = {.points = {ends.from.point, ends.to.point}, .closed = false, .options = {}, .ids = {}},
          .curve = std::nullopt,
          .report = {.outcome = solution.outcome,
                     .message = solution.message,
                     .iterations = solution.iterations,
                     .residual = solution.residual}};
  const bool usable = solution.outcome == Outcome::converged || solution.outcome == Outcome::not_converged;
  if (solution.curve && usable)
    fit.curve.emplace(std::vector<SegmentPtr>{std::make_shared<const IntrinsicSegment>(placed(*solution.curve, ends))},
                      std::vector<Joint>{},
                      std::vector<Node>{{.point = 0, .segment = 0, .t = 0.0}, {.point = 1, .segment = 0, .t = 1.0}},
                      false);
  return fit;
}

namespace {

void add_mark(store::CurveRecord& mark, double s, double kappa) {
  mark.sample_s.push_back(s);
  mark.sample_kappa.push_back(kappa);
  mark.node_s.push_back(s);
  mark.node_kappa.push_back(kappa);
  for (std::vector<double>* none : {&mark.sample_x, &mark.sample_y, &mark.sample_normal_x, &mark.sample_normal_y,
                                    &mark.node_x, &mark.node_y, &mark.node_t})
    none->push_back(std::nan(""));
  for (std::vector<int>* none : {&mark.node_point, &mark.node_segment}) none->push_back(0);
  mark.node_marks.emplace_back();
}

/// The polygon of control curvatures of one piece, from arc length `start` on.
void add_controls(store::CurveRecord& mark, const IntrinsicForm& form, double start) {
  const BSplineBasis basis{form.degree, form.knots};
  const std::vector<double> at = greville_abscissae(basis);
  for (std::size_t i = 0; i < at.size(); ++i) add_mark(mark, start + form.length * at[i], form.control_curvatures[i]);
  for (const double knot : form.knots) {
    const double s = start + form.length * knot;
    if (!mark.joint_s.empty() && mark.joint_s.back() == s) continue;
    mark.joint_s.push_back(s);
    mark.joint_segment.push_back(0);
    mark.joint_claimed.emplace_back();
    mark.joint_x.push_back(std::nan(""));
    mark.joint_y.push_back(std::nan(""));
  }
}

store::CurveRecord controls_mark(const Fit& fit) {
  store::CurveRecord mark;
  mark.outcome = name(Outcome::converged);
  if (!fit.curve) return mark;
  double start = 0.0;
  for (const SegmentPtr& segment : fit.curve->segments()) {
    const auto form = std::get<IntrinsicForm>(segment->exact());
    add_controls(mark, form, start);
    mark.samples_per_segment = static_cast<int>(form.control_curvatures.size());
    start += form.length;
  }
  return mark;
}

/// The cell with the curve of a dataset, or with its control curvatures.
std::optional<int> cell_of(const study::Findings& found, std::string_view dataset, bool controls) {
  for (std::size_t i = 0; i < found.cells().size(); ++i) {
    const store::CellRecord& cell = found.cells()[i];
    if (cell.dataset == dataset && (cell.label == controls_label) == controls && !cell.curves.empty())
      return static_cast<int>(i);
  }
  return std::nullopt;
}

}  // namespace

void keep_curve(const Scheme& scheme, const Fit& fit, store::CellRecord& cell) {
  cell.curves.push_back(record_of(scheme, fit, {}));
  cell.outcome = name(fit.report.outcome);
  cell.message = fit.report.message;
}

void keep_controls(const Fit& fit, store::CellRecord& cell) { cell.curves.push_back(controls_mark(fit)); }

void add_curve_panel(store::FigureRecord& figure, const study::Findings& found, std::string_view dataset,
                     std::string title) {
  if (const auto cell = cell_of(found, dataset, false))
    figure.panels.push_back(study::Panel::curves({*cell}, std::move(title)).comb());
}

void add_curvature_panel(store::FigureRecord& figure, const study::Findings& found, std::string_view dataset,
                         std::string title) {
  const auto cell = cell_of(found, dataset, false);
  if (!cell) return;
  std::vector<int> cells{*cell};
  if (const auto controls = cell_of(found, dataset, true)) cells.push_back(*controls);
  figure.panels.push_back(study::Panel::curvature(std::move(cells), std::move(title)));
}

study::Table drawn_table(const study::Findings& found) {
  study::Table table("drawn", "The curves of the figure", "Curvature times the chord, length over the chord.");
  table.words("curve").words("outcome").counts("steps").numbers("gap").numbers("length");
  table.numbers("curvature at the start").numbers("at the end");
  for (const store::CellRecord& cell : found.cells()) {
    if (cell.curves.empty() || cell.label == controls_label || cell.curves[0].sample_s.empty()) continue;
    const store::CurveRecord& curve = cell.curves[0];
    table.row({cell.dataset, curve.outcome, curve.iterations, curve.residual, curve.sample_s.back(),
               curve.sample_kappa.front(), curve.sample_kappa.back()});
  }
  return table;
}

}  // namespace kappabench::yoshida
