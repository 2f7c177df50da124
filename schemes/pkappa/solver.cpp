#include "schemes/pkappa/solver.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace kappabench::pkappa {

std::vector<std::string> solver_names() {
  std::vector<std::string> names{"lm", "ceres", "nlopt"};
#ifdef KAPPABENCH_WITH_IPOPT
  names.emplace_back("ipopt");
#endif
  return names;
}

std::map<std::string, std::string> solver_libraries() {
  std::map<std::string, std::string> libraries{{"ceres", version_of_ceres()}, {"nlopt", version_of_nlopt()}};
#ifdef KAPPABENCH_WITH_IPOPT
  libraries["ipopt"] = version_of_ipopt();
#endif
  return libraries;
}

Solver solver_named(std::string_view name) {
  if (name == "lm") return Solver::lm;
  if (name == "ceres") return Solver::ceres;
  if (name == "nlopt") return Solver::nlopt;
  if (name == "ipopt") return Solver::ipopt;
  throw std::logic_error("solver_named: unknown solver");
}

namespace {

LastIterate run(Solver solver, FlatProblem& problem, const Eigen::VectorXd& start, const MinimiseOptions& options) {
  switch (solver) {
    case Solver::ceres:
      return run_ceres(problem, start, options);
    case Solver::nlopt:
      return run_nlopt(problem, start, options);
#ifdef KAPPABENCH_WITH_IPOPT
    case Solver::ipopt:
      return run_ipopt(problem, start, options);
#endif
    default:
      throw std::logic_error("minimise: unknown solver");
  }
}

/// By a general optimiser: what it ends with, made feasible, becomes `chain` if its energy is less; else the run counts
/// as not converged.
Minimum minimise_flat(Solver solver, FlatProblem& problem, JointChain& chain, const MinimiseOptions& options) {
  const Eigen::VectorXd start = problem.values_of(chain);
  Minimum minimum{.energy = problem.objective(start)};
  if (options.max_iterations == 0 || !std::isfinite(minimum.energy)) return minimum;
  const LastIterate last = run(solver, problem, start, options);
  minimum.iterations = last.iterations;
  minimum.converged = last.converged;
  if (last.x.size() == 0) return minimum;
  JointChain found = problem.chain_at(last.x);
  const double energy = problem.make_feasible(found);
  if (energy < minimum.energy) {
    chain = std::move(found);
    minimum.energy = energy;
  } else {
    minimum.converged = false;
  }
  return minimum;
}

}  // namespace

template <Continuity K>
Minimum minimise(Solver solver, JointChain& chain, const QuadratureRule& rule, const MinimiseOptions& options) {
  if (solver == Solver::lm) return minimise_lm<K>(chain, rule, options);
  return minimise_flat(solver, *flat_problem<K>(chain, rule, options.weights), chain, options);
}

template Minimum minimise<Continuity::c1>(Solver, JointChain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise<Continuity::g1>(Solver, JointChain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise<Continuity::c2>(Solver, JointChain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise<Continuity::g2>(Solver, JointChain&, const QuadratureRule&, const MinimiseOptions&);

}  // namespace kappabench::pkappa
