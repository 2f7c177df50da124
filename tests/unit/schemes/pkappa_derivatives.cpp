// The energy's derivatives against automatic differentiation and, through a whole window, against differences.

#include <Eigen/Core>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

#include "schemes/numerics/bernstein.hpp"
#include "schemes/pkappa/flat_problem.hpp"
#include "schemes/pkappa/starts.hpp"
#include "tests/catch.hpp"

using namespace kappabench;
using namespace kappabench::pkappa;

namespace {

constexpr Weights weights{0.1, 0.3};

/// The weighted energy of Eq. (9) by its definition, the parabola given.
template <int Degree, class T>
T weighted_energy(const Eigen::Matrix<T, 2, Degree + 1>& c, const T& t, const VertexParabola& parabola) {
  const QuadratureRule& rule = gauss_rule();
  T sum(0.0);
  for (Eigen::Index q = 0; q < rule.nodes().size(); ++q) {
    const auto b1 = bernstein_derivatives<Degree>(rule.nodes()[q], 1);
    const auto b2 = bernstein_derivatives<Degree>(rule.nodes()[q], 2);
    T x1(0.0), y1(0.0), x2(0.0), y2(0.0);
    for (int j = 0; j <= Degree; ++j) {
      x1 += c(0, j) * b1[j];
      y1 += c(1, j) * b1[j];
      x2 += c(0, j) * b2[j];
      y2 += c(1, j) * b2[j];
    }
    const T speed = sqrt(x1 * x1 + y1 * y1);
    const T off = T(rule.nodes()[q]) - t;
    const T miss =
        (x1 * y2 - y1 * x2) / (speed * speed * speed) - (T(parabola.vertex_value) + T(parabola.steepness) * off * off);
    sum += T(rule.root_weights()[q] * rule.root_weights()[q]) * speed * miss * miss;
  }
  T before(0.0);
  for (int j = 0; j < Degree; ++j) {
    const T dx = c(0, j + 1) - c(0, j), dy = c(1, j + 1) - c(1, j);
    const T squared = dx * dx + dy * dy;
    sum += T(weights.length) * squared;
    if (j > 0) sum += T(weights.edges) * (squared - before) * (squared - before);
    before = squared;
  }
  return sum;
}

template <int Degree>
void check_gradient(const ControlPolygon<Degree>& control, double t) {
  constexpr int size = 2 * (Degree + 1) + 1;
  using Gradient = Eigen::Matrix<double, size, 1>;
  using Dual = Eigen::AutoDiffScalar<Gradient>;
  SegmentEnergy<Degree> energy(gauss_rule());
  SegmentNormal<Degree> normal;
  energy.normal(control, t, weights, normal);
  // Where the parabola is the best one, the derivatives do not feel it move.
  const VertexParabola parabola = energy.parabola(control, t);
  Eigen::Matrix<Dual, 2, Degree + 1> c;
  for (int j = 0; j <= Degree; ++j)
    for (int d = 0; d < 2; ++d) c(d, j) = Dual(control(d, j), size, 2 * j + d);
  const Dual exact = weighted_energy<Degree, Dual>(c, Dual(t, size, size - 1), parabola);
  CHECK(normal.terms.weighted(weights) == Approx(exact.value()).epsilon(1e-12));
  CHECK((2.0 * normal.gradient - exact.derivatives()).norm() <= 1e-11 * exact.derivatives().norm());
}

}  // namespace

TEST_CASE("pkappa: the gradient of a segment's energy is that of automatic differentiation") {
  ControlPolygon<5> quintic;
  quintic << 0, 1, 3, 5, 6, 6.5, 0, 2, 3, 2.5, 1, -1;
  ControlPolygon<4> quartic;
  quartic << 0, 1, 2.2, 3.5, 3.9, 0, -0.3, 0.4, 1.1, 2.4;
  check_gradient<5>(quintic, 0.6);
  check_gradient<5>(0.3 * quintic, 0.2);
  check_gradient<4>(quartic, 0.45);
}

