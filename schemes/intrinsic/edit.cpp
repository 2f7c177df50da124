#include "schemes/intrinsic/edit.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "schemes/intrinsic/fixed_knots.hpp"

namespace kappabench::intrinsic {

HermiteFit with_moved_controls(const StandardData& data, const StandardCurve& curve,
                               std::span<const MovedControl> moved, Others others, double p) {
  const int last = curve.basis.size() - 1;
  const int first_unknown = data.start_curvature ? 1 : 0, last_unknown = data.end_curvature ? last - 1 : last;
  const auto refused = [](std::string message) {
    return HermiteFit{Outcome::unsupported_input, std::move(message), std::nullopt, 0, 0.0};
  };
  if (first_unknown >= last_unknown) return refused(fmt::format("{} controls leave none to solve for", last + 1));
  ControlRule rule = rule_for(data, curve.basis, p);
  if (others == Others::kept)
    for (int i = first_unknown + 1; i < last_unknown; ++i) fix(rule, i, curve.controls[static_cast<std::size_t>(i)]);
  for (const MovedControl& m : moved) {
    if (m.control <= first_unknown || m.control >= last_unknown)
      return refused(fmt::format("control {} cannot be moved: controls {} and {} are solved for", m.control,
                                 first_unknown, last_unknown));
    fix(rule, m.control, m.value);
  }
  const FixedKnots knots(curve.basis, std::move(rule));
  const Solved solved = knots.solve(data);
  return judged(data, knots.curve(solved), solved.iterations, solved.converged);
}

}  // namespace kappabench::intrinsic
