#include <fmt/format.h>
#include <nlopt.hpp>

#include <cmath>
#include <vector>

#include "schemes/pkappa/flat_problem.hpp"
#include "schemes/pkappa/solver.hpp"

namespace kappabench::pkappa {
namespace {

template <Continuity K>
struct Problem {
  FlatProblem<K> flat;
  int evaluations = 0;

  [[nodiscard]] static Eigen::VectorXd vector(const double* x, unsigned n) {
    return Eigen::Map<const Eigen::VectorXd>(x, static_cast<Eigen::Index>(n));
  }

  static double objective(unsigned n, const double* x, double* gradient, void* self) {
    auto& problem = *static_cast<Problem*>(self);
    const Eigen::VectorXd at = vector(x, n);
    ++problem.evaluations;
    if (gradient != nullptr) Eigen::Map<Eigen::VectorXd>(gradient, at.size()) = problem.flat.gradient(at);
    return problem.flat.objective(at);
  }

  static void constraints(unsigned, double* result, unsigned n, const double* x, double* gradient, void* self) {
    auto& problem = *static_cast<Problem*>(self);
    const Eigen::VectorXd at = vector(x, n), miss = problem.flat.miss(at);
    Eigen::Map<Eigen::VectorXd>(result, miss.size()) = miss;
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    if (gradient != nullptr) Eigen::Map<Rows>(gradient, miss.size(), at.size()) = problem.flat.miss_jacobian(at);
  }
};

}  // namespace

/// SLSQP (Kraft 1988) of NLopt on the constrained problem.
template <Continuity K>
Minimum minimise_nlopt(Chain& chain, const QuadratureRule& rule, const MinimiseOptions& options) {
  Problem<K> problem{FlatProblem<K>(chain, rule, options.weights)};
  const Eigen::VectorXd start = problem.flat.values_of(chain), lower = problem.flat.lower(),
                        upper = problem.flat.upper();
  Minimum minimum{.energy = problem.flat.objective(start)};
  if (options.max_iterations == 0 || !std::isfinite(minimum.energy)) return minimum;

  nlopt::opt slsqp(nlopt::LD_SLSQP, static_cast<unsigned>(start.size()));
  const auto list = [](const Eigen::VectorXd& v) { return std::vector<double>(v.begin(), v.end()); };
  slsqp.set_lower_bounds(list(lower));
  slsqp.set_upper_bounds(list(upper));
  slsqp.set_min_objective(Problem<K>::objective, &problem);
  constexpr double feasible = 1e-10;
  slsqp.add_equality_mconstraint(Problem<K>::constraints, &problem,
                                 std::vector<double>(static_cast<std::size_t>(problem.flat.constraints()), feasible));
  slsqp.set_ftol_rel(options.tolerance);
  slsqp.set_maxeval(options.max_iterations);
  std::vector<double> x = list(start);
  double value = minimum.energy;
  try {
    const nlopt::result result = slsqp.optimize(x, value);
    minimum.converged = result == nlopt::SUCCESS || result == nlopt::FTOL_REACHED;
  } catch (const std::exception&) {
    // NLopt throws where rounding stops it; x is then the last iterate.
  }
  minimum.iterations = problem.evaluations;
  const Eigen::VectorXd last = Eigen::Map<const Eigen::VectorXd>(x.data(), start.size());
  accept_if_better<K>(problem.flat.chain_at(last), rule, options.weights, chain, minimum);
  return minimum;
}

template Minimum minimise_nlopt<Continuity::c1>(Chain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise_nlopt<Continuity::g1>(Chain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise_nlopt<Continuity::c2>(Chain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise_nlopt<Continuity::g2>(Chain&, const QuadratureRule&, const MinimiseOptions&);

std::string version_of_nlopt() {
  return fmt::format("{}.{}.{}", nlopt::version_major(), nlopt::version_minor(), nlopt::version_bugfix());
}

}  // namespace kappabench::pkappa
