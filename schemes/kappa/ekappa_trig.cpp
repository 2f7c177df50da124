#include "schemes/kappa/ekappa_trig.hpp"

#include <utility>

#include "schemes/api/registry.hpp"
#include "schemes/kappa/family.hpp"
#include "schemes/kappa/marks.hpp"

namespace kappabench {
namespace {

ParameterSpec sharpness() {
  return {.name = "a",
          .default_value = 0.75,
          .help = "sharpness of the curve at the points, where a point does not give its own",
          .least = 0.5,
          .most = 1.0,
          .most_included = false};
}

}  // namespace

SchemeInfo EkappaTrigScheme::describe() {
  std::vector<ParameterSpec> parameters = kappa::iteration_parameters();
  parameters.insert(parameters.begin(), sharpness());
  return {.id = "ekappa-trig",
          .title = "epsilon-kappa-curve, quadratic trigonometric basis",
          .citation =
              "Miura, Gobithaasan, Salvi, Wang, Sekine, Usuki, Inoguchi, Kajiwara, epsilon-kappa-curves: "
              "controlled local curvature extrema, The Visual Computer 38, 2022",
          .parameters = std::move(parameters),
          .traits = kappa::family_traits(),
          .version = 3,
          .marks = kappa::marks::of(kappa::SegmentKind::trigonometric)};
}

EkappaTrigScheme::EkappaTrigScheme(Parameters parameters) : Scheme(describe(), std::move(parameters)) {}

Fit EkappaTrigScheme::solve(const Input& input) const {
  const kappa::Sharpness a = kappa::sharpness_of(input, parameters().real("a"), sharpness());
  if (!a.problem.empty()) return kappa::refusal(input, a.problem);
  return kappa::fit_family(input, kappa::SegmentKind::trigonometric, a.values, kappa::iteration_of(parameters()));
}

void register_ekappa_trig(Registry& registry) { registry.add<EkappaTrigScheme>(); }

}  // namespace kappabench