namespace {

template <Continuity K>
JointChain window_of_three(const std::vector<double>& units) {
  JointChain chain;
  chain.points = {{1, 0.3}, {1.8, 1.1}, {3.1, 0.9}};
  chain.joints.resize(4);
  chain.freedom = {Freedom::none, Freedom::all, Freedom::all, Freedom::end_point};
  chain.joints[0] = {.position = {0.4, -0.1}, .edge = {0.2, 0.05}, .second = {0.01, 0.03}};
  chain.joints[3].position = {4.0, 0.1};
  chain.units = units;
  JointChain start = *fair_start<K>(chain);
  if (Layout<K>::geometric)
    for (std::size_t k = 1; k < 3; ++k) start.joints[k].ratio = 0.2 * static_cast<double>(k);
  if (K == Continuity::g2) start.joints[1].shift = -0.3;
  REQUIRE(restore_interpolation<K>(start));
  return start;
}

/// Central differences with one step of Richardson's extrapolation.
template <class F>
auto difference(F f, Eigen::VectorXd x, Eigen::Index i) {
  const double h = 1e-3;
  const auto central = [&](double step) {
    Eigen::VectorXd up = x, down = x;
    up[i] += step;
    down[i] -= step;
    return ((f(up) - f(down)) / (2.0 * step));
  };
  auto fine = central(0.5 * h), coarse = central(h);
  return ((4.0 * fine - coarse) / 3.0);
}

template <Continuity K>
void check_window(const std::vector<double>& units) {
  INFO(name(K) << (units.empty() ? ", one unit" : ", own units"));
  const JointChain chain = window_of_three<K>(units);
  const auto flat = flat_problem<K>(chain, gauss_rule(), weights);
  const Eigen::VectorXd x = flat->values_of(chain);
  CHECK(flat->miss(x).norm() < 1e-13);
  const Eigen::VectorXd gradient = flat->gradient(x);
  const Eigen::MatrixXd constraint = flat->miss_jacobian(x);
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
  flat->rows(x, residuals, jacobian);
  CHECK(residuals.squaredNorm() == Approx(flat->objective(x)).epsilon(1e-12));
  CHECK((2.0 * jacobian.transpose() * residuals - gradient).norm() <= 1e-11 * gradient.norm());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    INFO("unknown " << i);
    const double slope = difference([&](const Eigen::VectorXd& at) { return flat->objective(at); }, x, i);
    CHECK(std::abs(slope - gradient[i]) <= 1e-7 * gradient.norm());
    for (Eigen::Index row = 0; row < constraint.rows(); ++row) {
      const double c = difference([&](const Eigen::VectorXd& at) { return flat->miss(at)[row]; }, x, i);
      CHECK(std::abs(c - constraint(row, i)) <= 1e-9);
    }
  }
}

}  // namespace

TEST_CASE("pkappa: weights in a unit give the energy with lengths over it") {
  ControlPolygon<5> control;
  control << 0, 1, 3, 5, 6, 6.5, 0, 2, 3, 2.5, 1, -1;
  SegmentEnergy<5> energy(gauss_rule());
  for (const double unit : {1e-3, 0.7, 40.0}) {
    INFO(unit);
    const double scaled = energy.terms(control / unit, 0.6).weighted(weights);
    CHECK(energy.terms(control, 0.6).weighted(weights.in(unit)) == Approx(scaled).epsilon(1e-12));
  }
}

TEST_CASE("pkappa: gradient and constraints of a window, for every continuity") {
  for (const std::vector<double>& units : {std::vector<double>{}, std::vector<double>{0.9, 1.3, 1.1}}) {
    check_window<Continuity::c1>(units);
    check_window<Continuity::g1>(units);
    check_window<Continuity::c2>(units);
    check_window<Continuity::g2>(units);
  }
}
