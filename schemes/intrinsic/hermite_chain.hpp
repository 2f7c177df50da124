#pragma once

#include <vector>

#include "schemes/api/input.hpp"
#include "schemes/intrinsic/solve.hpp"

namespace kappabench::intrinsic {

enum class HeadingRule { circle, bisector };
enum class CurvatureRule { clothoid, circle };

/// How headings and curvatures that nobody gave are estimated.
struct Estimates {
  HeadingRule heading;
  int rounds;  ///< of relaxation
  CurvatureRule curvature;
};

/// The direction of the curve at every point, radians: the point's option `tangent`, else that of the circle through
/// the point and its neighbours, or the bisector of the legs' directions. At an open end the direction that makes the
/// last span's end angles equal; for two points the chord's. The legs must not turn straight back.
[[nodiscard]] std::vector<double> headings_of(const Input& input, HeadingRule rule);

/// Hermite data of every span, without curvatures but for those the options of the points give.
[[nodiscard]] std::vector<HermiteData> spans_with_headings(const Input& input, const std::vector<double>& headings);

/// Turns the headings that nobody gave so that the G1 clothoids of the spans on both sides come to agree in curvature:
/// one Newton step at every point with its neighbours held, all at once, `rounds` times. Each round makes a heading
/// depend on one more point on either side, and about halves the disagreement; in the limit all spans are clothoids.
void relax_headings(const Input& input, std::vector<double>& headings, int rounds);

/// Gives the points that have none a curvature, the same on both sides: `clothoid` takes it from the G1 clothoids of
/// the two spans: the larger where curvature rises before the point and falls after it, the smaller where it falls and
/// then rises, so that neither span loses its monotone solution, and elsewhere the mean, which may lose one. `circle`
/// is that of the circle through the point and its neighbours. A span at an open end takes what its inner neighbour
/// has, and becomes the clothoid that fits: its end's heading changes, if it was not given.
void estimate_curvatures(const Input& input, std::vector<HermiteData>& spans, CurvatureRule rule);

struct SpanFit {
  HermiteFit fit;
  Trend trend;
  bool fell_back;        ///< not what the settings ask for
  bool keeps_curvature;  ///< has the curvatures of the data at its ends
};

/// One span. Where the settings find nothing, and it may fall back, the fewest extrema that fixed knots give: p of 0,
/// +-0.5 and +-1 on the settings' knots, the least varying of those with equal numbers; and where they find nothing,
/// either, the G1 curve.
[[nodiscard]] SpanFit fit_span(const HermiteData& data, const Settings& settings, bool may_fall_back);

}  // namespace kappabench::intrinsic
