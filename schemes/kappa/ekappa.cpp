#include "schemes/kappa/ekappa.hpp"

#include <utility>

#include "schemes/api/registry.hpp"
#include "schemes/kappa/family.hpp"
#include "schemes/kappa/marks.hpp"

namespace kappabench {
namespace {

ParameterSpec sharpness() {
  return {.name = "a",
          .default_value = 0.8,
          .help = "sharpness of the curvature peaks, where a point does not give its own",
          .least = 2.0 / 3.0,
          .most = 1.0,
          .most_included = false};
}

}  // namespace

SchemeInfo EkappaScheme::describe() {
  std::vector<ParameterSpec> parameters = kappa::iteration_parameters();
  parameters.insert(parameters.begin(), sharpness());
  return {.id = "ekappa",
          .title = "epsilon-kappa-curve, cubic Bernstein basis",
          .citation =
              "Miura, Gobithaasan, Salvi, Wang, Sekine, Usuki, Inoguchi, Kajiwara, epsilon-kappa-curves: "
              "controlled local curvature extrema, The Visual Computer 38, 2022",
          .parameters = std::move(parameters),
          .traits = kappa::family_traits(),
          .version = 3,
          .marks = kappa::marks::of(kappa::SegmentKind::cubic)};
}

EkappaScheme::EkappaScheme(Parameters parameters) : Scheme(describe(), std::move(parameters)) {}

Fit EkappaScheme::solve(const Input& input) const {
  const kappa::Sharpness a = kappa::sharpness_of(input, parameters().real("a"), sharpness());
  if (!a.problem.empty()) return kappa::refusal(input, a.problem);
  return kappa::fit_family(input, kappa::SegmentKind::cubic, a.values, kappa::iteration_of(parameters()));
}

void register_ekappa(Registry& registry) { registry.add<EkappaScheme>(); }

}  // namespace kappabench
