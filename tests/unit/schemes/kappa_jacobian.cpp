// The rows of the Newton system against automatic differentiation of the equations as the papers state them: cubic
// Bernstein control points, curvature from first and second derivatives, areas from control points.

#include "schemes/kappa/system.hpp"
#include "tests/catch.hpp"
#include "tests/unit/schemes/kappa_inputs.hpp"

using namespace kappabench;
using namespace kappabench::kappa;
using test::Random;

namespace {

/// A number and its derivatives by all unknowns.
struct Dual {
  double v;
  Eigen::VectorXd d;
};
Dual operator+(const Dual& a, const Dual& b) { return {a.v + b.v, a.d + b.d}; }
Dual operator-(const Dual& a, const Dual& b) { return {a.v - b.v, a.d - b.d}; }
Dual operator*(const Dual& a, const Dual& b) { return {a.v * b.v, a.d * b.v + a.v * b.d}; }
Dual operator/(const Dual& a, const Dual& b) { return {a.v / b.v, (a.d - a.v / b.v * b.d) / b.v}; }
Dual operator-(const Dual& a) { return {-a.v, -a.d}; }
Dual operator+(const Dual& a, double b) { return {a.v + b, a.d}; }
Dual operator+(double a, const Dual& b) { return b + a; }
Dual operator-(const Dual& a, double b) { return {a.v - b, a.d}; }
Dual operator-(double a, const Dual& b) { return {a - b.v, -b.d}; }
Dual operator*(double a, const Dual& b) { return {a * b.v, a * b.d}; }
Dual operator/(double a, const Dual& b) { return {a / b.v, -a / (b.v * b.v) * b.d}; }
Dual exp(const Dual& a) { return {std::exp(a.v), std::exp(a.v) * a.d}; }
Dual log(const Dual& a) { return {std::log(a.v), a.d / a.v}; }
Dual sin(const Dual& a) { return {std::sin(a.v), std::cos(a.v) * a.d}; }
Dual cos(const Dual& a) { return {std::cos(a.v), -std::sin(a.v) * a.d}; }

struct DualVec {
  Dual x, y;
};
DualVec operator+(const DualVec& a, const DualVec& b) { return {a.x + b.x, a.y + b.y}; }
DualVec operator-(const DualVec& a, const DualVec& b) { return {a.x - b.x, a.y - b.y}; }
DualVec operator*(const Dual& s, const DualVec& a) { return {s * a.x, s * a.y}; }
DualVec operator*(double s, const DualVec& a) { return {s * a.x, s * a.y}; }
Dual dot(const DualVec& a, const DualVec& b) { return a.x * b.x + a.y * b.y; }
Dual cross(const DualVec& a, const DualVec& b) { return a.x * b.y - a.y * b.x; }

/// A segment's value and first three derivatives by t in terms of c_0, c_1, c_2.
struct Derivatives {
  DualVec c, d1, d2, d3;
};

Derivatives cubic(double a, const DualVec& c0, const DualVec& c1, const DualVec& c2, const Dual& t) {
  const DualVec p1 = (1.0 - a) * c0 + a * c1, p2 = a * c1 + (1.0 - a) * c2;
  const Dual u = 1.0 - t;
  const DualVec q0 = p1 - c0, q1 = p2 - p1, q2 = c2 - p2, r0 = q1 - q0, r1 = q2 - q1;
  return {.c = u * u * u * c0 + 3.0 * u * u * t * p1 + 3.0 * u * t * t * p2 + t * t * t * c2,
          .d1 = 3.0 * u * u * q0 + 6.0 * u * t * q1 + 3.0 * t * t * q2,
          .d2 = 6.0 * u * r0 + 6.0 * t * r1,
          .d3 = 6.0 * (r1 - r0)};
}

/// Miura 2022, Eq. (17) in the form of Eq. (29); t is the angle.
Derivatives trigonometric(double a, const DualVec& c0, const DualVec& c1, const DualVec& c2, const Dual& t) {
  const double alpha = 2.0 * a, m = alpha - 1.0;
  const Dual s = sin(t), c = cos(t);
  const DualVec r = c0 - c1, q = c2 - c1;
  const Dual b0 = 1.0 + m * s * s - alpha * s, b2 = 1.0 + m * c * c - alpha * c;
  const Dual sc = 2.0 * s * c, cc = c * c - s * s;
  return {.c = b0 * r + b2 * q + c1,
          .d1 = (m * sc - alpha * c) * r + (alpha * s - m * sc) * q,
          .d2 = (2.0 * m * cc + alpha * s) * r + (alpha * c - 2.0 * m * cc) * q,
          .d3 = (alpha * c - 4.0 * m * sc) * r + (4.0 * m * sc - alpha * s) * q};
}

/// What the row of one segment and its area depend on, seeded with derivatives by all unknowns (e and x of every
/// segment, in this order) and by the parameter t, which comes last.
class Reference {
 public:
  Reference(const ChordChain& chain, const State& state)
      : chain_(chain), m_(chain.segments()), size_(static_cast<Eigen::Index>(3 * m_ + 1)) {
    for (std::size_t i = 0; i <= m_ + 1; ++i)
      e_.push_back({unknown(state.e[i].x(), i, 0), unknown(state.e[i].y(), i, 1)});
    for (std::size_t k = 0; k <= m_; ++k) {
      if (std::isinf(state.x[k]))
        lambda_.push_back(constant(state.x[k] > 0.0 ? 1.0 : 0.0));
      else
        lambda_.push_back(1.0 / (1.0 + exp(-unknown(state.x[k], k, 2))));
    }
  }

