#pragma once

#include <string_view>
#include <vector>

#include "experiments/run/experiment.hpp"
#include "experiments/study/findings.hpp"

namespace kappabench::chen {

/// What the experiments on the figures of Chen et al. 2019 share, besides what those on every paper do.

inline constexpr std::string_view paper = "fpc-2019-chen";

/// The typed drawings of the gallery, stand-ins for Figs. 1 and 8, or those that the context asks for.
[[nodiscard]] std::vector<Drawing> gallery_or(const Context& context);

/// The parameters at which the curve passes point `point`: two for a loop.
[[nodiscard]] std::vector<Node> nodes_of(const Curve& curve, int point);

/// A drawing by a scheme, whose loops are counted by the metric `features`.
struct LoopCase {
  std::string_view drawing, scheme, title;
};
[[nodiscard]] CellJob loops_job(const Context& context, const LoopCase& which);

/// The loops of the case's first curve, and how many of them close at a point. A cell of -1 says that there is none.
struct Loops {
  int cell = -1;
  double points = 0.0, loops = 0.0, at_points = 0.0;

  [[nodiscard]] bool drawn() const { return cell >= 0; }
};
[[nodiscard]] Loops loops_of(const study::Findings& found, const LoopCase& which);

}  // namespace kappabench::chen
