// Numbers computed with 30 to 40 digits.

#include <Eigen/QR>
#include <array>

#include "schemes/curve/exact_curvature.hpp"
#include "schemes/pkappa/published_start.hpp"
#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"

using namespace kappabench;
using namespace kappabench::pkappa;

namespace {

ControlPolygon<5> quintic() {
  ControlPolygon<5> control;
  control << 0, 1, 3, 5, 6, 6.5, 0, 2, 3, 2.5, 1, -1;
  return control;
}

PolynomialSegment segment_of(const ControlPolygon<5>& control) {
  std::array<Vec2, 6> points;
  for (std::size_t j = 0; j < points.size(); ++j) points[j] = control.col(static_cast<Eigen::Index>(j));
  return PolynomialSegment(points);
}

/// E_p of Eq. (3) for a given parabola.
double parabola_energy(const QuadratureRule& rule, const Segment& segment, const Eigen::Vector3d& a) {
  double sum = 0.0;
  for (Eigen::Index q = 0; q < rule.nodes().size(); ++q) {
    const double t = rule.nodes()[q], root = rule.root_weights()[q];
    const Jet jet = segment.jet(t, 2);
    const double off = curvature(jet) - (a[0] + t * (a[1] + t * a[2]));
    sum += root * root * off * off * jet.d[1].norm();
  }
  return sum;
}

}  // namespace

TEST_CASE("pkappa: the three energies of a quintic") {
  const ControlPolygon<5> control = quintic();
  const PolynomialSegment segment = segment_of(control);
  const Eigen::Vector3d parabola(-0.2, 0.5, -0.4);
  CHECK(parabola_energy(fine_gauss_rule(), segment, parabola) == Approx(0.375777495286077).epsilon(1e-13));
  CHECK(parabola_energy(simpson_rule(), segment, parabola) == Approx(0.3757774955716039).epsilon(1e-13));
  CHECK(edge_energy<5>(control) == Approx(2.5625).epsilon(1e-14));
  CHECK(length_energy<5>(control) == Approx(21.75).epsilon(1e-14));
  CHECK(curvature(segment.jet(0.0, 2)) == Approx(-0.2146625258399798).epsilon(1e-13));
  CHECK(curvature(segment.jet(0.5, 2)) == Approx(-0.353068068732709).epsilon(1e-13));
  CHECK(curvature(segment.jet(1.0, 2)) == Approx(-0.1141344117818038).epsilon(1e-13));
}

TEST_CASE("pkappa: the parabola through curvature samples with its vertex given") {
  // Wang 2024, Section 5.2.3, with end points among the 100 samples. The scheme itself eliminates the parabola.
  const PolynomialSegment segment = segment_of(quintic());
  const double vertex = 0.6;
  Eigen::MatrixX2d basis(100, 2);
  Eigen::VectorXd samples(100);
  for (int j = 0; j < 100; ++j) {
    const double t = j / 99.0;
    basis.row(j) << 1.0, (t - vertex) * (t - vertex);
    samples[j] = curvature(segment.jet(t, 2));
  }
  const Eigen::Vector2d best = basis.colPivHouseholderQr().solve(samples);
  CHECK(best[0] + best[1] * vertex * vertex == Approx(-0.1674223029026363).epsilon(1e-12));
  CHECK(-2.0 * vertex * best[1] == Approx(-0.4716996655586796).epsilon(1e-12));
  CHECK(best[1] == Approx(0.393083054632233).epsilon(1e-12));
}

TEST_CASE("pkappa: the last segment of an open curve") {
  // A segment whose end gives c0, c1 and c2 by C2.
  const Vec2 c0(1, 1), c1(1.5, 1.2), c2(2.1, 1.1);
  const Vec2 edge = c1 - c0, second = c2 - 2.0 * c1 + c0;
  ControlPolygon<5> before = ControlPolygon<5>::Zero();
  before.col(5) = c0;
  before.col(4) = c0 - edge;
  before.col(3) = c0 - 2.0 * edge + second;
  const ControlPolygon<5> last = last_segment<Continuity::c2>(before, {3, 0.2}, {4, -1}, 0.45);
  CHECK((last.col(1) - c1).norm() < 1e-14);
  CHECK((last.col(2) - c2).norm() < 1e-14);
  CHECK((last.col(3) - Vec2(4.921090240866621, -1.184083556270838)).norm() < 1e-13);
  CHECK((last.col(4) - Vec2(4.460545120433311, -1.092041778135419)).norm() < 1e-13);
}

TEST_CASE("pkappa: curvature extrema of a quintic") {
  const PolynomialSegment segment = segment_of(quintic());
  const auto extrema = curvature_extrema(segment);
  REQUIRE(extrema.at.size() == 1);
  CHECK(extrema.at.front().mid() == Approx(0.5382749020746497).epsilon(1e-12));
  CHECK(inflections(segment).at.empty());
}

TEST_CASE("pkappa: G2 joints with ratio 0 and shift 0 are C2, others agree in tangent and curvature") {
  const pkappa::Joint joint{
      .position = {1, 2}, .edge = {0.5, 0.1}, .second = {0.02, -0.3}, .ratio = 0.4, .shift = -0.7};
  ControlPolygon<5> left = ControlPolygon<5>::Zero(), right = left;
  left.rightCols<3>() = side_points<Continuity::g2>(joint, Side::left).rowwise().reverse();
  right.leftCols<3>() = side_points<Continuity::g2>(joint, Side::right);
  const Jet before = segment_of(left).jet(1.0, 2), after = segment_of(right).jet(0.0, 2);
  CHECK(std::abs(cross(before.d[1].normalized(), after.d[1].normalized())) < 1e-15);
  CHECK(curvature(before) == Approx(curvature(after)).epsilon(1e-14));
  CHECK(after.d[1].norm() / before.d[1].norm() == Approx(std::exp(0.4)).epsilon(1e-14));
  const pkappa::Joint back = joint_between<Continuity::g2>(left, right);
  CHECK((back.edge - joint.edge).norm() < 1e-15);
  CHECK((back.second - joint.second).norm() < 1e-14);
  CHECK(back.ratio == Approx(joint.ratio).epsilon(1e-13));
  CHECK(back.shift == Approx(joint.shift).epsilon(1e-13));
}
