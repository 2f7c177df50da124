#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpTNLP.hpp>

#include <algorithm>
#include <cmath>

#include "schemes/pkappa/solver.hpp"

namespace kappabench::pkappa {
namespace {

using Ipopt::Index;
using Ipopt::Number;

/// The window for Ipopt: dense Jacobian, Gauss-Newton Hessian of the objective.
class Problem final : public Ipopt::TNLP {
 public:
  Problem(FlatProblem& flat, const Eigen::VectorXd& start) : flat_(flat), start_(start), last_(start) {}

  [[nodiscard]] const Eigen::VectorXd& last() const { return last_; }

  bool get_nlp_info(Index& n, Index& m, Index& jacobian_entries, Index& hessian_entries,
                    IndexStyleEnum& style) override {
    n = static_cast<Index>(flat_.unknowns());
    m = static_cast<Index>(flat_.constraints());
    jacobian_entries = n * m;
    hessian_entries = n * (n + 1) / 2;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* x_l, Number* x_u, Index m, Number* g_l, Number* g_u) override {
    constexpr double unbounded = 1e20;  // Ipopt's infinity
    const Eigen::VectorXd lower = flat_.lower(), upper = flat_.upper();
    for (Index i = 0; i < n; ++i) {
      x_l[i] = std::max(lower[i], -unbounded);
      x_u[i] = std::min(upper[i], unbounded);
    }
    std::fill_n(g_l, m, 0.0);
    std::fill_n(g_u, m, 0.0);
    return true;
  }

  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool, Number*) override {
    std::copy_n(start_.data(), n, x);
    return true;
  }

  bool eval_f(Index n, const Number* x, bool, Number& value) override {
    value = flat_.objective(vector(x, n));
    return std::isfinite(value);
  }

  bool eval_grad_f(Index n, const Number* x, bool, Number* gradient) override {
    Eigen::Map<Eigen::VectorXd>(gradient, n) = flat_.gradient(vector(x, n));
    return std::isfinite(gradient[0]);
  }

  bool eval_g(Index n, const Number* x, bool, Index m, Number* g) override {
    Eigen::Map<Eigen::VectorXd>(g, m) = flat_.miss(vector(x, n));
    return true;
  }

  bool eval_jac_g(Index n, const Number* x, bool, Index m, Index, Index* rows, Index* columns,
                  Number* values) override {
    for (Index r = 0, k = 0; values == nullptr && r < m; ++r)
      for (Index c = 0; c < n; ++c, ++k) {
        rows[k] = r;
        columns[k] = c;
      }
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    if (values != nullptr) Eigen::Map<Rows>(values, m, n) = flat_.miss_jacobian(vector(x, n));
    return true;
  }

  bool eval_h(Index n, const Number* x, bool, Number factor, Index, const Number*, bool, Index, Index* rows,
              Index* columns, Number* values) override {
    const Eigen::MatrixXd h = values != nullptr ? flat_.hessian(vector(x, n)) : Eigen::MatrixXd();
    for (Index r = 0, k = 0; r < n; ++r)
      for (Index c = 0; c <= r; ++c, ++k) {
        if (values != nullptr) {
          values[k] = factor * h(r, c);
          continue;
        }
        rows[k] = r;
        columns[k] = c;
      }
    return true;
  }

  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* x, const Number*, const Number*, Index,
                         const Number*, const Number*, Number, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    last_ = vector(x, n);
  }

 private:
  [[nodiscard]] static Eigen::VectorXd vector(const Number* x, Index n) {
    return Eigen::Map<const Eigen::VectorXd>(x, n);
  }

  FlatProblem& flat_;
  Eigen::VectorXd start_, last_;
};

}  // namespace

/// The interior-point method (as in Wang 2024, Section 6.1) of Ipopt on the constrained problem.
LastIterate run_ipopt(FlatProblem& flat, const Eigen::VectorXd& start, const MinimiseOptions& options) {
  const Ipopt::SmartPtr<Problem> problem = new Problem(flat, start);  // counted by Ipopt
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = IpoptApplicationFactory();
  application->Options()->SetIntegerValue("print_level", 0);
  application->Options()->SetStringValue("sb", "yes");
  application->Options()->SetIntegerValue("max_iter", options.max_iterations);
  application->Options()->SetNumericValue("tol", std::sqrt(options.tolerance));
  application->Initialize();
  const Ipopt::ApplicationReturnStatus status =
      application->OptimizeTNLP(Ipopt::SmartPtr<Ipopt::TNLP>(GetRawPtr(problem)));
  const int iterations = IsValid(application->Statistics()) ? application->Statistics()->IterationCount() : 0;
  return {problem->last(), iterations, status == Ipopt::Solve_Succeeded || status == Ipopt::Solved_To_Acceptable_Level};
}

std::string version_of_ipopt() { return IPOPT_VERSION; }

}  // namespace kappabench::pkappa
