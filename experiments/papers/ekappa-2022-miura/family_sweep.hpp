#pragma once

#include <string>
#include <vector>

#include "experiments/run/experiment.hpp"
#include "experiments/study/findings.hpp"

namespace kappabench::miura {

// Fits of many curves by one scheme of the kappa family, counted. The curves themselves are not kept: random inputs
// come back from their seeds, drawings from their files.

/// What |kappa| does where a curve passes a point, judged by the slope of |kappa| on both sides of it and by
/// nothing that the scheme says. `sides` is how far to step, as a part of the way to the segment's ends.
enum class AtPoint { peak, valley, passes };
[[nodiscard]] AtPoint curvature_at(const Curve& curve, const Node& node, double sides = 0.05);

/// What a sweep counts, a row a drawing or a random input: curves by outcome ("straight": all points on one line, no
/// curvature to speak of) ...
inline const study::Quantity curves = study::count_of("curves"), converged = study::count_of("converged"),
                             unsupported = study::count_of("unsupported"), straight = study::count_of("straight");
/// ... and, over the curves that converged and are not straight, the points other than the ends of open curves, those
/// that are pinned, at an inflection or at a minimum by the scheme's report, ...
inline const study::Quantity points = study::count_of("points"), pinned = study::count_of("pinned"),
                             at_inflection = study::count_of("at inflection"), minima = study::count_of("minima");
/// ... by curvature_at, and pinned points where |kappa| nevertheless has a peak at the joint.
inline const study::Quantity peaks{"peaks", "1", Method::sampled}, valleys{"valleys", "1", Method::sampled},
    neither{"neither", "1", Method::sampled}, pinned_peaks{"pinned peaks", "1", Method::sampled};
/// The drawing that a row counts; random inputs have their cell's name.
inline const study::Key counted{"drawing"};

/// For every scheme a sweep over the built-in drawings ("drawings"; curves of at most 100 points) and one over each
/// random family, 3 to 50 points (trigonometric basis: to 15). If the context names datasets, a sweep over each of
/// them instead: "random:uneven:n=12,count=1000" makes a family of its own.
[[nodiscard]] std::vector<CellJob> sweep_jobs(const Context& context, const std::vector<SchemePtr>& schemes);

/// The schemes that the context asks for; by default ekappa with a from 2/3 to 0.95 and ekappa-trig from 0.5 to 0.9.
[[nodiscard]] std::vector<SchemePtr> sharpness_ladder(const Context& context);

/// One cell of a sweep: what its rows add up to.
struct Swept {
  std::string dataset;
  std::string scheme;
  double a;
  study::Rows rows;

  [[nodiscard]] double operator[](const study::Quantity& what) const { return rows.total(what); }
  [[nodiscard]] bool trigonometric() const { return scheme == "ekappa-trig"; }
};
[[nodiscard]] std::vector<Swept> sweeps(const study::Findings& found);

/// The sums over all sweeps with one a, "12.3 % at a = 0.667, ...": what share of the points `part` says.
[[nodiscard]] std::string shares_by_a(const std::vector<Swept>& sweeps, double (*part)(const Swept&));

}  // namespace kappabench::miura
