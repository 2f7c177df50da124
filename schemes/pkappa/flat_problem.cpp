#include "schemes/pkappa/flat_problem.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "schemes/numerics/bernstein.hpp"
#include "schemes/pkappa/system.hpp"

namespace kappabench::pkappa {
namespace {

/// The number that stands at place `at` of block `block`.
template <Continuity K>
double& number(JointChain& chain, std::size_t block, int at) {
  using L = Layout<K>;
  if (at == L::parameter_at) return chain.t[block];
  if (at >= L::middle_at) return chain.middles[block][at - L::middle_at];
  Joint& joint = chain.joints[block];
  if (at < 2) return joint.position[at];
  if (at < 4) return joint.edge[at - 2];
  if (at < 2 * L::vectors) return joint.second[at - 4];
  return at == 2 * L::vectors ? joint.ratio : joint.shift;
}

template <Continuity K>
class FlatWindow final : public FlatProblem {
 public:
  FlatWindow(const JointChain& chain, const QuadratureRule& rule, const Weights& weights)
      : chain_(chain), system_(rule, weights), energy_(rule), weights_(weights) {
    for (std::size_t k = 0; k < chain.joints.size(); ++k)
      for (int v = 0; v < Layout<K>::multiplier_at; ++v)
        if (is_free<K>(v, chain.freedom[k], k < chain.size())) places_.push_back({k, v});
  }

  [[nodiscard]] Eigen::Index unknowns() const override { return static_cast<Eigen::Index>(places_.size()); }
  [[nodiscard]] Eigen::Index constraints() const override { return 2 * static_cast<Eigen::Index>(chain_.size()); }
  [[nodiscard]] Eigen::VectorXd values_of(const JointChain& chain) const override;
  [[nodiscard]] const JointChain& chain_at(const Eigen::VectorXd& x) override;
  [[nodiscard]] Eigen::VectorXd lower() const override { return bounds(-1.0); }
  [[nodiscard]] Eigen::VectorXd upper() const override { return bounds(1.0); }
  [[nodiscard]] bool is_linear(Eigen::Index i) const override;
  [[nodiscard]] double objective(const Eigen::VectorXd& x) override { return system_.value(chain_at(x)); }
  [[nodiscard]] Eigen::VectorXd gradient(const Eigen::VectorXd& x) override;
  [[nodiscard]] Eigen::MatrixXd hessian(const Eigen::VectorXd& x) override;
  void rows(const Eigen::VectorXd& x, Eigen::VectorXd& residuals, Eigen::MatrixXd& jacobian) override;
  [[nodiscard]] Eigen::VectorXd miss(const Eigen::VectorXd& x) override;
  [[nodiscard]] Eigen::MatrixXd miss_jacobian(const Eigen::VectorXd& x) override;
  [[nodiscard]] double make_feasible(JointChain& chain) override;

 private:
  struct Place {
    std::size_t block;
    int at;
  };
  [[nodiscard]] Eigen::VectorXd bounds(double sign) const;
  void linearise_at(const Eigen::VectorXd& x);

  JointChain chain_;
  ChainSystem<K> system_;
  SegmentEnergy<Layout<K>::degree> energy_;
  Weights weights_;
  std::vector<Place> places_;
  Eigen::VectorXd linearised_;  ///< where system_ stands
};

template <Continuity K>
Eigen::VectorXd FlatWindow<K>::values_of(const JointChain& chain) const {
  JointChain copy = chain;
  Eigen::VectorXd x(unknowns());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Place& p = places_[static_cast<std::size_t>(i)];
    x[i] = number<K>(copy, p.block, p.at);
  }
  return x;
}

template <Continuity K>
const JointChain& FlatWindow<K>::chain_at(const Eigen::VectorXd& x) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Place& p = places_[static_cast<std::size_t>(i)];
    number<K>(chain_, p.block, p.at) = x[i];
  }
  return chain_;
}

template <Continuity K>
Eigen::VectorXd FlatWindow<K>::bounds(double sign) const {
  Eigen::VectorXd b = Eigen::VectorXd::Constant(unknowns(), sign * std::numeric_limits<double>::infinity());
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    const Place& p = places_[static_cast<std::size_t>(i)];
    if (p.at == Layout<K>::parameter_at) b[i] = sign < 0.0 ? chain_.t_least[p.block] : chain_.t_most[p.block];
  }
  return b;
}

template <Continuity K>
bool FlatWindow<K>::is_linear(Eigen::Index i) const {
  const int at = places_[static_cast<std::size_t>(i)].at;
  return at < 2 * Layout<K>::vectors || (at >= Layout<K>::middle_at && at < Layout<K>::parameter_at);
}

template <Continuity K>
void FlatWindow<K>::linearise_at(const Eigen::VectorXd& x) {
  if (linearised_.size() == x.size() && linearised_ == x) return;
  system_.linearise(chain_at(x), {});
  linearised_ = x;
}

template <Continuity K>
Eigen::VectorXd FlatWindow<K>::gradient(const Eigen::VectorXd& x) {
  linearise_at(x);
  Eigen::VectorXd g(unknowns());
  for (Eigen::Index i = 0; i < g.size(); ++i) {
    const Place& p = places_[static_cast<std::size_t>(i)];
    g[i] = 2.0 * system_.gradient()[p.block][p.at];
  }
  return g;
}

