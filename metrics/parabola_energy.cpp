#include "metrics/parabola_energy.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "metrics/arc_samples.hpp"
#include "metrics/curvature_profile.hpp"
#include "metrics/node_pieces.hpp"
#include "metrics/panel_rule.hpp"
#include "metrics/statistics.hpp"
#include "schemes/curve/exact_curvature.hpp"

namespace kappabench {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int most_rounds = 10;  // of halving panels

std::vector<double> extrema_of(const Segment& segment) {
  std::vector<double> splits = cusps(segment);
  for (const RootBracket& bracket : curvature_extrema(segment).at) splits.push_back(bracket.mid());
  return splits;
}

/// A stretch of a segment, and where to split quadrature in it.
struct Stretch {
  const Segment* segment;
  double t0;
  double t1;
  std::vector<double> splits;
};

/// Stretches one after the other with their samples. The parabola's variable is t, or arc length over `length`.
struct SampledPiece {
  std::vector<Stretch> stretches;
  std::optional<double> length{};

  std::vector<ArcQuadrature> parts{};
  std::vector<CurvatureSample> samples{};

  void sample() {
    parts.clear();
    samples.clear();
    double start = 0.0;
    for (const Stretch& stretch : stretches) {
      parts.push_back(arc_quadrature(*stretch.segment, stretch.t0, stretch.t1, stretch.splits));
      for (const ArcSample& s : parts.back().samples)
        samples.push_back({length ? (start + s.s) / *length : s.t, s.curvature, s.weight});
      start += parts.back().length.value;
    }
  }
};

/// Integral of (kappa - Q)^2 ds over panel `k` of a part whose first sample is number `first` of the piece.
Estimate panel_energy(const SampledPiece& piece, const ArcQuadrature& part, std::size_t first, std::size_t k,
                      const Parabola& parabola) {
  double kronrod = 0.0;
  double gauss = 0.0;
  double rounding = 0.0;
  for (std::size_t i = k * PanelRule::count; i < (k + 1) * PanelRule::count; ++i) {
    const ArcSample& sample = part.samples[i];
    const double miss = std::abs(sample.curvature - parabola(piece.samples[first + i].u));
    kronrod += sample.weight * miss * miss;
    gauss += sample.gauss_weight * miss * miss;
    // The parabola is as large as the curvature that it follows, and rounded as that is.
    rounding += sample.weight * 4.0 * sample.rounding * (miss + sample.rounding);
  }
  return {kronrod, kronrod_error(kronrod, gauss), rounding};
}

/// The energy with its error. The panels become the splits of the piece; those with an error above rounding and above
/// their share of 1e-11 of the energy are halved, and `refined` says whether there were any.
Estimate energy_of(SampledPiece& piece, const Parabola& parabola, bool& refined) {
  std::vector<Estimate> panels;
  std::size_t first = 0;
  for (const ArcQuadrature& part : piece.parts) {
    for (std::size_t k = 0; k + 1 < part.bounds.size(); ++k)
      panels.push_back(panel_energy(piece, part, first, k, parabola));
    first += part.samples.size();
  }
  Estimate energy;
  for (const Estimate& panel : panels) energy += panel;

  const double share = 1e-11 * energy.value / static_cast<double>(panels.size());
  auto panel = panels.begin();
  refined = false;
  for (std::size_t j = 0; j < piece.parts.size(); ++j) {
    const std::vector<double>& bounds = piece.parts[j].bounds;
    std::vector<double>& splits = piece.stretches[j].splits;
    splits = bounds;
    for (std::size_t k = 0; k + 1 < bounds.size(); ++k, ++panel) {
      if (!(panel->error > panel->rounding && panel->error > share)) continue;
      splits.push_back(0.5 * (bounds[k] + bounds[k + 1]));
      refined = true;
    }
  }
  return energy;
}

/// The parabola of least energy, over panels that are halved until that energy is known to 1e-10; NaN if they do not
/// get there.
ParabolaFit fit_to_accuracy(SampledPiece& piece, std::optional<double> vertex) {
  for (int round = 0;; ++round) {
    if (piece.samples.empty() || round > 0) piece.sample();
    if (piece.samples.empty()) return {{undefined, undefined, undefined}, undefined};
    ParabolaFit fit = fit_parabola(piece.samples, vertex);
    bool refined = false;
    const Estimate energy = energy_of(piece, fit.parabola, refined);
    if (refined && round < most_rounds) continue;
    if (std::isnan(energy.to_accuracy())) fit.energy = undefined;
    return fit;
  }
}

struct Energies {
  std::vector<double> pinned;
  std::vector<double> free;

