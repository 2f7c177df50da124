#include "schemes/pkappa/solver.hpp"

#include <algorithm>
#include <stdexcept>

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

template <Continuity K>
Minimum minimise(Solver solver, Chain& chain, const QuadratureRule& rule, const MinimiseOptions& options) {
  switch (solver) {
    case Solver::ceres:
      return minimise_ceres<K>(chain, rule, options);
    case Solver::nlopt:
      return minimise_nlopt<K>(chain, rule, options);
#ifdef KAPPABENCH_WITH_IPOPT
    case Solver::ipopt:
      return minimise_ipopt<K>(chain, rule, options);
#endif
    default:
      return minimise_lm<K>(chain, rule, options);
  }
}

template Minimum minimise<Continuity::c1>(Solver, Chain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise<Continuity::g1>(Solver, Chain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise<Continuity::c2>(Solver, Chain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise<Continuity::g2>(Solver, Chain&, const QuadratureRule&, const MinimiseOptions&);

}  // namespace kappabench::pkappa