template <Continuity K>
Eigen::MatrixXd FlatWindow<K>::hessian(const Eigen::VectorXd& x) {
  linearise_at(x);
  Eigen::MatrixXd h(unknowns(), unknowns());
  for (Eigen::Index i = 0; i < h.rows(); ++i)
    for (Eigen::Index j = 0; j < h.cols(); ++j) {
      const Place &p = places_[static_cast<std::size_t>(i)], &q = places_[static_cast<std::size_t>(j)];
      h(i, j) = 2.0 * system_.entry(p.block, p.at, q.block, q.at);
    }
  return h;
}

template <Continuity K>
void FlatWindow<K>::rows(const Eigen::VectorXd& x, Eigen::VectorXd& residuals, Eigen::MatrixXd& jacobian) {
  using L = Layout<K>;
  constexpr int side = 2 * L::side;
  const JointChain& chain = chain_at(x);
  Eigen::VectorXd r;
  Eigen::Matrix<double, Eigen::Dynamic, SegmentEnergy<L::degree>::size> by_control;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    energy_.rows(polygon<K>(chain, i), chain.t[i], weights_.in(chain.unit(i)), r, by_control);
    const Eigen::Index first = static_cast<Eigen::Index>(i) * r.size();
    if (i == 0) {
      residuals.resize(r.size() * static_cast<Eigen::Index>(chain.size()));
      jacobian.setZero(residuals.size(), unknowns());
    }
    residuals.segment(first, r.size()) = r;
    const Eigen::MatrixXd by_start =
        by_control.template leftCols<side>() * side_derivatives<K>(chain.joints[i], Side::right);
    Eigen::Matrix<double, side, L::joint> mirrored = side_derivatives<K>(chain.joints[i + 1], Side::left), end;
    for (int c = 0; c < L::side; ++c)
      end.template middleRows<2>(2 * c) = mirrored.template middleRows<2>(2 * (L::side - 1 - c));
    const Eigen::MatrixXd by_end = by_control.middleCols(side + L::middle, side) * end;
    for (Eigen::Index j = 0; j < unknowns(); ++j) {
      const Place& p = places_[static_cast<std::size_t>(j)];
      auto column = jacobian.col(j).segment(first, r.size());
      if (p.block == i + 1 && p.at < L::joint) column += by_end.col(p.at);
      if (p.block != i) continue;
      if (p.at < L::joint)
        column += by_start.col(p.at);
      else
        column += by_control.col(p.at == L::parameter_at ? by_control.cols() - 1 : side + p.at - L::middle_at);
    }
  }
}

template <Continuity K>
Eigen::VectorXd FlatWindow<K>::miss(const Eigen::VectorXd& x) {
  const JointChain& chain = chain_at(x);
  Eigen::VectorXd c(constraints());
  for (std::size_t i = 0; i < chain.size(); ++i)
    c.segment<2>(2 * static_cast<Eigen::Index>(i)) =
        polygon<K>(chain, i) * bernstein<Layout<K>::degree>(chain.t[i]) - chain.points[i];
  return c;
}

template <Continuity K>
Eigen::MatrixXd FlatWindow<K>::miss_jacobian(const Eigen::VectorXd& x) {
  linearise_at(x);
  Eigen::MatrixXd a(constraints(), unknowns());
  for (std::size_t i = 0; i < chain_.size(); ++i)
    for (int d = 0; d < 2; ++d)
      for (Eigen::Index j = 0; j < unknowns(); ++j) {
        const Place& p = places_[static_cast<std::size_t>(j)];
        a(2 * static_cast<Eigen::Index>(i) + d, j) = system_.entry(i, Layout<K>::multiplier_at + d, p.block, p.at);
      }
  return a;
}

template <Continuity K>
double FlatWindow<K>::make_feasible(JointChain& chain) {
  for (std::size_t i = 0; i < chain.size(); ++i) chain.t[i] = std::clamp(chain.t[i], chain.t_least[i], chain.t_most[i]);
  return restore_interpolation<K>(chain) ? system_.value(chain) : std::numeric_limits<double>::infinity();
}

}  // namespace

template <Continuity K>
std::unique_ptr<FlatProblem> flat_problem(const JointChain& chain, const QuadratureRule& rule, const Weights& weights) {
  return std::make_unique<FlatWindow<K>>(chain, rule, weights);
}

template std::unique_ptr<FlatProblem> flat_problem<Continuity::c1>(const JointChain&, const QuadratureRule&,
                                                                   const Weights&);
template std::unique_ptr<FlatProblem> flat_problem<Continuity::g1>(const JointChain&, const QuadratureRule&,
                                                                   const Weights&);
template std::unique_ptr<FlatProblem> flat_problem<Continuity::c2>(const JointChain&, const QuadratureRule&,
                                                                   const Weights&);
template std::unique_ptr<FlatProblem> flat_problem<Continuity::g2>(const JointChain&, const QuadratureRule&,
                                                                   const Weights&);

}  // namespace kappabench::pkappa