  void add(SampledPiece piece, double vertex, bool diverges) {
    pinned.push_back(diverges ? infinite : fit_to_accuracy(piece, vertex).energy);
    free.push_back(diverges ? infinite : fit_to_accuracy(piece, std::nullopt).energy);
  }
};

/// Is there a cusp in it, or an end at rest where curvature diverges?
bool diverges(const Curve& curve, const CurvatureProfile& profile, const ArcMap& arcs, const Part& part) {
  const Segment& segment = curve.segment(part.segment);
  const double length = arcs.segment_length(part.segment);
  return profile.cusp_within(part.segment, part.t0, part.t1) ||
         (part.t0 == 0.0 && diverges_at_end(segment, 0.0, length)) ||
         (part.t1 == 1.0 && diverges_at_end(segment, 1.0, length));
}

/// Segments that hold exactly one node strictly inside (Wang 2024, Eq. (10): one piece a segment).
Energies native_energies(const Curve& curve, const CurvatureProfile& profile, const ArcMap& arcs) {
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
    if (!(arcs.segment_length(i) > 0.0)) continue;
    energies.add({{{&curve.segment(i), 0.0, 1.0, profile.splits(i)}}}, vertex[k],
                 diverges(curve, profile, arcs, {i, 0.0, 1.0}));
  }
  return energies;
}

Energies centred_energies(const Curve& curve, const CurvatureProfile& profile, const ArcMap& arcs) {
  Energies energies;
  if (!arcs.accurate()) return energies;
  for (const CentredPiece& piece : centred_pieces(curve, arcs)) {
    SampledPiece sampled{.stretches = {}, .length = piece.end - piece.start};
    bool infinitely_bent = false;
    for (const Part& part : piece.parts) {
      infinitely_bent = infinitely_bent || diverges(curve, profile, arcs, part);
      sampled.stretches.push_back({&curve.segment(part.segment), part.t0, part.t1, profile.splits(part.segment)});
    }
    const double vertex = (piece.node.position - piece.start) / (piece.end - piece.start);
    energies.add(std::move(sampled), vertex, infinitely_bent);
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
  SampledPiece piece{{{&segment, 0.0, 1.0, extrema_of(segment)}}};
  for (int round = 0;; ++round) {
    piece.sample();
    bool refined = false;
    const Estimate energy = energy_of(piece, parabola, refined);
    if (!refined || round == most_rounds) return energy.to_accuracy();
  }
}

ParabolaFit best_parabola(const Segment& segment, std::optional<double> vertex) {
  if (!cusps(segment).empty()) return {{undefined, undefined, undefined}, infinite};
  SampledPiece piece{{{&segment, 0.0, 1.0, extrema_of(segment)}}};
  return fit_to_accuracy(piece, vertex);
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
    const CurvatureProfile profile = curvature_profile(*fit.curve, rounding_of(fit.input));
    const ArcMap arcs(*fit.curve);
    const Energies native = native_energies(*fit.curve, profile, arcs);
    const Energies centred = centred_energies(*fit.curve, profile, arcs);
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
          .version = 2,
          .columns = std::move(columns),
          .measure = measure};
}

}  // namespace kappabench
