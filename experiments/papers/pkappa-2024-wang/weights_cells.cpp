#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "datasets/random_points.hpp"
#include "datasets/random_source.hpp"
#include "experiments/papers/pkappa-2024-wang/energies.hpp"
#include "experiments/papers/pkappa-2024-wang/inputs.hpp"
#include "experiments/papers/pkappa-2024-wang/weights.hpp"
#include "experiments/study/jobs.hpp"
#include "metrics/self_intersection.hpp"
#include "metrics/statistics.hpp"
#include "schemes/curve/arc_length.hpp"

namespace kappabench::wang {

namespace {

using study::Notes;

double energy_of(const Fit& fit) {
  return study::solved(fit) ? mean_energy_of(fit) : std::numeric_limits<double>::infinity();
}

double length_of(const Fit& fit) { return fit.curve ? arc_length(*fit.curve, 1e-6) : undefined; }

/// With mean chord 1.
Input walk(std::uint64_t seed, int index) {
  return random_input(RandomKind::walk, walk_points, seed + static_cast<std::uint64_t>(index), false);
}

Input perturbed(Input input, int index) {
  RandomSource random(static_cast<std::uint64_t>(index) + 1);
  const double size = perturbation * mean_chord(input);
  for (Vec2& point : input.points) {
    const double x = random.normal(), y = random.normal();
    point += size * Vec2(x, y);
  }
  return input;
}

void measure_walks(const Uses& uses, Notes& notes) {
  const Scheme& scheme = *uses.schemes.front();
  for (int i = 0; i < walks; ++i) {
    const std::vector<study::KeyIs> keys{weights_key(uses.words.at("weights")), curve_number(i)};
    const Input usual = scaled_to(walk(uses.seed, i), usual_chord);
    const Fit fit = scheme.fit(usual);
    const double energy = energy_of(fit);
    notes.row(
        keys,
        {mean_energy(energy), largest_energy(study::solved(fit) ? largest(parabola_energies(*fit.curve)) : energy),
         was_solved(study::solved(fit) ? 1 : 0), length(length_of(fit) / (usual_chord * (walk_points - 1))),
         crossings(fit.curve ? static_cast<double>(self_intersections(*fit.curve).found.size()) : undefined)});
    if (i < perturbed_walks)
      notes.row(keys, {sensitivity(std::abs(energy_of(scheme.fit(perturbed(usual, i))) / energy - 1.0))});
    if (i < scaled_walks)
      for (const double chord : scales) {
        const double mean = chord == usual_chord ? energy : energy_of(scheme.fit(scaled_to(usual, chord)));
        notes.row({keys[0], keys[1], chord_key(chord)}, {scaled_energy(mean * chord)});
      }
  }
}

void measure_robust(const Uses& uses, Notes& notes) {
  for (int i = 0; i < robust_walks; ++i)
    notes.row({weights_key(uses.words.at("weights")), curve_number(i)},
              {robust_energy(energy_of(uses.schemes.front()->fit(walk(uses.seed, i))))});
}

void measure_capped(const Uses& uses, Notes& notes) {
  for (int i = 0; i < capped_walks; ++i) {
    const Fit fit = uses.schemes.front()->fit(scaled_to(walk(uses.seed, i), usual_chord));
    notes.row({weights_key(uses.words.at("weights")), cap_key(uses.numbers.at("cap")), curve_number(i)},
              {capped_energy(energy_of(fit)), capped_length(length_of(fit))});
  }
}

}  // namespace

std::vector<CellJob> weights_jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const Metric &energy = find_metric("parabola_energy"), &features = find_metric("features");
  const std::string dataset = fmt::format("random walks, {} points, seed {}", walk_points, context.seed);
  const auto scheme = [&](const Weights& weights, std::string_view mode) {
    return pkappa(context.registry, fmt::format("{}lambda_e={},lambda_c={}", mode, weights.lambda_e, weights.lambda_c));
  };
  const auto uses = [&](std::string work, SchemePtr of, const Weights& weights) {
    return Uses{.work = std::move(work),
                .schemes = {std::move(of)},
                .metrics = {&energy, &features},
                .seed = context.seed,
                .words = {{"weights", std::string(weights.words)}}};
  };
  jobs.reserve(4 * std::size(table_1));
  for (const Weights& weights : table_1)
    jobs.push_back(fit_job(scaled_to(drawing(weights_drawing), usual_chord), scheme(weights, "mode=paper,"),
                           {&energy, &find_metric("fairness"), &features}, std::string(weights.words)));
  for (const Weights& weights : table_1) {
    jobs.push_back(study::numbers_job<measure_walks>(uses("weights", scheme(weights, "mode=paper,"), weights), dataset,
                                                     fmt::format("random {}", weights.words)));
    jobs.push_back(
        study::numbers_job<measure_robust>(uses("weights, default mode", scheme(weights, "unit=chord,"), weights),
                                           dataset, fmt::format("robust {}", weights.words)));
  }
  for (const Weights& weights : {table_1[unweighted], table_1[chosen]})
    for (const int cap : caps) {
      Uses capped =
          uses("weights by cap", scheme(weights, fmt::format("mode=paper,stage2_iterations={},", cap)), weights);
      capped.numbers["cap"] = cap;
      jobs.push_back(
          study::numbers_job<measure_capped>(std::move(capped), dataset, fmt::format("cap {} {}", cap, weights.words)));
    }
  return jobs;
}

}  // namespace kappabench::wang
