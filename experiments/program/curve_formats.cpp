#include "experiments/program/curve_formats.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <stdexcept>

#include "schemes/api/curve_json.hpp"
#include "schemes/curve/arc_length.hpp"

namespace kappabench {

namespace {

constexpr int samples_per_segment = 33;

std::string csv(const std::vector<Fit>& fits) {
  std::string text = "curve,segment,t,x,y,s,kappa\n";
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (!fits[i].curve) continue;
    const Curve& curve = *fits[i].curve;
    const CurveSamples samples = sample(curve, samples_per_segment, 2);
    double start = 0.0;
    for (int k = 0; k < curve.size(); ++k) {
      const auto jets = samples.of_segment(k);
      for (std::size_t j = 0; j < jets.size(); ++j) {
        const double s = start + arc_length(curve.segment(k), 0.0, samples.t[j], 1e-9);
        text += fmt::format("{},{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", i, k, samples.t[j],
                            jets[j].position().x(), jets[j].position().y(), s, curvature(jets[j]));
      }
      start += arc_length(curve.segment(k), 0.0, 1.0, 1e-9);
    }
  }
  return text;
}

/// "converged", "converged, long_span", ...
std::string outcome_words(const Report& report) {
  std::string words{name(report.outcome)};
  for (const auto& warning : report.warnings) words += ", " + warning.first;
  return words;
}

std::string xy(const std::vector<Fit>& fits) {
  std::string text;
  for (const Fit& fit : fits) {
    if (!fit.curve) continue;
    if (!text.empty()) text += "\n";
    text += fmt::format("# {}\n", outcome_words(fit.report));
    const CurveSamples samples = sample(*fit.curve, samples_per_segment, 0);
    for (int k = 0; k < fit.curve->size(); ++k)
      for (const Jet& jet : samples.of_segment(k).subspan(k == 0 ? 0 : 1))
        text += fmt::format("{:.17g} {:.17g}\n", jet.position().x(), jet.position().y());
  }
  return text;
}

/// Path data of one segment: exact for polynomials up to cubics, else cubic pieces that match position and tangent.
std::string svg_path(const Segment& segment) {
  const ExactForm form = segment.exact();
  const auto* polynomial = std::get_if<PolynomialForm>(&form);
  const auto pair = [](const Vec2& p) { return fmt::format("{:.17g} {:.17g}", p.x(), p.y()); };
  if (polynomial != nullptr && polynomial->control_points.size() <= 4) {
    constexpr std::string_view commands = "LQC";
    std::string path(1, commands[polynomial->control_points.size() - 2]);
    for (std::size_t j = 1; j < polynomial->control_points.size(); ++j)
      path += " " + pair(polynomial->control_points[j]);
    return path;
  }
  constexpr int pieces = 16;
  std::string path;
  for (int j = 0; j < pieces; ++j) {
    const double h = 1.0 / pieces;
    const Jet from = segment.jet(j * h, 1), to = segment.jet((j + 1) * h, 1);
    path += fmt::format("C {} {} {} ", pair(from.d[0] + h / 3.0 * from.d[1]), pair(to.d[0] - h / 3.0 * to.d[1]),
                        pair(to.d[0]));
  }
  return path;
}

std::string svg(const std::vector<Fit>& fits) {
  Eigen::AlignedBox2d box;
  for (const Fit& fit : fits) {
    for (const Vec2& p : fit.input.points) box.extend(p);
    if (!fit.curve) continue;
    for (const Jet& jet : sample(*fit.curve, samples_per_segment, 0).jets) box.extend(jet.position());
  }
  const double size = box.sizes().maxCoeff();
  const double margin = 0.05 * size, stroke = 0.004 * size;
  // y points up in the drawing and down in SVG.
  std::string text = fmt::format(
      R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="{} {} {} {}"><g transform="scale(1,-1)" fill="none" stroke-width="{}">)svg"
      "\n",
      box.min().x() - margin, -box.max().y() - margin, box.sizes().x() + 2.0 * margin, box.sizes().y() + 2.0 * margin,
      stroke);
  for (const Fit& fit : fits) {
    if (fit.curve) {
      const Vec2 start = fit.curve->start();
      std::string path = fmt::format("M {:.17g} {:.17g}", start.x(), start.y());
      for (const SegmentPtr& segment : fit.curve->segments()) path += " " + svg_path(*segment);
      const bool converged = fit.report.outcome == Outcome::converged;
      text += fmt::format(R"(<path d="{}{}" stroke="{}"{}><title>{}</title></path>)"
                          "\n",
                          path, fit.curve->closed() ? " Z" : "", converged ? "#0072b2" : "#d55e00",
                          converged ? "" : fmt::format(R"( stroke-dasharray="{}")", 4.0 * stroke),
                          outcome_words(fit.report));
    }
    // Dots are strokes without length, so that who reads the curves back finds nothing else.
    std::string dots;
    for (const Vec2& p : fit.input.points) dots += fmt::format("M {} {} h 0 ", p.x(), p.y());
    text += fmt::format(R"(<path d="{}" stroke="black" stroke-linecap="round" stroke-width="{}"/>)"
                        "\n",
                        dots, 4.0 * stroke);
  }
  return text + "</g></svg>\n";
}

}  // namespace

std::string format_for(const std::filesystem::path& file, std::string_view asked) {
  if (!asked.empty()) return std::string(asked);
  const std::string ending = file.extension().string();
  if (ending.empty()) return "json";
  for (const std::string_view known : {"json", "csv", "svg", "xy"})
    if (ending.substr(1) == known) return std::string(known);
  throw std::invalid_argument(
      fmt::format("{}: the ending is no format; use .json, .csv, .svg or .xy, or give --format", file.string()));
}

std::string format_fits(std::string_view format, const Scheme& scheme, const std::vector<Fit>& fits) {
  if (format == "json") return curves_json(scheme, fits);
  if (format == "csv") return csv(fits);
  if (format == "svg") return svg(fits);
  if (format == "xy") return xy(fits);
  throw std::invalid_argument(fmt::format("unknown format '{}'; known are json, csv, svg, xy", format));
}

}  // namespace kappabench
