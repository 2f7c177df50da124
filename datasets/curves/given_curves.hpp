#pragma once

#include <optional>
#include <string>
#include <vector>

#include "datasets/curves/curve_file.hpp"
#include "schemes/api/scheme.hpp"

namespace kappabench {

/// A curve of a file and the points that are its own: those of its nodes if it says where they are, else its vertices,
/// where its segments start (and the last one of an open curve ends).
struct GivenCurve {
  CurveRecord record;
  Input own;
  std::vector<Node> own_nodes;
};

/// Curves that were made elsewhere, as a scheme: a fit is the one of them that the points belong to, whatever made it,
/// so that it stands in tables and figures beside fits of other schemes and is held against its claims as they are.
///
/// The points belong to the curve that they are the own points of; else to the one that passes nearest to them, by the
/// largest distance of a point. Its nodes are its own if it meets these points there, as it does if it was fitted to
/// them; else they are where it passes nearest to each point (find_nodes), whichever way it runs, and the residual is
/// the largest distance over the mean chord. Joints claim what the file claims, else what is found (claim_found: G2,
/// else G1, else G0). A curve that does not say whether it is closed is so if the points are and its ends meet.
///
/// Nothing is fitted: `refit` fails, and the time that `fit` took is nobody's.
class GivenCurves final : public Scheme {
 public:
  /// Throws std::invalid_argument, one line, for nodes, marks and joints that no curve can have.
  GivenCurves(std::string id, CurveFile file);

  /// Those that have segments.
  [[nodiscard]] const std::vector<GivenCurve>& curves() const { return curves_; }

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;
  [[nodiscard]] Fit resolve(const Fit& fit, const Edit& edit) const override;

  std::vector<GivenCurve> curves_;
};

}  // namespace kappabench
