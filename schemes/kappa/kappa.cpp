#include "schemes/kappa/kappa.hpp"

#include <utility>

#include "schemes/api/registry.hpp"
#include "schemes/kappa/family.hpp"
#include "schemes/kappa/marks.hpp"

namespace kappabench {

SchemeInfo KappaScheme::describe() {
  return {.id = "kappa",
          .title = "kappa-curve: quadratic pieces that peak in curvature at the points",
          .citation =
              "Yan, Schiller, Wilensky, Carr, Schaefer, kappa-curves: interpolation at local maximum "
              "curvature, ACM TOG 36(4), 129, 2017",
          .parameters = kappa::iteration_parameters(),
          .traits = kappa::family_traits(),
          .version = 3,
          .marks = kappa::marks::of(kappa::SegmentKind::quadratic)};
}

KappaScheme::KappaScheme(Parameters parameters) : Scheme(describe(), std::move(parameters)) {}

Fit KappaScheme::solve(const Input& input) const {
  const std::vector<double> a(input.points.size(), 2.0 / 3.0);
  return kappa::fit_family(input, kappa::SegmentKind::quadratic, a, kappa::iteration_of(parameters()));
}

void register_kappa(Registry& registry) { registry.add<KappaScheme>(); }

}  // namespace kappabench