  /// The interpolation equation with t from the condition that curvature is stationary there.
  DualVec miss(std::size_t i, Form form, double t_value) const {
    const Dual t{t_value, Eigen::VectorXd::Unit(size_, size_ - 1)};
    const DualVec x = scale(1.0 - lambda_[i - 1], e_[i - 1] - chord(i - 1)) + scale(lambda_[i - 1], e_[i]);
    const DualVec y = scale(1.0 - lambda_[i], e_[i]) + scale(lambda_[i], e_[i + 1] + chord(i));
    if (form == Form::at_start) return x;
    const bool eliminated = form != Form::direct;
    // b_0, b_1 and b_2 are the curves of the unit control points.
    const DualVec zero{constant(0.0), constant(0.0)}, one{constant(1.0), constant(0.0)};
    const Dual b0 = curve(i, one, zero, zero, t).c.x, b1 = curve(i, zero, one, zero, t).c.x,
               b2 = curve(i, zero, zero, one, t).c.x;
    const DualVec implied = -(b0 / b1) * x - b2 / b1 * y;  // Eq. (6)
    const Derivatives d = curve(i, x, eliminated ? implied : e_[i], y, t);
    // kappa' = 0, Eq. (33).
    const Dual stationary = cross(d.d1, d.d3) * dot(d.d1, d.d1) - 3.0 * dot(d.d1, d.d2) * cross(d.d1, d.d2);
    const DualVec value = form == Form::divided ? e_[i] - implied : b0 * x + b1 * e_[i] + b2 * y;
    return resolved(value, stationary);
  }

  /// log of |T_i|.
  Dual log_area(std::size_t i) const {
    const Dual area = cross(e_[i] - e_[i - 1] + chord(i - 1), e_[i + 1] - e_[i] + chord(i));
    return 0.5 * log(area * area);
  }

  /// log of kappa_i(1) / kappa_{i+1}(0) from Eq. (8).
  Dual jump(std::size_t i) const {
    const std::size_t j = chain_.next(i);
    const auto g = [&](std::size_t k) { return std::log((1.0 - chain_.a[k]) / (chain_.a[k] * chain_.a[k])); };
    return log_area(i) + log(1.0 - lambda_[i - 1]) + g(i) - 2.0 * log(lambda_[i]) - log_area(j) - log(lambda_[j]) -
           g(j) + 2.0 * log(1.0 - lambda_[i]);
  }

  Eigen::Index unknowns() const { return size_ - 1; }

 private:
  Dual constant(double value) const { return {value, Eigen::VectorXd::Zero(size_)}; }
  /// Copies over the seam of a closed chain have the index of what they copy; fixed ends have no derivative.
  Dual unknown(double value, std::size_t i, int part) const {
    if (chain_.closed) i = (i + m_ - 1) % m_ + 1;
    if (i == 0 || i > m_ || (!chain_.closed && part == 2 && i == m_)) return constant(value);
    return {value, Eigen::VectorXd::Unit(size_, static_cast<Eigen::Index>(3 * (i - 1)) + part)};
  }
  DualVec chord(std::size_t k) const { return {constant(chain_.chord[k].x()), constant(chain_.chord[k].y())}; }
  static DualVec scale(const Dual& s, const DualVec& v) { return s * v; }
  Derivatives curve(std::size_t i, const DualVec& c0, const DualVec& c1, const DualVec& c2, const Dual& t) const {
    return chain_.basis == BasisKind::cubic ? cubic(chain_.a[i], c0, c1, c2, t)
                                            : trigonometric(chain_.a[i], c0, c1, c2, t);
  }
  /// Puts dt = -(d stationary) / (d stationary / dt) into the derivatives.
  DualVec resolved(DualVec value, const Dual& stationary) const {
    const Eigen::VectorXd dt = -stationary.d / stationary.d(size_ - 1);
    for (Dual* part : {&value.x, &value.y}) {
      const double by_t = part->d(size_ - 1);
      part->d += by_t * dt;
    }
    return value;
  }

