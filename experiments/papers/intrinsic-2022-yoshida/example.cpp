// Yoshida 2022, Fig. 1: a curve from a B-spline curvature function, and the closed forms of its angle.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numeric>
#include <utility>

#include "datasets/random_source.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/measured.hpp"
#include "schemes/segments/intrinsic.hpp"

namespace kappabench {
namespace {

using namespace yoshida;
using namespace intrinsic;
using study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Row, study::Table;

constexpr std::string_view about =
    "The cubic B-spline of Fig. 1: knots [0, 0, 0, 1/2, 1, 1, 1] and five control curvatures (the paper prints none; a "
    "stand-in), the seven Bezier control curvatures after knot insertion, and the curve. Then the closed forms for the "
    "angle: Eq. (5) for the whole, and Eq. (7) for the angle at any arc length, as printed (n of n + 1 coefficients "
    "are summed, and widths in the original parameter are multiplied by the arc length so far) and corrected, against "
    "Gauss quadrature of the B-spline by de Boor's recurrence, on random splines and arc lengths.";

// ---- what is measured

constexpr int random_splines = 200;
constexpr std::string_view dataset = "five control curvatures";
/// Along Fig. 1: where a Bezier control curvature acts, and where an angle is taken.
const Key abscissa{"abscissa"}, at_t{"t"};
const Quantity bezier{"Bezier control curvature", "1/length", kappabench::Method::exact};
const Quantity by_quadrature{"angle by quadrature", "rad", kappabench::Method::sampled};
const Quantity corrected_angle{"angle corrected", "rad", kappabench::Method::exact};
const Quantity printed_angle{"angle as printed", "rad", kappabench::Method::exact};
/// Differences from quadrature on random splines.
const Quantity printed_off{"printed is off", "1", kappabench::Method::sampled};
const Quantity corrected_off{"corrected is off", "1", kappabench::Method::sampled};
const Quantity whole_off{"whole is off", "1", kappabench::Method::sampled};

IntrinsicForm example() {
  return {Vec2::Zero(), 0.0, 1.0, 3, {0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0}, {0.4, 2.4, 0.6, 1.4, 3.2}};
}

/// Value at t in [0, 1) by de Boor's recurrence, with the end knots repeated once more.
double de_boor(const IntrinsicForm& form, double t) {
  std::vector<double> knots{form.knots.front()};
  knots.insert(knots.end(), form.knots.begin(), form.knots.end());
  knots.push_back(form.knots.back());
  const auto n = static_cast<std::size_t>(form.degree);
  std::size_t span = n;
  while (span + 1 < form.control_curvatures.size() && t >= knots[span + 1]) ++span;
  std::vector<double> d(n + 1);
  for (std::size_t j = 0; j <= n; ++j) d[j] = form.control_curvatures[span - n + j];
  for (std::size_t r = 1; r <= n; ++r)
    for (std::size_t j = n; j >= r; --j) {
      const double from = knots[span - n + j], to = knots[span + 1 + j - r];
      const double share = (t - from) / (to - from);
      d[j] = (1.0 - share) * d[j - 1] + share * d[j];
    }
  return d[n];
}

/// The integral of curvature from 0 to t, span by span: exact for polynomials up to rounding.
double angle_by_quadrature(const IntrinsicForm& form, double t) {
  double sum = 0.0;
  for (const KnotSpan& span : spans_of({form.degree, form.knots})) {
    if (span.from >= t) break;
    sum += boost::math::quadrature::gauss<double, 7>::integrate([&form](double u) { return de_boor(form, u); },
                                                                span.from, std::min(t, span.to));
  }
  return form.length * sum;
}

std::vector<double> bezier_of(const IntrinsicForm& form, const KnotSpan& span) {
  const Eigen::VectorXd b = span.to_bernstein * Eigen::Map<const Eigen::VectorXd>(
                                                    form.control_curvatures.data() + span.first, form.degree + 1);
  return {b.begin(), b.end()};
}

/// The Bernstein coefficients on [0, v] of the polynomial: subdivision.
std::vector<double> left_part(std::vector<double> b, double v) {
  std::vector<double> left;
  for (std::size_t rest = b.size(); rest > 0; --rest) {
    left.push_back(b[0]);
    for (std::size_t i = 0; i + 1 < rest; ++i) b[i] += v * (b[i + 1] - b[i]);
  }
  return left;
}

/// Eq. (7): the angle at t as printed, and corrected.
struct ClosedForms {
  double printed = 0.0, corrected = 0.0;
};
ClosedForms closed_forms(const IntrinsicForm& form, double t) {
  ClosedForms sums;
  const double n = form.degree;
  for (const KnotSpan& span : spans_of({form.degree, form.knots})) {
    if (span.from >= t) break;
    const double to = std::min(t, span.to), width = to - span.from;
    const std::vector<double> b = left_part(bezier_of(form, span), width / span.width());
    // Printed: j from 1 to n, divided by n + 1.
    sums.printed += width * std::accumulate(b.begin() + 1, b.end(), 0.0) / (n + 1.0);
    sums.corrected += width * std::accumulate(b.begin(), b.end(), 0.0) / (n + 1.0);
  }
  return {t * form.length * sums.printed, form.length * sums.corrected};
}

/// The formulas against quadrature, relative to the integral of |curvature|, which `scale` bounds.
void measure_forms(const IntrinsicForm& form, double t, Notes& notes) {
  double largest = 0.0;
  for (const double k : form.control_curvatures) largest = std::max(largest, std::abs(k));
  const double scale = largest * form.length, angle = angle_by_quadrature(form, t);
  const auto [printed, corrected] = closed_forms(form, t);
  // Eq. (5) over the whole range.
  const double whole = closed_forms(form, 1.0).corrected - angle_by_quadrature(form, 1.0);
  notes.row({}, {printed_off(std::abs(printed - angle) / scale), corrected_off(std::abs(corrected - angle) / scale),
                 whole_off(std::abs(whole) / scale)});
}

IntrinsicForm random_form(std::uint64_t seed) {
  RandomSource random(seed);
  const int degree = 1 + static_cast<int>(random.uniform(0.0, 5.0));
  const int size = degree + 1 + static_cast<int>(random.uniform(0.0, 5.0));
  const BSplineBasis basis = uniform_basis(degree, size);
  IntrinsicForm form{Vec2::Zero(), 0.0, random.uniform(0.5, 3.0), degree, basis.knots, {}};
  for (int i = 0; i < size; ++i) form.control_curvatures.push_back(random.uniform(-3.0, 3.0));
  return form;
}

void measure_random_forms(const Uses& uses, Notes& notes) {
  for (std::uint64_t i = 0; i < random_splines; ++i) {
    RandomSource random(uses.seed * 7919 + i);
    measure_forms(random_form(uses.seed * 104729 + i), random.uniform(0.05, 1.0), notes);
  }
}

void measure_example(const Uses&, Notes& notes) {
  const IntrinsicForm form = example();
  const auto spans = spans_of({form.degree, form.knots});
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const std::vector<double> b = bezier_of(form, spans[i]);
    for (std::size_t j = i == 0 ? 0 : 1; j < b.size(); ++j)
      notes.row({abscissa(spans[i].from + spans[i].width() * static_cast<double>(j) / form.degree)}, {bezier(b[j])});
  }
  constexpr int steps = 8;
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const auto [printed, corrected] = closed_forms(form, t);
    notes.row({at_t(t)},
              {by_quadrature(angle_by_quadrature(form, t)), corrected_angle(corrected), printed_angle(printed)});
  }
}

