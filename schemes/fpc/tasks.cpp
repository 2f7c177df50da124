#include "schemes/fpc/tasks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace kappabench::fpc {
namespace {

/// Of the paper's D = t(t - 1) + 2h(2t - 1), relative to the sum of its terms' sizes: nearer to zero than this, the
/// three conditions of an inflection are dependent to working precision.
constexpr double least_determinant = 1e-9;

double singularity(double t, double h) {
  const double a = t * (t - 1.0), b = 2.0 * h * (2.0 * t - 1.0);
  return std::abs(a + b) / (std::abs(a) + std::abs(b));
}

/// Fills in alpha and beta (Eq. (21)); a line if the loop does not fit.
std::string set_loop(PointTask& task, const PointOptions& own, const Defaults& defaults) {
  const double half = 0.5 * std::min(task.t, 1.0 - task.t);
  const auto size = [half](const std::optional<double>& mine, double common) {
    return mine ? *mine : common > 0.0 ? common : half;
  };
  const double alpha = size(own.alpha, defaults.alpha), beta = size(own.beta, defaults.beta);
  if (!(alpha > 0.0 && alpha < task.t))
    return fmt::format("alpha = {:g} must lie in (0, {:.6g}) for the loop to stay in its segment", alpha, task.t);
  if (!(beta > 0.0 && beta < 1.0 - task.t))
    return fmt::format("beta = {:g} must lie in (0, {:.6g}) for the loop to stay in its segment", beta, 1.0 - task.t);
  task.t1 = task.t - alpha;
  task.t2 = task.t + beta;
  return {};
}

/// Fills in h (Eq. (10)); a line if it cannot be.
std::string set_inflection(PointTask& task, const PointOptions& own, const Defaults& defaults) {
  const double t = task.t;
  task.h = own.h ? *own.h : defaults.h_sign_by_rule ? std::copysign(defaults.h, t <= 0.5 ? 1.0 : -1.0) : defaults.h;
  if (!std::isfinite(task.h) || !admissible_h(t, task.h))
    return fmt::format("h = {:g} must lie outside [{:.6g}, {:.6g}], or the segment has a second inflection", task.h,
                       -0.5 * t, 0.5 * (1.0 - t));
  if (singularity(t, task.h) < least_determinant)
    return fmt::format("h = {:g} is singular: no cubic has an inflection at t = {:.6g} with it; use {:g}", task.h, t,
                       -task.h);
  return {};
}

}  // namespace

Tasks read_tasks(const Input& input, const Defaults& defaults) {
  Tasks result;
  const int n = input.size();
  const auto at = [&](int i) -> const Vec2& { return input.points[static_cast<std::size_t>((i + n) % n)]; };
  for (int i = 0; i < n; ++i) {
    const PointOptions& own = input.options_of(i);
    if (!input.closed && (i == 0 || i == n - 1)) {
      if (own.type.value_or(PointType::regular) != PointType::regular) {
        result.problem = fmt::format("point {} is an end of an open curve and cannot be of type {}; it has no type", i,
                                     name(*own.type));
        return result;
      }
      continue;
    }
    const double arriving = (at(i) - at(i - 1)).norm(), leaving = (at(i + 1) - at(i)).norm();
    PointTask task;
    task.type = own.type.value_or(PointType::regular);
    task.t = task.t1 = task.t2 = arriving / (arriving + leaving);
    std::string problem = task.type == PointType::loop         ? set_loop(task, own, defaults)
                          : task.type == PointType::inflection ? set_inflection(task, own, defaults)
                                                               : std::string();
    if (!problem.empty()) {
      result.problem = fmt::format("point {}, {}: {}", i, name(task.type), problem);
      return result;
    }
    result.tasks.push_back(task);
  }
  return result;
}

}  // namespace kappabench::fpc
