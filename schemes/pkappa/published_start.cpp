#include "schemes/pkappa/published_start.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "schemes/numerics/bernstein.hpp"

namespace kappabench::pkappa {

double chord_parameter(const Vec2& p, const Vec2& q, const Vec2& r) {
  const double a = (q - p).norm(), b = (r - q).norm();
  return a + b > 0.0 ? a / (a + b) : 0.5;
}

template <int Degree>
ControlPolygon<Degree> part(ControlPolygon<Degree> control, double a, double b) {
  for (int level = 1; level <= Degree; ++level)
    for (int j = Degree; j >= level; --j) control.col(j) = (1.0 - b) * control.col(j - 1) + b * control.col(j);
  const double from = a / b;
  for (int level = 1; level <= Degree; ++level)
    for (int j = 0; j + level <= Degree; ++j)
      control.col(j) = (1.0 - from) * control.col(j) + from * control.col(j + 1);
  return control;
}

template <int Degree>
ControlPolygon<Degree> first_segment(const Vec2& start, const Vec2& point, const Vec2& end, double t) {
  const double u = 1.0 - t;
  const Vec2 middle = (point - u * u * start - t * t * end) / (2.0 * t * u);
  // Elevation of a quadratic with control points a, b, c, times k (k - 1): (k-j)(k-j-1) a + 2 j (k-j) b + j (j-1) c.
  // The ends to the last bit, so that whoever sets them again changes nothing.
  ControlPolygon<Degree> control;
  control.col(0) = start;
  control.col(Degree) = end;
  for (int j = 1; j < Degree; ++j) {
    const int rest = Degree - j;
    control.col(j) = (rest * (rest - 1) * start + 2 * j * rest * middle + j * (j - 1) * end) / (Degree * (Degree - 1));
  }
  return control;
}

template <Continuity K>
ControlPolygon<Layout<K>::degree> last_segment(const ControlPolygon<Layout<K>::degree>& before, const Vec2& point,
                                               const Vec2& end, double t) {
  using L = Layout<K>;
  constexpr int k = L::degree;
  ControlPolygon<k> control;
  control.template leftCols<L::side>() = side_points<K>(joint_at_end<K>(before), Side::right);
  control.col(k) = end;
  // With c_{k-1} halfway, interpolation leaves c_{k-2}, whose coefficient vanishes like t^3 (quintic) or t^2 (quartic):
  // t is kept away from 0.
  constexpr double least_t = 0.1;
  const auto basis = bernstein<k>(std::max(t, least_t));
  const Vec2 known = control.template leftCols<L::side>() * basis.template head<L::side>();
  control.col(k - 2) = (point - known - (basis[k] + 0.5 * basis[k - 1]) * end) / (basis[k - 2] + 0.5 * basis[k - 1]);
  control.col(k - 1) = 0.5 * (control.col(k - 2) + end);
  return control;
}

template <Continuity K>
void make_parametric(ControlPolygon<Layout<K>::degree>& left, ControlPolygon<Layout<K>::degree>& right) {
  using L = Layout<K>;
  constexpr int k = L::degree;
  if constexpr (!L::geometric) {
    left.col(k) = right.col(0) = 0.5 * (left.col(k - 1) + right.col(1));
    if constexpr (L::second_order) right.col(2) = left.col(k - 2) - 2.0 * left.col(k - 1) + 2.0 * right.col(1);
  }
}

namespace {

/// Quartic: the new segment's inner points continue its neighbours with C1, its middle one is left to interpolation.
template <Continuity K>
void fill_quartic(Spline<K>& s, const Vec2& point) {
  auto& control = s.control[1];
  control.col(1) = 2.0 * s.control[0].col(4) - s.control[0].col(3);
  control.col(3) = 2.0 * s.control[2].col(0) - s.control[2].col(1);
  control.col(2) = point;
  const auto basis = bernstein<4>(s.t[1]);
  control.col(2) += (point - control * basis) / basis[2];
}

/// Quintic: edges and second differences of the two new joints, four vectors, from three interpolations and from
/// P_0(1/2) = (c_{0,0} + 2 p_0 + c_{0,k}) / 4. Singular at t_0 = 1/2, so near it nothing is done and the other starts
/// have to serve.
template <Continuity K>
void fill_quintic(Spline<K>& s, const Vec2& left_point, const Vec2& point, const Vec2& right_point) {
  constexpr double too_near = 0.05;
  const Vec2 from = s.control[0].col(5), to = s.control[2].col(0);
  auto& middle = s.control[1];
  middle = first_segment<5>(from, point, to, s.t[1]);
  if (std::abs(s.t[1] - 0.5) < too_near) return;
  const SideCoefficients<K> right = coefficients<K>(Joint{}, Side::right), left = coefficients<K>(Joint{}, Side::left);
  using Quarter = Eigen::Matrix<double, 1, 3>;
  const auto at_start = [&](const auto& basis) { return Quarter(basis.template head<3>().transpose() * right); };
  const auto at_end = [&](const auto& basis) { return Quarter(basis.template tail<3>().reverse().transpose() * left); };
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Eigen::Matrix<double, 4, 2> wanted;
  const auto before = bernstein<5>(s.t[0]), after = bernstein<5>(s.t[2]);
  matrix.block<1, 2>(0, 0) = at_end(before).template tail<2>();
  wanted.row(0) =
      (left_point - s.control[0].template leftCols<3>() * before.template head<3>() - at_end(before)[0] * from)
          .transpose();
  matrix.block<1, 2>(1, 2) = at_start(after).template tail<2>();
  wanted.row(1) =
      (right_point - s.control[2].template rightCols<3>() * after.template tail<3>() - at_start(after)[0] * to)
          .transpose();
  const Vec2 waypoint = 0.25 * (from + 2.0 * point + to);
  int row = 2;
  for (const auto& [t, through] : {std::pair{s.t[1], point}, std::pair{0.5, waypoint}}) {
    const auto basis = bernstein<5>(t);
    matrix.block<1, 2>(row, 0) = at_start(basis).template tail<2>();
    matrix.block<1, 2>(row, 2) = at_end(basis).template tail<2>();
    wanted.row(row) = (through - at_start(basis)[0] * from - at_end(basis)[0] * to).transpose();
    ++row;
  }
  const Eigen::Matrix<double, 4, 2> x = matrix.fullPivLu().solve(wanted);
  if (!x.allFinite()) return;
  const Joint first{.position = from, .edge = x.row(0), .second = x.row(1)};
  const Joint last{.position = to, .edge = x.row(2), .second = x.row(3)};
  s.control[0].template rightCols<3>() = side_points<K>(first, Side::left).rowwise().reverse();
  s.control[2].template leftCols<3>() = side_points<K>(last, Side::right);
  middle.template leftCols<3>() = side_points<K>(first, Side::right);
  middle.template rightCols<3>() = side_points<K>(last, Side::left).rowwise().reverse();
}

}  // namespace

template <Continuity K>
Spline<K> between(const ControlPolygon<Layout<K>::degree>& left, double left_t, const Vec2& left_point,
                  const Vec2& point, const ControlPolygon<Layout<K>::degree>& right, double right_t,
                  const Vec2& right_point) {
  using L = Layout<K>;
  constexpr int k = L::degree;
  const double z = 0.5 * (1.0 + left_t), y = 0.5 * right_t;
  Spline<K> s;
  s.control = {part<k>(left, 0.0, z), {}, part<k>(right, y, 1.0)};
  s.t = {left_t / z, chord_parameter(s.control[0].col(k), point, s.control[2].col(0)), (right_t - y) / (1.0 - y)};
  // Cutting a segment changes its parameter speed: parametric continuity with the neighbours beyond needs the old one.
  if constexpr (!L::geometric) {
    s.control[0].template leftCols<L::side>() = left.template leftCols<L::side>();
    s.control[2].template rightCols<L::side>() = right.template rightCols<L::side>();
  }
  s.control[1].col(0) = s.control[0].col(k);
  s.control[1].col(k) = s.control[2].col(0);
  if constexpr (L::second_order)
    fill_quintic<K>(s, left_point, point, right_point);
  else
    fill_quartic<K>(s, point);
  return s;
}

template ControlPolygon<4> part<4>(ControlPolygon<4>, double, double);
template ControlPolygon<5> part<5>(ControlPolygon<5>, double, double);
template ControlPolygon<4> first_segment<4>(const Vec2&, const Vec2&, const Vec2&, double);
template ControlPolygon<5> first_segment<5>(const Vec2&, const Vec2&, const Vec2&, double);
template ControlPolygon<4> last_segment<Continuity::c1>(const ControlPolygon<4>&, const Vec2&, const Vec2&, double);
template void make_parametric<Continuity::c1>(ControlPolygon<4>&, ControlPolygon<4>&);
template Spline<Continuity::c1> between<Continuity::c1>(const ControlPolygon<4>&, double, const Vec2&, const Vec2&,
                                                        const ControlPolygon<4>&, double, const Vec2&);
template ControlPolygon<4> last_segment<Continuity::g1>(const ControlPolygon<4>&, const Vec2&, const Vec2&, double);
template void make_parametric<Continuity::g1>(ControlPolygon<4>&, ControlPolygon<4>&);
template Spline<Continuity::g1> between<Continuity::g1>(const ControlPolygon<4>&, double, const Vec2&, const Vec2&,
                                                        const ControlPolygon<4>&, double, const Vec2&);
template ControlPolygon<5> last_segment<Continuity::c2>(const ControlPolygon<5>&, const Vec2&, const Vec2&, double);
template void make_parametric<Continuity::c2>(ControlPolygon<5>&, ControlPolygon<5>&);
template Spline<Continuity::c2> between<Continuity::c2>(const ControlPolygon<5>&, double, const Vec2&, const Vec2&,
                                                        const ControlPolygon<5>&, double, const Vec2&);
template ControlPolygon<5> last_segment<Continuity::g2>(const ControlPolygon<5>&, const Vec2&, const Vec2&, double);
template void make_parametric<Continuity::g2>(ControlPolygon<5>&, ControlPolygon<5>&);
template Spline<Continuity::g2> between<Continuity::g2>(const ControlPolygon<5>&, double, const Vec2&, const Vec2&,
                                                        const ControlPolygon<5>&, double, const Vec2&);

}  // namespace kappabench::pkappa
