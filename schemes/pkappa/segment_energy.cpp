#include "schemes/pkappa/segment_energy.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <utility>

#include "schemes/numerics/bernstein.hpp"

namespace kappabench::pkappa {
namespace {

template <int Degree>
using Edges = Eigen::Matrix<double, 2, Degree>;

template <int Degree>
Edges<Degree> edges_of(const ControlPolygon<Degree>& control) {
  return control.template rightCols<Degree>() - control.template leftCols<Degree>();
}

/// Adds weight * I to the second derivatives by edge j.
template <int Degree>
void add_edge_hessian(int j, double weight, SegmentNormal<Degree>& out) {
  for (int from = 2 * j; from < 2 * j + 2; ++from) {
    const int to = from + 2;
    out.hessian(from, from) += weight;
    out.hessian(to, to) += weight;
    out.hessian(from, to) -= weight;
    out.hessian(to, from) -= weight;
  }
}

/// Adds (|e_j|^2 - |e_{j+1}|^2)^2, Eq. (4).
template <int Degree>
void add_edges(const Edges<Degree>& e, double weight, SegmentNormal<Degree>& out) {
  for (int j = 0; j + 1 < Degree; ++j) {
    const double r = e.col(j).squaredNorm() - e.col(j + 1).squaredNorm();
    Eigen::Matrix<double, 6, 1> row;
    row << -2.0 * e.col(j), 2.0 * (e.col(j) + e.col(j + 1)), -2.0 * e.col(j + 1);
    out.hessian.template block<6, 6>(2 * j, 2 * j) += weight * row * row.transpose();
    out.gradient.template segment<6>(2 * j) += weight * r * row;
    add_edge_hessian<Degree>(j, 2.0 * weight * r, out);
    add_edge_hessian<Degree>(j + 1, -2.0 * weight * r, out);
  }
}

/// Adds |e_j|^2, Eq. (5).
template <int Degree>
void add_length(const Edges<Degree>& e, double weight, SegmentNormal<Degree>& out) {
  for (int j = 0; j < Degree; ++j) {
    add_edge_hessian<Degree>(j, weight, out);
    out.gradient.template segment<2>(2 * j) -= weight * e.col(j);
    out.gradient.template segment<2>(2 * j + 2) += weight * e.col(j);
  }
}

}  // namespace

template <int Degree>
double edge_energy(const ControlPolygon<Degree>& control) {
  const Edges<Degree> e = edges_of<Degree>(control);
  double sum = 0.0;
  for (int j = 0; j + 1 < Degree; ++j) {
    const double r = e.col(j).squaredNorm() - e.col(j + 1).squaredNorm();
    sum += r * r;
  }
  return sum;
}

template <int Degree>
double length_energy(const ControlPolygon<Degree>& control) {
  return edges_of<Degree>(control).squaredNorm();
}

template <int Degree>
SegmentEnergy<Degree>::SegmentEnergy(const QuadratureRule& rule)
    : rule_(&rule), table_(rule.nodes().size(), size + 2) {}

namespace {

/// sum_j table.col(j) c[j] as one expression, so that it takes one pass.
template <class Table, class Coefficients, std::size_t... J>
auto combine(const Table& table, const Coefficients& c, std::index_sequence<J...>) {
  return (... + (table.col(static_cast<Eigen::Index>(J)) * c[static_cast<Eigen::Index>(J)]));
}

}  // namespace

/// Residuals sqrt(w |P'|) (kappa - Q) with the best parabola; returns E_p, Eq. (3).
template <int Degree>
double SegmentEnergy<Degree>::residuals(const ControlPolygon<Degree>& control, double t) {
  const Eigen::Matrix<double, Degree + 1, 1> x = control.row(0), y = control.row(1);
  const BasisTable<Degree>& basis = rule_->basis<Degree>();
  constexpr auto all = std::make_index_sequence<Degree + 1>{};
  x1_ = combine(basis.first, x, all);
  y1_ = combine(basis.first, y, all);
  x2_ = combine(basis.second, x, all);
  y2_ = combine(basis.second, y, all);
  squared_speed_ = x1_.square() + y1_.square();
  const Column& v2 = squared_speed_;
  // sqrt(w |P'|) takes two roots; the curvature needs |P'| itself.
  root_ = v2.sqrt();
  curvature_ = (x1_ * y2_ - y1_ * x2_) / (v2 * root_);
  root_ = rule_->root_weights() * root_.sqrt();
  offset_ = (rule_->nodes() - t).square();

  auto phi0 = table_.col(size), phi1 = table_.col(size + 1);
  phi0 = root_.matrix();
  phi1 = (root_ * offset_).matrix();
  residual_ = root_ * curvature_;
  parabola_gram_ << phi0.squaredNorm(), phi0.dot(phi1), phi0.dot(phi1), phi1.squaredNorm();
  const Eigen::Vector2d right(phi0.dot(residual_.matrix()), phi1.dot(residual_.matrix()));
  const Eigen::Vector2d best = parabola_gram_.inverse() * right;
  parabola_ = {best[0], best[1]};
  residual_ -= root_ * (best[0] + best[1] * offset_);
  const double energy = residual_.square().sum();
  return std::isfinite(energy) ? energy : std::numeric_limits<double>::infinity();
}

template <int Degree>
EnergyTerms SegmentEnergy<Degree>::terms(const ControlPolygon<Degree>& control, double t) {
  return {residuals(control, t), edge_energy<Degree>(control), length_energy<Degree>(control)};
}

template <int Degree>
VertexParabola SegmentEnergy<Degree>::parabola(const ControlPolygon<Degree>& control, double t) {
  residuals(control, t);
  return parabola_;
}

/// The derivatives of the residuals that `residuals` left, with the parabola held.
template <int Degree>
void SegmentEnergy<Degree>::differentiate(double t) {
  // r = s (kappa - Q), s = sqrt(w |P'|): with v = |P'|, dr/dP' = r P' / (2 v^2) + s (d det/dP' / v^3 - 3 kappa P' /
  // v^2) and dr/dP'' = s d det/dP'' / v^3, det = x' y'' - y' x''.
  const Column& v2 = squared_speed_;
  along_ = (0.5 * residual_ - 3.0 * root_ * curvature_) / v2;
  across_ = root_ / (v2 * v2.sqrt());
  by_x1_ = along_ * x1_ + across_ * y2_;
  by_y1_ = along_ * y1_ - across_ * x2_;
  by_x2_ = -across_ * y1_;
  by_y2_ = across_ * x1_;
  const BasisTable<Degree>& basis = rule_->basis<Degree>();
  for (int j = 0; j <= Degree; ++j) {
    table_.col(2 * j) = (by_x1_ * basis.first.col(j) + by_x2_ * basis.second.col(j)).matrix();
    table_.col(2 * j + 1) = (by_y1_ * basis.first.col(j) + by_y2_ * basis.second.col(j)).matrix();
  }
  table_.col(size - 1) = (2.0 * parabola_.steepness * root_ * (rule_->nodes() - t)).matrix();
}

template <int Degree>
void SegmentEnergy<Degree>::normal(const ControlPolygon<Degree>& control, double t, const Weights& weights,
                                   SegmentNormal<Degree>& out) {
  out.terms = terms(control, t);
  differentiate(t);
  Eigen::Matrix<double, size, 2> by_parabola;
  for (int i = 0; i < size; ++i) {
    const auto column = table_.col(i);
    for (int j = 0; j <= i; ++j) out.hessian(i, j) = out.hessian(j, i) = column.dot(table_.col(j));
    by_parabola(i, 0) = column.dot(table_.col(size));
    by_parabola(i, 1) = column.dot(table_.col(size + 1));
    out.gradient(i) = column.dot(residual_.matrix());
  }
  // The part of the derivatives that the parabola cannot take up; the residual has no other.
  const Eigen::Matrix<double, size, 2> taken = by_parabola * parabola_gram_.inverse();
  out.hessian.noalias() -= taken.lazyProduct(by_parabola.transpose());
  out.hessian *= weights.parabola;
  out.gradient *= weights.parabola;

  const Edges<Degree> e = edges_of<Degree>(control);
  add_edges<Degree>(e, weights.edges, out);
  add_length<Degree>(e, weights.length, out);
}

template <int Degree>
void SegmentEnergy<Degree>::rows(const ControlPolygon<Degree>& control, double t, const Weights& weights,
                                 Eigen::VectorXd& residuals, Eigen::Matrix<double, Eigen::Dynamic, size>& jacobian) {
  this->residuals(control, t);
  differentiate(t);
  const Eigen::Index nodes = table_.rows();
  residuals.setZero(nodes + Degree - 1 + Eigen::Index{2} * Degree);
  jacobian.setZero(residuals.size(), size);
  const auto by_parabola = table_.template rightCols<2>();
  const Eigen::MatrixXd taken = parabola_gram_.inverse() * (by_parabola.transpose() * table_.template leftCols<size>());
  const double parabola_root = std::sqrt(weights.parabola);
  residuals.head(nodes) = parabola_root * residual_.matrix();
  jacobian.topRows(nodes) = parabola_root * (table_.template leftCols<size>() - by_parabola * taken);

  const Edges<Degree> e = edges_of<Degree>(control);
  const double edge_root = std::sqrt(weights.edges), length_root = std::sqrt(weights.length);
  for (int j = 0; j + 1 < Degree; ++j) {
    const Eigen::Index row = nodes + j;
    residuals[row] = edge_root * (e.col(j).squaredNorm() - e.col(j + 1).squaredNorm());
    jacobian.template block<1, 6>(row, 2 * j) << -2.0 * edge_root * e.col(j).transpose(),
        2.0 * edge_root * (e.col(j) + e.col(j + 1)).transpose(), -2.0 * edge_root * e.col(j + 1).transpose();
  }
  for (int j = 0; j < Degree; ++j) {
    const Eigen::Index row = nodes + Degree - 1 + Eigen::Index{2} * j;
    residuals.template segment<2>(row) = length_root * e.col(j);
    jacobian.template block<2, 2>(row, 2 * j).diagonal().setConstant(-length_root);
    jacobian.template block<2, 2>(row, 2 * j + 2).diagonal().setConstant(length_root);
  }
}

template class SegmentEnergy<4>;
template class SegmentEnergy<5>;
template double edge_energy<4>(const ControlPolygon<4>&);
template double edge_energy<5>(const ControlPolygon<5>&);
template double length_energy<4>(const ControlPolygon<4>&);
template double length_energy<5>(const ControlPolygon<5>&);

}  // namespace kappabench::pkappa
