#include "metrics/parabola_energy.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "metrics/arc_samples.hpp"
#include "metrics/curvature_profile.hpp"
#include "metrics/node_pieces.hpp"
#include "metrics/statistics.hpp"
#include "schemes/curve/exact_curvature.hpp"

namespace kappabench {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<double> extrema_of(const Segment& segment) {
  std::vector<double> splits = cusps(segment);
  for (const RootBracket& bracket : curvature_extrema(segment).at) splits.push_back(bracket.mid());
  return splits;
}

std::vector<CurvatureSample> over_parameter(const Segment& segment, std::span<const double> splits) {
  std::vector<CurvatureSample> samples;
  for (const ArcSample& s : arc_samples(segment, 0.0, 1.0, splits)) samples.push_back({s.t, s.curvature, s.weight});
  return samples;
}

/// Over normalised arc length of a piece of several parts.
std::vector<CurvatureSample> over_arc_length(const Curve& curve, const CurvatureProfile& profile,
                                             const CentredPiece& piece) {
  const double length = piece.end - piece.start;
  std::vector<CurvatureSample> samples;
  double start = 0.0;
  for (const Part& part : piece.parts) {
    double part_length = 0.0;
    const auto splits = profile.splits(part.segment);
    for (const ArcSample& s : arc_samples(curve.segment(part.segment), part.t0, part.t1, splits)) {
      samples.push_back({(start + s.s) / length, s.curvature, s.weight});
      part_length += s.weight;
    }
    start += part_length;
  }
  return samples;
}

struct Energies {
  std::vector<double> pinned;
  std::vector<double> free;

  void add(std::span<const CurvatureSample> samples, double vertex, bool cusp) {
    if (!cusp && samples.empty()) return;
    pinned.push_back(cusp ? infinite : fit_parabola(samples, vertex).energy);
    free.push_back(cusp ? infinite : fit_parabola(samples, std::nullopt).energy);
  }
};

/// Segments that hold exactly one node strictly inside (Wang 2024, Eq. (10): one piece a segment).
Energies native_energies(const Curve& curve, const CurvatureProfile& profile) {
  const auto n = static_cast<std::size_t>(curve.size());
  std::vector<int> count(n, 0);
  std::vector<double> vertex(n, 0.0);
  for (const Node& node : curve.nodes()) {
    if (node.t <= 0.0 || node.t >= 1.0) continue;
    ++count[static_cast<std::size_t>(node.segment)];
    vertex[static_cast<std::size_t>(node.segment)] = node.t;
  }
  Energies energies;
  for (std::size_t k = 0; k < n; ++k) {
    if (count[k] != 1) continue;
    const int i = static_cast<int>(k);
    energies.add(over_parameter(curve.segment(i), profile.splits(i)), vertex[k], profile.cusp_within(i, 0.0, 1.0));
  }
  return energies;
}

Energies centred_energies(const Curve& curve, const CurvatureProfile& profile) {
  const ArcMap arcs(curve);
  Energies energies;
  for (const CentredPiece& piece : centred_pieces(curve, arcs)) {
    bool cusp = false;
    for (const Part& part : piece.parts) cusp = cusp || profile.cusp_within(part.segment, part.t0, part.t1);
    const double vertex = (piece.node.position - piece.start) / (piece.end - piece.start);
    energies.add(over_arc_length(curve, profile, piece), vertex, cusp);
  }
  return energies;
}

}  // namespace

ParabolaFit fit_parabola(std::span<const CurvatureSample> samples, std::optional<double> vertex) {
  // Columns in v = u - vertex, or in v = 2u - 1, which spans [-1, 1] and keeps the free fit well conditioned.
  const double centre = vertex.value_or(0.5);
  const double scale = vertex ? 1.0 : 2.0;
  const auto rows = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd a(rows, vertex ? 2 : 3);
  Eigen::VectorXd b(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const CurvatureSample& sample = samples[static_cast<std::size_t>(i)];
    const double root = std::sqrt(std::max(0.0, sample.weight));
    const double v = scale * (sample.u - centre);
    a(i, 0) = root;
    a(i, 1) = root * v * v;
    if (!vertex) a(i, 2) = root * v;
    b[i] = root * sample.curvature;
  }
  const Eigen::VectorXd x = a.colPivHouseholderQr().solve(b);
  const double quadratic = x[1] * scale * scale;
  const double linear = vertex ? 0.0 : x[2] * scale;
  const Parabola parabola{x[0] + centre * (quadratic * centre - linear), linear - 2.0 * quadratic * centre, quadratic};
  return {parabola, (a * x - b).squaredNorm()};
}

double parabola_energy(const Segment& segment, const Parabola& parabola) {
  if (!cusps(segment).empty()) return infinite;
  double energy = 0.0;
  for (const CurvatureSample& sample : over_parameter(segment, extrema_of(segment))) {
    const double deviation = sample.curvature - parabola(sample.u);
    energy += sample.weight * deviation * deviation;
  }
  return energy;
}

ParabolaFit best_parabola(const Segment& segment, std::optional<double> vertex) {
  if (!cusps(segment).empty()) return {{undefined, undefined, undefined}, infinite};
  return fit_parabola(over_parameter(segment, extrema_of(segment)), vertex);
}

ParabolaEnergyColumns column::parabola_energy(const std::string& variant, const std::string& what) {
  const std::string stem = "parabola_energy_" + variant;
  const std::string where = what + "; NaN without such a piece, infinite with a cusp in one";
  return {.mean = {stem + "_mean", "1/length", "mean E_p, " + where},
          .max = {stem + "_max", "1/length", "largest E_p, " + where},
          .scaled_mean = {stem + "_scaled_mean", "1", "mean E_p times mean chord, " + where},
          .scaled_max = {stem + "_scaled_max", "1", "largest E_p times mean chord, " + where}};
}

Metric parabola_energy_metric() {
  std::vector<Column> columns;
  for (const auto* of : {&column::parabola_energy_native, &column::parabola_energy_native_free,
                         &column::parabola_energy_centred, &column::parabola_energy_centred_free})
    columns.insert(columns.end(), {of->mean, of->max, of->scaled_mean, of->scaled_max});

  const auto measure = [](const Scheme&, const Fit& fit) {
    const CurvatureProfile profile = curvature_profile(*fit.curve);
    const Energies native = native_energies(*fit.curve, profile);
    const Energies centred = centred_energies(*fit.curve, profile);
    const double chord = mean_chord(fit.input);
    std::vector<Measurement> row;
    const auto add = [&](const ParabolaEnergyColumns& of, const std::vector<double>& energies) {
      using enum Method;
      const double average = mean(energies), most = largest(energies);
      row.insert(row.end(), {of.mean(average, sampled), of.max(most, sampled), of.scaled_mean(chord * average, sampled),
                             of.scaled_max(chord * most, sampled)});
    };
    add(column::parabola_energy_native, native.pinned);
    add(column::parabola_energy_native_free, native.free);
    add(column::parabola_energy_centred, centred.pinned);
    add(column::parabola_energy_centred_free, centred.free);
    return row;
  };
  return {.id = "parabola_energy",
          .title = "Distance of curvature from a parabola",
          .version = 1,
          .columns = std::move(columns),
          .measure = measure};
}

}  // namespace kappabench