  const ChordChain& chain_;
  std::size_t m_;
  Eigen::Index size_;
  std::vector<DualVec> e_;
  std::vector<Dual> lambda_;
};

/// Row `row` of block row `i` of the Jacobian over all (e, x) or, part = 3, over all s.
Eigen::VectorXd dense_row(const Block4& jacobian, std::size_t i, int row, bool of_s) {
  const std::size_t m = jacobian.size();
  const Eigen::Index width = of_s ? 1 : 3;
  Eigen::VectorXd all = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m) * width);
  const auto put = [&](const Block4::Entry& entry, std::size_t column) {
    for (Eigen::Index k = 0; k < width; ++k)
      all(static_cast<Eigen::Index>(column) * width + k) += entry(row, of_s ? 3 : k);
  };
  put(jacobian.diagonal[i], i);
  if (i > 0 || jacobian.cyclic) put(jacobian.lower[i], (i + m - 1) % m);
  if (i + 1 < m || jacobian.cyclic) put(jacobian.upper[i], (i + 1) % m);
  return all;
}

void compare(BasisKind basis, bool closed, Form form, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec2> points;
  std::vector<double> a;
  for (int i = 0; i < 6; ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    points.emplace_back(3 * std::cos(i) + x, 3 * std::sin(i) + y);
    a.push_back(basis == BasisKind::cubic ? random.uniform(0.68, 0.95) : random.uniform(0.52, 0.95));
  }
  const ChordChain chain = make_chain(points, a, closed, basis);
  State state = initial_state(chain);
  const std::size_t m = chain.segments();
  for (std::size_t i = 1; i <= m; ++i) {
    const double x = random.normal(), y = random.normal(), logit = random.normal();
    state.e[i] = 0.2 * chain.size[i] * Vec2(x, y);
    if (closed || i < m) state.x[i] = logit;
  }
  state.close(chain);

  const System system(chain);
  const Setting setting = uniform_setting(chain, form);
  Values values;
  Block4 jacobian;
  std::vector<Right4> right;
  system.evaluate(state, setting, values);
  system.linearise(state, setting, values, jacobian, right);
  const Reference reference(chain, state);
  const auto agree = [&](const Eigen::VectorXd& got, const Dual& want, double unit) {
    const Eigen::VectorXd expected = want.d.head(reference.unknowns()) / unit;
    CHECK((got - expected).norm() <= 1e-9 * (1.0 + expected.norm()));
  };
  // s depends on e: row 3 reads ds = (d log|T|), which turns columns of s into columns of e.
  Eigen::MatrixXd of_s(static_cast<Eigen::Index>(m), reference.unknowns());
  for (std::size_t i = 0; i < m; ++i) of_s.row(static_cast<Eigen::Index>(i)) = -dense_row(jacobian, i, 3, false);
  for (std::size_t i = 1; i <= m; ++i) {
    INFO("segment " << i << ", form " << static_cast<int>(form) << ", closed " << closed);
    const bool clamped = form == Form::direct && (values.t[i] <= 0.0 || values.t[i] >= last_parameter(basis));
    if (!clamped) {
      const DualVec miss = reference.miss(i, form, values.t[i]);
      CHECK(values.miss[i].x() == Approx(miss.x.v / chain.size[i]).epsilon(1e-11).margin(1e-12));
      CHECK(values.miss[i].y() == Approx(miss.y.v / chain.size[i]).epsilon(1e-11).margin(1e-12));
      agree(dense_row(jacobian, i - 1, 0, false), miss.x, chain.size[i]);
      agree(dense_row(jacobian, i - 1, 1, false), miss.y, chain.size[i]);
    }
    agree(of_s.row(static_cast<Eigen::Index>(i) - 1), reference.log_area(i), 1.0);
    if (!closed && i == m) continue;
    const Dual jump = reference.jump(i);
    CHECK(values.jump[i] == Approx(jump.v).epsilon(1e-12).margin(1e-13));
    agree(dense_row(jacobian, i - 1, 2, false) + of_s.transpose() * dense_row(jacobian, i - 1, 2, true), jump, 1.0);
  }
}

}  // namespace

TEST_CASE("the Newton system agrees with automatic differentiation", "[kappa]") {
  for (const BasisKind basis : {BasisKind::cubic, BasisKind::trigonometric})
    for (const bool closed : {true, false})
      for (const Form form : {Form::divided, Form::undivided, Form::direct, Form::at_start})
        for (std::uint64_t seed = 1; seed <= 3; ++seed) compare(basis, closed, form, seed);
}
