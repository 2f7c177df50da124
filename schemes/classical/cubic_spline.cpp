#include "schemes/classical/cubic_spline.hpp"

#include <Eigen/SparseCholesky>
#include <memory>
#include <utility>

#include "schemes/classical/parametrization.hpp"
#include "schemes/segments/polynomial.hpp"

namespace kappabench {

SchemeInfo CubicSpline::describe() {
  return {.id = "cubic-spline",
          .title = "C2 cubic spline, natural or periodic",
          .citation =
              "de Boor, A Practical Guide to Splines, 1978; parameters: Lee, Choosing nodes in parametric "
              "curve interpolation, CAD 21(6), 1989",
          .parameters = {{.name = "parameter",
                          .default_value = std::string("chord"),
                          .help = "lengths of the spans in the global parameter: powers 1, 1/2, 0 of the chords",
                          .choices = {"chord", "centripetal", "uniform"}}},
          .traits = {.fewest_open_points = 2,
                     .continuity = Continuity::g2,
                     .continuity_exceptions = "points where the speed vanishes (cusps of uneven input): G0"},
          .version = 2};
}

CubicSpline::CubicSpline(Parameters parameters) : Scheme(describe(), std::move(parameters)) {}

namespace {

double exponent(const std::string& parameter) {
  if (parameter == "chord") return 1.0;
  return parameter == "centripetal" ? 0.5 : 0.0;
}

/// Second derivatives M_i at the points, n x 2, from continuity of the first derivative (de Boor 1978, ch. IV):
/// h_{i-1} M_{i-1} + 2 (h_{i-1} + h_i) M_i + h_i M_{i+1} = 6 (d_i - d_{i-1}), d_i = (p_{i+1} - p_i) / h_i,
/// at every point if closed, else at the inner ones with M = 0 at the ends.
struct SecondDerivatives {
  Eigen::MatrixX2d at_points;
  double residual;
  bool solved;
};

SecondDerivatives second_derivatives(const Input& input, const std::vector<double>& h) {
  const Eigen::Index n = input.size();
  Eigen::SparseMatrix<double> matrix(n, n);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!input.closed && (i == 0 || i == n - 1)) {
      entries.emplace_back(i, i, 1.0);
      continue;
    }
    const Eigen::Index before = (i + n - 1) % n, after = (i + 1) % n;
    const auto point = [&input](Eigen::Index j) { return input.points[static_cast<std::size_t>(j)]; };
    const double h0 = h[static_cast<std::size_t>(before)], h1 = h[static_cast<std::size_t>(i)];
    entries.emplace_back(i, i, 2.0 * (h0 + h1));
    // M vanishes at open ends: leaving its column out keeps the matrix symmetric.
    const bool before_known = !input.closed && before == 0, after_known = !input.closed && after == n - 1;
    if (!before_known) entries.emplace_back(i, before, h0);
    if (!after_known) entries.emplace_back(i, after, h1);
    right.row(i) = 6.0 * ((point(after) - point(i)) / h1 - (point(i) - point(before)) / h0).transpose();
  }
  matrix.setFromTriplets(entries.begin(), entries.end());

  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  if (factors.info() != Eigen::Success) return {{}, 0.0, false};
  const Eigen::MatrixX2d m = factors.solve(right);
  const double scale = right.norm();
  return {m, scale > 0.0 ? (matrix * m - right).norm() / scale : 0.0, m.allFinite()};
}

SegmentPtr hermite_segment(const Vec2& p0, const Vec2& p1, const Vec2& m0, const Vec2& m1, double h) {
  const Vec2 slope = (p1 - p0) / h;
  const Vec2 v0 = slope - h * (2.0 * m0 + m1) / 6.0;
  const Vec2 v1 = slope + h * (m0 + 2.0 * m1) / 6.0;
  const std::array<Vec2, 4> control{p0, p0 + h / 3.0 * v0, p1 - h / 3.0 * v1, p1};
  return std::make_shared<PolynomialSegment>(control);
}

}  // namespace

Fit CubicSpline::solve(const Input& input) const {
  const std::vector<double> h = span_lengths(input, exponent(parameters().text("parameter")));
  const auto [m, residual, solved] = second_derivatives(input, h);
  if (!solved)
    return {.input = input,
            .curve = std::nullopt,
            .report = {.outcome = Outcome::failed, .message = "the spline's linear system could not be solved"}};

  std::vector<SegmentPtr> segments;
  for (std::size_t i = 0; i < h.size(); ++i) {
    const std::size_t next = (i + 1) % input.points.size();
    segments.push_back(hermite_segment(input.points[i], input.points[next], m.row(static_cast<Eigen::Index>(i)),
                                       m.row(static_cast<Eigen::Index>(next)), h[i]));
  }
  return {.input = input,
          .curve = curve_through_joints(std::move(segments), input.closed, Continuity::g2),
          .report = {.outcome = Outcome::converged, .iterations = 1, .residual = residual}};
}

void register_cubic_spline(Registry& registry) { registry.add<CubicSpline>(); }

}  // namespace kappabench
