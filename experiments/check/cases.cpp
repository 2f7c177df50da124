#include "experiments/check/cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "datasets/datasets.hpp"
#include "datasets/random_points.hpp"

namespace kappabench::check {

namespace {

constexpr std::size_t longest_drawing = 64;
constexpr std::size_t longest_command = 64;  // points that are written out

Case random_case(RandomKind kind, int n, int seed, bool closed) {
  const std::string id = fmt::format("random:{}:n={},seed={},closed={}", name(kind), n, seed, closed);
  return {id, id, random_input(kind, n, static_cast<std::uint64_t>(seed), closed)};
}

bool taken(const SchemeTraits& traits, const Input& input) {
  if (input.closed) return traits.closed && input.size() >= traits.fewest_closed_points;
  return traits.open && input.size() >= traits.fewest_open_points;
}

void add(std::vector<Case>& cases, const SchemeTraits& traits, Case next) {
  if (taken(traits, next.input)) cases.push_back(std::move(next));
}

}  // namespace

Case random_star(int n, int seed, bool closed) { return random_case(RandomKind::star, n, seed, closed); }

std::vector<Case> benign_cases(const SchemeTraits& traits) {
  std::vector<Case> cases;
  for (const int n : {5, 8, 13, 24})
    for (const int seed : {1, 2})
      for (const bool closed : {false, true}) add(cases, traits, random_star(n, seed, closed));
  for (const int n : {6, 12})
    for (const bool closed : {false, true}) add(cases, traits, random_case(RandomKind::walk, n, 1, closed));
  std::ranges::stable_sort(cases, {}, [](const Case& c) { return c.input.size(); });
  return cases;
}

std::vector<Case> drawn_cases(const SchemeTraits& traits) {
  std::vector<Case> cases;
  for (const Drawing& drawing : builtin_drawings())
    for (std::size_t i = 0; i < drawing.curves.size(); ++i) {
      if (drawing.curves[i].points.size() > longest_drawing) continue;
      const std::string label = drawing.curves.size() == 1 ? drawing.id : fmt::format("{}, curve {}", drawing.id, i);
      add(cases, traits, {label, drawing.id, drawing.curves[i]});
    }
  std::ranges::stable_sort(cases, {}, [](const Case& c) { return c.input.size(); });
  return cases;
}

std::vector<Case> hostile_cases() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<std::string, std::vector<Vec2>>> shapes{
      {"no points", {}},
      {"one point", {{1, 2}}},
      {"two points", {{0, 0}, {1, 1}}},
      {"NaN", {{0, 0}, {1, nan}, {2, 0}, {3, 1}}},
      {"infinity", {{0, 0}, {1, inf}, {2, 0}, {3, 1}}},
      {"all points the same", {{1, 1}, {1, 1}, {1, 1}, {1, 1}}},
      {"a point twice", {{0, 0}, {1, 1}, {1, 1}, {2, 0}, {3, 2}}},
      {"the first point again", {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}}},
      {"nearly coincident", {{0, 0}, {1, 1}, {1 + 1e-8, 1}, {2, 0}, {1, -2}}},
      {"collinear, even", {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}},
      {"collinear, uneven and sloping", {{0, 0}, {1, 0.5}, {5, 2.5}, {5.5, 2.75}, {9, 4.5}}},
      {"collinear, folded back", {{0, 0}, {2, 0}, {1, 0}, {3, 0}}},
      {"there and back", {{0, 0}, {1, 0}, {0, 0}, {1, 0}, {0, 0}, {1, 0}}},
      {"a spike", {{0, 0}, {1, 0}, {2, 1}, {1, 0}, {0, 2}}},
      {"nearly a spike", {{0, 0}, {1, 0}, {2, 1e-12}, {1, 1e-12}, {0, 2}}},
      {"three points on a line", {{0, 0}, {1, 0}, {2, 0}}},
      {"tiny legs beside huge ones", {{0, 0}, {1e6, 0}, {1e6, 1e-2}, {1e6 - 1e-2, 2e-2}, {0, 1e6}}},
      {"legs of 1e-7 and 1e7", {{0, 0}, {1e-7, 0}, {1e-7, 1e-7}, {1e7, 1e7}, {0, 1e7}}},
      {"legs beyond 1e9 of each other", {{0, 0}, {1, 0}, {1e12, 1}, {1e12, 1e12}, {0, 5}}},
      {"largest numbers", {{-1e308, -1e308}, {1e308, -1e308}, {1e308, 1e308}, {-1e308, 1e308}}},
      {"smallest numbers", {{0, 0}, {5e-324, 0}, {5e-324, 5e-324}, {0, 5e-324}}},
      {"the same digits far away", {{1e16, 1e16}, {1e16 + 2, 1e16}, {1e16 + 2, 1e16 + 2}, {1e16, 1e16 + 2}}},
      {"a square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
      {"a cross of itself", {{0, 0}, {1, 1}, {1, 0}, {0, 1}}}};
  std::vector<Case> cases;
  for (const auto& [label, points] : shapes)
    for (const bool closed : {false, true})
      cases.push_back({fmt::format("{}, {}", label, closed ? "closed" : "open"), "", {points, closed, {}, {}}});
  return cases;
}

Case changed(const Case& from, const std::string& how, Input input) {
  return {fmt::format("{}, {}", from.name, how), "", std::move(input)};
}

std::string fit_command(const Case& shown, const std::string& scheme) {
  if (!shown.points.empty()) return fmt::format("kappabench fit {} --scheme {}", shown.points, scheme);
  if (shown.input.points.size() > longest_command) return fmt::format("kappabench check {}", scheme);
  std::string text = shown.input.closed ? "closed" : "open";
  for (const Vec2& p : shown.input.points) text += fmt::format("\\n{} {}", p.x(), p.y());
  return fmt::format("printf '{}\\n' | kappabench fit - --scheme {}", text, scheme);
}

}  // namespace kappabench::check