Fit example_fit(const Uses&) {
  const auto segment = std::make_shared<const IntrinsicSegment>(example());
  Fit fit{.input = {.points = {segment->jet(0.0, 0).position(), segment->jet(1.0, 0).position()},
                    .closed = false,
                    .options = {},
                    .ids = {}},
          .curve = std::nullopt,
          .report = {.outcome = Outcome::converged}};
  fit.curve.emplace(std::vector<SegmentPtr>{segment}, std::vector<Joint>{}, std::vector<Node>{}, false);
  return fit;
}

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr scheme = context.registry.create("intrinsic");
  std::vector<CellJob> jobs;
  draw<example_fit>(jobs, {.work = "curve of Fig. 1", .schemes = {scheme}}, std::string(dataset));
  jobs.push_back(
      study::numbers_job<measure_example>({.work = "Bezier form", .schemes = {scheme}}, std::string(dataset)));
  jobs.push_back(study::numbers_job<measure_random_forms>({.work = "angles", .schemes = {scheme}, .seed = context.seed},
                                                          fmt::format("random splines, seed {}", context.seed)));
  return jobs;
}

// ---- what follows

Table bezier_table(const Findings& found) {
  Table table("controls", "Control curvatures", "Over the abscissae at which they act.");
  table.words("form").numbers("abscissa").numbers("curvature");
  const auto rows = found.rows().where_row([](const Row& row) { return row.has(bezier); });
  for (const Row* row : rows) table.row({"Bezier, q", std::get<double>((*row)[abscissa]), (*row)[bezier]});
  const IntrinsicForm form = example();
  const std::vector<double> greville = greville_abscissae({form.degree, form.knots});
  for (std::size_t i = 0; !rows.empty() && i < greville.size(); ++i)
    table.row({"B-spline, p", greville[i], form.control_curvatures[i]});
  return table;
}

