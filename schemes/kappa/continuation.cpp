#include "schemes/kappa/continuation.hpp"

#include <cmath>
#include <utility>

#include "schemes/numerics/arc_length_path.hpp"

namespace kappabench::kappa {
namespace {

constexpr PathLimits limits{
    .least_softness = 1e-9, .most_softness = 1e4, .longest_in_log = 2.0, .shortest_length = 1e-5};
constexpr double difference = 1e-4;  ///< step of the numerical derivative by log softness

/// The softened equations as ArcLengthPath takes them; e counts in units of the point's size.
class SoftenedEquations {
 public:
  using State = kappa::State;
  using Step = std::vector<Right4>;

  SoftenedEquations(const System& system, Setting setting) : system_(system), setting_(std::move(setting)) {}

  [[nodiscard]] const Values& values() const { return values_; }

  double evaluate(const State& state, double softness) {
    setting_.softness = softness;
    system_.evaluate(state, setting_, values_);
    return values_.residual;
  }

  [[nodiscard]] bool solve(const State& state, double softness, Step& newton, Step& response) {
    setting_.softness = softness;
    system_.linearise(state, setting_, values_, jacobian_, newton);
    setting_.softness *= std::exp(difference);
    system_.evaluate(state, setting_, shifted_);
    right_.resize(newton.size());
    response.resize(newton.size());
    for (std::size_t i = 1; i <= right_.size(); ++i) {
      right_[i - 1].col(0) = newton[i - 1];
      const Vec2 miss = (shifted_.miss[i] - values_.miss[i]) / difference;
      right_[i - 1].col(1) << -miss.x(), -miss.y(), -(shifted_.bend[i] - values_.bend[i]) / difference, 0.0;
    }
    if (!solver_.solve(jacobian_, right_)) return false;
    for (std::size_t k = 0; k < right_.size(); ++k) {
      newton[k] = right_[k].col(0);
      response[k] = right_[k].col(1);
    }
    return true;
  }

  [[nodiscard]] double dot(const Step& a, const Step& b, double start) const {
    const std::vector<double>& size = system_.chain().size;
    double sum = start;
    for (std::size_t k = 0; k < a.size(); ++k)
      sum += a[k].head<2>().dot(b[k].head<2>()) / (size[k + 1] * size[k + 1]) + a[k](2) * b[k](2);
    return sum;
  }

  void advance(const State& from, const Step& step, double factor, State& to) const {
    const Chain& chain = system_.chain();
    const std::size_t m = chain.segments();
    to = from;
    for (std::size_t i = 1; i <= m; ++i) {
      to.e[i] += factor * step[i - 1].head<2>();
      if (chain.closed || i < m) to.x[i] += factor * step[i - 1](2);
    }
    to.close(chain);
  }

 private:
  const System& system_;
  Setting setting_;
  Values values_, shifted_;
  Block4 jacobian_;
  std::vector<BlockRight<4, 2>> right_;
  BlockTridiagonalSolver<4, 2> solver_;
};

}  // namespace

long follow_path(const System& system, const State& state, const Setting& setting, bool down, long most,
                 const PathVisitor& visit) {
  SoftenedEquations equations(system, setting);
  ArcLengthPath path(equations, limits);
  return path.follow(state, setting.softness, down, most,
                     [&](const State& at, double softness) { return visit(at, equations.values(), softness); });
}

}  // namespace kappabench::kappa
