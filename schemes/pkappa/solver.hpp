#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "schemes/pkappa/flat_problem.hpp"

namespace kappabench::pkappa {

/// What minimises a window.
enum class Solver { lm, ceres, nlopt, ipopt };

/// The solvers of this build: "lm", "ceres", "nlopt", and "ipopt" where it was found at configure time.
[[nodiscard]] std::vector<std::string> solver_names();
/// The libraries behind them, and their versions.
[[nodiscard]] std::map<std::string, std::string> solver_libraries();
[[nodiscard]] Solver solver_named(std::string_view name);

struct MinimiseOptions {
  Weights weights;
  int max_iterations = 200;
  /// Stops when the model promises a relative decrease of the weighted energy of less than this.
  double tolerance = 1e-12;
  /// Of lm: small near a minimum, where full steps are right.
  double first_damping = 1e-3;
};

struct Minimum {
  double energy = 0.0;    ///< weighted
  double decrease = 0.0;  ///< the relative decrease that the model promised last (lm)
  int iterations = 0;
  bool converged = false;
};

/// Minimises the weighted energy over the chain's unknowns (Wang 2024, Eqs. (6) to (8)). `chain` must interpolate and
/// have finite energy; it interpolates afterwards and is not worse.
template <Continuity K>
Minimum minimise(Solver solver, JointChain& chain, const QuadratureRule& rule, const MinimiseOptions& options);

/// The same by each solver, and its version; the declarations are for solver.cpp.
template <Continuity K>
Minimum minimise_lm(JointChain& chain, const QuadratureRule& rule, const MinimiseOptions& options);

/// Where a general optimiser ended.
struct LastIterate {
  Eigen::VectorXd x;  ///< empty if it has none
  int iterations;
  bool converged;
};
[[nodiscard]] LastIterate run_ceres(FlatProblem& problem, const Eigen::VectorXd& start, const MinimiseOptions& options);
[[nodiscard]] LastIterate run_nlopt(FlatProblem& problem, const Eigen::VectorXd& start, const MinimiseOptions& options);
[[nodiscard]] LastIterate run_ipopt(FlatProblem& problem, const Eigen::VectorXd& start, const MinimiseOptions& options);
[[nodiscard]] std::string version_of_ceres();
[[nodiscard]] std::string version_of_nlopt();
[[nodiscard]] std::string version_of_ipopt();

}  // namespace kappabench::pkappa