Table angle_table(const Findings& found) {
  Table table("angles", "The angle along the curve of Fig. 1", "Radians.");
  table.numbers("t").numbers("quadrature").numbers("Eq. (7) corrected").numbers("Eq. (7) as printed");
  for (const auto& [t, rows] : found.rows().by(at_t))
    table.row({std::get<double>(t), rows.mean(by_quadrature), rows.mean(corrected_angle), rows.mean(printed_angle)});
  return table;
}

/// How often a formula agrees with quadrature.
study::Tally agree(const Findings& found, const Quantity& off) {
  constexpr double rounding = 1e-13;
  return study::tally_of(found.rows().values(off), [](double d) { return d <= rounding; });
}

std::string words_of(const Findings& found, const Quantity& off) {
  return fmt::format("{} agree with quadrature; largest difference {:.2g} of the largest curvature times length",
                     agree(found, off).words(), found.rows().largest(off));
}

void claim_formulas(Findings& found) {
  found.judge("integral-of-bezier-segments", agree(found, whole_off),
              {words_of(found, whole_off),
               fmt::format("{} random splines of degree 1 to 5 on equal knots, by Gauss quadrature of de Boor's "
                           "recurrence.",
                           random_splines)});
  // Eq. (7) counts its controls from 0 and sums them from 1.
  found.judge_formula("angle-in-closed-form", agree(found, printed_off), agree(found, corrected_off),
                      {words_of(found, printed_off),
                       "At random arc lengths. Corrected, with all n + 1 coefficients and the widths of the original "
                       "parameter times the whole length: " +
                           words_of(found, corrected_off) + "."});
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{.id = "intrinsic-example",
                             .title = "A B-spline curvature function and its curve",
                             .caption =
                                 "Five control curvatures (squares) over their Greville abscissae with the knots "
                                 "(ticks); the same function's Bezier control curvatures; the curve with its comb.",
                             .columns = 3,
                             .panels = {}};
  add_curvature_panel(figure, found, dataset, "explicit B-spline");
  if (!figure.panels.empty())
    figure.panels.push_back(Panel::graph("controls", "abscissa", {"curvature"}, "B-spline and Bezier control polygon")
                                .labels("", "")
                                .series("form"));
  add_curve_panel(figure, found, dataset, "the curve");
  return figure;
}

void conclude(Findings& found) {
  found.add(bezier_table(found));
  found.add(angle_table(found));
  found.add(figure(found));
  claim_formulas(found);
}

}  // namespace

Experiment intrinsic_example_experiment() {
  return study::experiment({.id = "intrinsic-example",
                            .title = "A curve from a B-spline curvature function (Yoshida 2022, Fig. 1)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"integral-of-bezier-segments", "angle-in-closed-form"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
