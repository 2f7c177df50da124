#include "datasets/uneven_points.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "datasets/random_source.hpp"

namespace kappabench {
namespace {

constexpr double pi = std::numbers::pi;

Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

int whole(RandomSource& random, int least, int most) {
  return static_cast<int>(random.uniform(least, static_cast<double>(most) + 1.0));
}

/// Abbott and von Doenhoff 1959, Section 6.4: thickness across a camber line of two parabolas, chord 1.
struct NacaSection {
  double camber, camber_at, thickness;

  [[nodiscard]] Vec2 point(double x, double side) const {
    const double half =
        5.0 * thickness * (0.2969 * std::sqrt(x) + x * (-0.1260 + x * (-0.3516 + x * (0.2843 - 0.1036 * x))));
    const bool front = x < camber_at;
    const double reach = front ? camber_at : 1.0 - camber_at, scale = camber / (reach * reach);
    const double height = scale * ((front ? 0.0 : 1.0 - 2.0 * camber_at) + x * (2.0 * camber_at - x));
    const Vec2 normal = direction(std::atan(2.0 * scale * (camber_at - x)) + 0.5 * pi);
    return Vec2(x, height) + side * half * normal;
  }
};

Input airfoil(RandomSource& random) {
  const int half = whole(random, 8, 40);
  const NacaSection section{.camber = random.uniform(0.0, 0.07),
                            .camber_at = random.uniform(0.2, 0.6),
                            .thickness = random.uniform(0.06, 0.24)};
  const bool closed = random.uniform(0.0, 1.0) < 0.5;
  const double size = random.log_uniform(0.5, 200.0);
  Input input{.points = {}, .closed = closed};
  const auto add = [&](int i, double side) {
    input.points.emplace_back(size * section.point(0.5 * (1.0 + std::cos(pi * i / half)), side));
  };
  for (int i = 0; i <= half; ++i) add(i, 1.0);
  for (int i = half - 1; i >= (closed ? 1 : 0); --i) add(i, -1.0);
  return input;
}

Input ring(RandomSource& random) {
  const int n = whole(random, 8, 40);
  const double aspect = random.uniform(0.6, 1.0), noise = random.uniform(0.0, 0.02),
               spacing = random.uniform(0.0, 0.35), size = random.log_uniform(0.5, 200.0);
  const double oval = random.uniform(0.0, 0.08), pear = random.uniform(0.0, 0.05);
  const double oval_at = random.uniform(0.0, 2.0 * pi), pear_at = random.uniform(0.0, 2.0 * pi);
  const double turned = random.uniform(0.0, 2.0 * pi), step = 2.0 * pi / n;
  Input input{.points = {}, .closed = true};
  for (int i = 0; i < n; ++i) {
    const double angle = step * (i + random.uniform(-spacing, spacing));
    const double radius = 1.0 + oval * std::cos(2.0 * angle + oval_at) + pear * std::cos(3.0 * angle + pear_at) +
                          noise * step * random.normal();
    const Vec2 on_oval = size * radius * Vec2(std::cos(angle), aspect * std::sin(angle));
    input.points.emplace_back(on_oval.x() * direction(turned) + on_oval.y() * direction(turned + 0.5 * pi));
  }
  return input;
}

Input walk(RandomSource& random) {
  const int n = whole(random, 5, 24);
  const double ratio = random.log_uniform(3.0, 1000.0), most_turn = random.uniform(0.3, 1.3);
  Input input{.points = {}, .closed = false};
  Vec2 at = Vec2::Zero();
  double angle = random.uniform(0.0, 2.0 * pi);
  for (int i = 0; i < n; ++i) {
    input.points.push_back(at);
    at += random.log_uniform(1.0, ratio) * direction(angle);
    angle += random.uniform(-most_turn, most_turn);
  }
  return input;
}

Input corner(RandomSource& random) {
  const int corners = whole(random, 1, 3);
  const double side = random.log_uniform(10.0, 200.0);
  Input input{.points = {Vec2::Zero()}, .closed = false};
  double angle = random.uniform(0.0, 2.0 * pi);
  const auto go = [&](double length) { input.points.emplace_back(input.points.back() + length * direction(angle)); };
  for (int c = 0; c < corners; ++c) {
    for (int k = whole(random, 1, 2); k > 0; --k) go(side * random.uniform(0.5, 1.5));
    const double turn = random.uniform(0.5, 2.1) * (random.uniform(0.0, 1.0) < 0.5 ? 1.0 : -1.0);
    const double radius = random.uniform(1.0, 3.0);
    const int chords = whole(random, 1, 3);
    for (int k = 0; k < chords; ++k) {
      angle += 0.5 * turn / chords;
      go(2.0 * radius * std::sin(0.5 * std::abs(turn) / chords));
      angle += 0.5 * turn / chords;
    }
  }
  go(side * random.uniform(0.5, 1.5));
  return input;
}

Input hairpin(RandomSource& random) {
  const int n = whole(random, 3, 6);
  const double gap = random.log_uniform(0.05, 0.6);
  Input input{.points = {}, .closed = false};
  const auto add = [&](int i, double height) {
    const double along = i + random.uniform(-0.1, 0.1);
    input.points.emplace_back(along, height + 0.1 * gap * random.normal());
  };
  for (int i = 0; i < n; ++i) add(i, 0.0);
  for (int i = n - 1; i >= 0; --i) add(i, gap);
  return input;
}

Input long_chord(RandomSource& random) {
  Input input{.points = {}, .closed = true};
  Vec2 at = Vec2::Zero();
  double angle = 0.0;
  for (int i = 0; i < 10; ++i) {
    input.points.push_back(at);
    angle += random.uniform(-1.25, 1.25);
    at += std::exp(0.4 * random.normal()) * direction(angle);
  }
  return input;
}

}  // namespace

const std::vector<UnevenKind>& uneven_kinds() {
  static const std::vector<UnevenKind> kinds{UnevenKind::airfoil, UnevenKind::ring,    UnevenKind::walk,
                                             UnevenKind::corner,  UnevenKind::hairpin, UnevenKind::long_chord};
  return kinds;
}

std::string_view name(UnevenKind kind) {
  constexpr std::array<std::string_view, 6> names{"airfoil", "ring", "walk", "corner", "hairpin", "long chord"};
  return names[static_cast<std::size_t>(kind)];
}

Input uneven_input(UnevenKind kind, std::uint64_t seed) {
  RandomSource random(seed);
  const auto draw = [&]() -> Input {
    switch (kind) {
      case UnevenKind::airfoil:
        return airfoil(random);
      case UnevenKind::ring:
        return ring(random);
      case UnevenKind::walk:
        return walk(random);
      case UnevenKind::corner:
        return corner(random);
      case UnevenKind::hairpin:
        return hairpin(random);
      case UnevenKind::long_chord:
        return long_chord(random);
    }
    throw std::logic_error("unknown UnevenKind");
  };
  Input input = draw();
  for (Vec2& point : input.points) point = on_grid(point);
  return input;
}

}  // namespace kappabench
