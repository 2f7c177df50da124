// @TITLE@.
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "schemes/api/registry.hpp"
#include "schemes/api/scheme.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/spans.hpp"

namespace kappabench {
namespace {

/// TODO: your idea goes here. This one, of Catmull and Rom, takes the chord between the two neighbours.
Vec2 tangent(const Input& input, std::size_t i, double tension) {
  const std::vector<Vec2>& p = input.points;
  const std::size_t n = p.size();
  if (!input.closed && i == 0) return p[1] - p[0];
  if (!input.closed && i == n - 1) return p[n - 1] - p[n - 2];
  return tension * (p[(i + 1) % n] - p[(i + n - 1) % n]);
}

class @CLASS@ final : public Scheme {
 public:
  /// TODO: what it is, which choices it leaves to the user, and what you claim: `kappabench check @NAME@` tries it.
  static SchemeInfo describe() {
    return {.id = "@NAME@",
            .title = "@TITLE@",
            .citation = "TODO: authors, title, venue, year",
            .parameters = {{.name = "tension",
                            .default_value = 0.5,
                            .help = "length of the tangents over the chord between the neighbours",
                            .least = 0.0,
                            .most = 1.0}},
            .traits = {.fewest_open_points = 2, .continuity = Continuity::c1, .locality = 2}};
  }

  explicit @CLASS@(Parameters parameters) : Scheme(describe(), std::move(parameters)) {}

 private:
  /// The input has enough points, all finite, no two consecutive ones alike. Segments are Bézier here; schemes/segments
  /// has other kinds.
  [[nodiscard]] Fit solve(const Input& input) const override {
    const double tension = parameters().real("tension");
    const std::size_t n = input.points.size();
    std::vector<SpanPieces> spans;
    for (std::size_t i = 0; i + (input.closed ? 0 : 1) < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const Vec2 &p = input.points[i], &q = input.points[j];
      const std::array<Vec2, 4> controls{p, p + tangent(input, i, tension) / 3.0, q - tangent(input, j, tension) / 3.0, q};
      spans.push_back({{std::make_shared<PolynomialSegment>(controls)}, Continuity::c1, Continuity::c1});
    }
    return {.input = input,
            .curve = curve_of_spans(std::move(spans), input.closed),
            .report = {.outcome = Outcome::converged}};
  }
};

}  // namespace
@REGISTRATION@
