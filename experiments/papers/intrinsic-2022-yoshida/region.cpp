#include "experiments/papers/intrinsic-2022-yoshida/region.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/study/summaries.hpp"
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

double Region::inside_count() const {
  return static_cast<double>(std::ranges::count_if(inside, [](char c) { return c != 0; }));
}
double Region::outside_count() const {
  return static_cast<double>(std::ranges::count_if(outside, [](char c) { return c != 0; }));
}

Region covered_region(const StandardData& angles, const Window& window, int side, const Settings& settings) {
  const auto places = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  Region region{side, std::vector<char>(places), std::vector<char>(places)};
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const auto [start, end] = window.point(i, j, side);
      const StandardData data = with_curvatures(angles, start, end);
      const HermiteFit fit = solve(data, settings);
      const std::size_t place = region.index(i, j);
      const bool viable = viability(data).viable();
      region.viable += viable ? 1.0 : 0.0;
      region.unsolved += viable && fit.outcome != Outcome::converged ? 1.0 : 0.0;
      (viable ? region.inside : region.outside)[place] = rises(fit) ? 1 : 0;
    }
  return region;
}

namespace {

void put_runs(const std::vector<char>& places, const std::string& what, store::CellRecord& cell) {
  for (std::size_t i = 0; i < places.size();) {
    if (places[i] == 0) {
      ++i;
      continue;
    }
    const std::size_t from = i;
    while (i < places.size() && places[i] != 0) ++i;
    study::put(cell, what + " from", static_cast<double>(from));
    study::put(cell, what + " to", static_cast<double>(i));
  }
}

std::vector<char> runs_of(const store::CellRecord& cell, const std::string& what, std::size_t places) {
  std::vector<char> found(places);
  std::size_t from = 0;
  for (const store::MeasurementRecord& m : cell.measurements) {
    if (m.column == what + " from") from = static_cast<std::size_t>(m.value);
    if (m.column == what + " to")
      for (std::size_t i = from; i < std::min(places, static_cast<std::size_t>(m.value)); ++i) found[i] = 1;
  }
  return found;
}

}  // namespace

void put_region(const Region& region, store::CellRecord& cell) {
  study::put(cell, "side", region.side);
  study::put(cell, "viable", region.viable);
  study::put(cell, "unsolved", region.unsolved);
  put_runs(region.inside, "covered", cell);
  put_runs(region.outside, "outside", cell);
}

Region region_of(const store::CellRecord& cell) {
  Region region;
  region.side = static_cast<int>(measured(cell, "side").value_or(0.0));
  region.viable = measured(cell, "viable").value_or(0.0);
  region.unsolved = measured(cell, "unsolved").value_or(0.0);
  const auto places = static_cast<std::size_t>(region.side) * static_cast<std::size_t>(region.side);
  region.inside = runs_of(cell, "covered", places);
  region.outside = runs_of(cell, "outside", places);
  return region;
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
