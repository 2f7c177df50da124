#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/run/experiment.hpp"
#include "experiments/study/quantity.hpp"

namespace kappabench::wang {

/// The experiment on the weights (λe, λc) of the two further energies: its cells and what they measure.
/// weights.cpp concludes from them.

/// A column of Table 1.
struct Weights {
  std::string_view words, lambda_e, lambda_c;
  double mean, largest;  ///< printed
};
inline constexpr std::array<Weights, 8> table_1{{{"(0, 0)", "0", "0", 8.33e-3, 4.98e-2},
                                                 {"(0, 0.1)", "0", "0.1", 3.18e-4, 1.56e-3},
                                                 {"(0.01, 0.1)", "0.01", "0.1", 3.02e-4, 1.56e-3},
                                                 {"(1, 0.1)", "1", "0.1", 1.67e-2, 8.36e-2},
                                                 {"(0.1, 0.1)", "0.1", "0.1", 1.18e-4, 3.24e-4},
                                                 {"(0.1, 0)", "0.1", "0", 6.51e-4, 4.07e-3},
                                                 {"(0.1, 0.01)", "0.1", "0.01", 2.27e-3, 1.29e-2},
                                                 {"(0.1, 1)", "0.1", "1", 3.32e-4, 1.52e-3}}};
inline constexpr std::size_t unweighted = 0, heavy_edges = 3, chosen = 4, edges_alone = 5;

inline constexpr std::string_view weights_drawing = "weights";
inline constexpr int walk_points = 6, walks = 100, robust_walks = 15, perturbed_walks = 10, scaled_walks = 6,
                     capped_walks = 6;
/// Of the scales tried, where the medians of the rows agree best with the printed order (table "ranks").
inline constexpr double usual_chord = 8.5, perturbation = 1e-9;
inline constexpr std::array scales{1.0, 3.0, usual_chord, 25.0};
inline constexpr std::array caps{0, 3, 10, 30};

inline const study::Key weights_key{"weights"}, chord_key{"mean chord"}, cap_key{"cap"};
/// Of every walk, with windows as printed and the usual chord. A curve that was not solved has infinite energy.
inline const study::Quantity mean_energy{"mean E", "1/length", Method::sampled},
    largest_energy{"max E", "1/length", Method::sampled}, was_solved = study::count_of("solved"),
                                                          length{"length over chords", "1", Method::sampled},
                                                          crossings{"crossings", "1", Method::sampled};
/// Of a few walks: relative change of mean E by the perturbation; mean E times mean chord by scale, and in the default
/// mode; mean E and length by the cap on stage 2.
inline const study::Quantity sensitivity{"sensitivity", "1", Method::sampled},
    scaled_energy{"mean E times mean chord", "1", Method::sampled},
    robust_energy{"robust mean E", "1", Method::sampled}, capped_energy{"capped mean E", "1/length", Method::sampled},
    capped_length{"capped length", "length", Method::sampled};

[[nodiscard]] std::vector<CellJob> weights_jobs(const Context& context);

}  // namespace kappabench::wang
