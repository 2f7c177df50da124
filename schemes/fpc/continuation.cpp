#include "schemes/fpc/continuation.hpp"

#include <limits>

#include "schemes/fpc/newton.hpp"
#include "schemes/numerics/arc_length_path.hpp"

namespace kappabench::fpc {
namespace {

constexpr PathLimits limits{
    .least_softness = 1e-25, .most_softness = 1e4, .longest_in_log = 4.0, .shortest_length = 1e-6};

/// The softened equations as ArcLengthPath takes them; joints count in sizes.
class SoftenedEquations {
 public:
  using State = fpc::State;
  using Step = std::vector<Right3>;

  explicit SoftenedEquations(const System& system) : system_(system) {}

  double evaluate(const State& state, double softness) {
    system_.evaluate(state, softness, values_);
    return values_.worst;
  }

  [[nodiscard]] bool solve(const State&, double softness, Step& newton, Step& response) {
    system_.linearise(values_, softness, matrix_, newton);
    system_.by_softness(values_, softness, response);
    right_.resize(newton.size());
    for (std::size_t k = 0; k < right_.size(); ++k) right_[k] << newton[k], response[k];
    if (!solver_.solve(matrix_, right_)) return false;
    for (std::size_t k = 0; k < right_.size(); ++k) {
      // Units change along the path: directions are kept in lengths.
      right_[k].topRows<2>() *= values_.segment[k].unit;
      newton[k] = right_[k].col(0);
      response[k] = right_[k].col(1);
    }
    return true;
  }

  [[nodiscard]] double dot(const Step& a, const Step& b, double start) const {
    const std::vector<double>& size = system_.chain().size;
    double sum = start;
    for (std::size_t k = 0; k < a.size(); ++k)
      sum += a[k].head<2>().dot(b[k].head<2>()) / (size[k] * size[k]) + a[k](2) * b[k](2);
    return sum;
  }

  void advance(const State& from, const Step& step, double factor, State& to) const {
    fpc::advance(system_.chain(), from, step, factor, std::numeric_limits<double>::infinity(), to);
  }

 private:
  const System& system_;
  Values values_;
  Block3 matrix_;
  std::vector<BlockRight<3, 2>> right_;
  BlockTridiagonalSolver<3, 2> solver_;
};

}  // namespace

long follow_path(const System& system, const State& state, double softness, long most, const PathVisitor& visit) {
  SoftenedEquations equations(system);
  return ArcLengthPath(equations, limits).follow(state, softness, true, most, visit);
}

}  // namespace kappabench::fpc
