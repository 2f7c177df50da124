#include <fmt/format.h>
#include <nlopt.hpp>

#include <vector>

#include "schemes/pkappa/solver.hpp"

namespace kappabench::pkappa {
namespace {

struct Problem {
  FlatProblem& flat;
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
LastIterate run_nlopt(FlatProblem& flat, const Eigen::VectorXd& start, const MinimiseOptions& options) {
  Problem problem{flat};
  nlopt::opt slsqp(nlopt::LD_SLSQP, static_cast<unsigned>(start.size()));
  const auto list = [](const Eigen::VectorXd& v) { return std::vector<double>(v.begin(), v.end()); };
  slsqp.set_lower_bounds(list(flat.lower()));
  slsqp.set_upper_bounds(list(flat.upper()));
  slsqp.set_min_objective(Problem::objective, &problem);
  constexpr double feasible = 1e-10;
  slsqp.add_equality_mconstraint(Problem::constraints, &problem,
                                 std::vector<double>(static_cast<std::size_t>(flat.constraints()), feasible));
  slsqp.set_ftol_rel(options.tolerance);
  slsqp.set_maxeval(options.max_iterations);
  std::vector<double> x = list(start);
  double value = 0.0;
  bool converged = false;
  try {
    const nlopt::result result = slsqp.optimize(x, value);
    converged = result == nlopt::SUCCESS || result == nlopt::FTOL_REACHED;
  } catch (const std::exception&) {
    // NLopt throws where rounding stops it; x is then the last iterate.
  }
  return {Eigen::Map<const Eigen::VectorXd>(x.data(), start.size()), problem.evaluations, converged};
}

std::string version_of_nlopt() {
  return fmt::format("{}.{}.{}", nlopt::version_major(), nlopt::version_minor(), nlopt::version_bugfix());
}

}  // namespace kappabench::pkappa
