#include "experiments/papers/intrinsic-2022-yoshida/region.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <variant>

#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "schemes/intrinsic/viable_region.hpp"

namespace kappabench::yoshida {

using namespace intrinsic;

std::pair<double, double> Window::point(int i, int j, int side) const {
  const auto share = [side](int k) { return (k + 0.5) / side; };
  return {start_from + (start_to - start_from) * share(i), end_from + (end_to - end_from) * share(j)};
}

std::span<const Window> windows() {
  static const double limit = 2.0 * std::sin(std::numbers::pi / 9.0);
  static const std::array<Window, 3> all{{{"end curvature to 5", 0.0, limit, 0.0, 5.0, 100, 100},
                                          {"end curvature to 20", 0.0, limit, 0.0, 20.0, 100, 100},
                                          {"both curvatures to 20", -20.0, limit, 0.0, 20.0, 30, 100}}};
  return all;
}

double Region::inside_count() const { return static_cast<double>(std::ranges::count(inside, 1)); }
double Region::outside_count() const { return static_cast<double>(std::ranges::count(outside, 1)); }

Region covered_region(const StandardData& angles, const Window& window, int side, const Settings& settings) {
  const auto places = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  Region region{side, std::vector<char>(places), std::vector<char>(places)};
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const auto [start, end] = window.point(i, j, side);
      const StandardData data = with_curvatures(angles, start, end);
      const HermiteFit fit = solve(data, settings);
      const std::size_t place = region.index(i, j);
      const bool expected = viability(data).viable();
      region.viable += expected ? 1.0 : 0.0;
      region.unsolved += expected && fit.outcome != Outcome::converged ? 1.0 : 0.0;
      (expected ? region.inside : region.outside)[place] = rises(fit) ? 1 : 0;
    }
  return region;
}

namespace {

using study::count_of, study::Key, study::Quantity;

const Quantity side_of_grid = count_of("side"), viable = count_of("viable"), unsolved = count_of("unsolved");
/// A run of consecutive places: from the first to before the last.
const Key covered_from{"covered from"}, outside_from{"outside from"};
const Quantity covered_to = count_of("covered to"), outside_to = count_of("outside to");

void put_runs(const std::vector<char>& places, const Key& from, const Quantity& to, study::Notes& notes) {
  for (auto i = places.begin(); (i = std::find(i, places.end(), 1)) != places.end();) {
    const auto end = std::find(i, places.end(), 0);
    notes.row({from(i - places.begin())}, {to(end - places.begin())});
    i = end;
  }
}

std::vector<char> runs_of(const study::Rows& rows, const Key& from, const Quantity& to, int side) {
  std::vector<char> places(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  for (const auto& [first, run] : rows.by(from))
    for (auto i = static_cast<std::size_t>(std::get<double>(first)); i < static_cast<std::size_t>(run.largest(to)); ++i)
      places.at(i) = 1;
  return places;
}

}  // namespace

void put_region(const Region& region, study::Notes& notes) {
  notes.row({}, {side_of_grid(region.side), viable(region.viable), unsolved(region.unsolved)});
  put_runs(region.inside, covered_from, covered_to, notes);
  put_runs(region.outside, outside_from, outside_to, notes);
}

Region region_of(const study::Rows& rows) {
  const int side = static_cast<int>(rows.total(side_of_grid));
  return {.side = side,
          .inside = runs_of(rows, covered_from, covered_to, side),
          .outside = runs_of(rows, outside_from, outside_to, side),
          .viable = rows.total(viable),
          .unsolved = rows.total(unsolved)};
}

Region united(const Region& a, const Region& b) {
  if (a.side == 0) return b;
  if (b.side == 0) return a;
  if (a.side != b.side) throw std::invalid_argument("regions of different grids cannot be united");
  Region both = a;
  for (std::size_t i = 0; i < both.inside.size(); ++i) {
    both.inside[i] = a.inside[i] != 0 || b.inside[i] != 0 ? 1 : 0;
    both.outside[i] = a.outside[i] != 0 || b.outside[i] != 0 ? 1 : 0;
  }
  both.unsolved = std::nan("");
  return both;
}

}  // namespace kappabench::yoshida
