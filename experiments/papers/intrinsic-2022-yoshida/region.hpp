#pragma once

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/study/notes.hpp"
#include "experiments/study/rows.hpp"
#include "schemes/intrinsic/solve.hpp"

namespace kappabench::yoshida {

/// A part of the plane of end curvatures (start, end), times the chord, with a square grid of places to try.
struct Window {
  std::string_view name;
  double start_from, start_to, end_from, end_to;
  int side_fixed, side_automatic;  ///< points along a side, by default

  /// Place (i, j): in the middle of its square.
  [[nodiscard]] std::pair<double, double> point(int i, int j, int side) const;
};

/// For the angles of Fig. 6. The first has the range of the paper's figures, the others go to 20 over the chord.
[[nodiscard]] std::span<const Window> windows();

/// Where curvature rises from end to end, on a grid.
struct Region {
  int side = 0;
  std::vector<char> inside;   ///< side * side: viable, and with a monotone solution
  std::vector<char> outside;  ///< a monotone solution where none should be
  double viable = 0.0;        ///< places that should have one
  double unsolved = 0.0;      ///< of these, places where the solver does not converge

  [[nodiscard]] std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(side) + static_cast<std::size_t>(j);
  }
  [[nodiscard]] bool at(int i, int j) const { return inside[index(i, j)] != 0; }
  [[nodiscard]] double inside_count() const;
  [[nodiscard]] double outside_count() const;
};

/// Every place of the window tried with these settings.
[[nodiscard]] Region covered_region(const intrinsic::StandardData& angles, const Window& window, int side,
                                    const intrinsic::Settings& settings);

/// Rows: side, viable and unsolved; and the region as runs of consecutive places. Reading gives the same region; of no
/// rows, one without places.
void put_region(const Region& region, study::Notes& notes);
[[nodiscard]] Region region_of(const study::Rows& rows);

/// Covered by either, `unsolved` unknown; a region without places is neutral. The grids must be the same.
[[nodiscard]] Region united(const Region& a, const Region& b);

}  // namespace kappabench::yoshida
