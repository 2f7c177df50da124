#pragma once

#include "schemes/api/registry.hpp"

namespace kappabench {

/// The trigonometric blending of local arcs (Yuksel 2020): span i is cos^2(pi t / 2) times the second half of the local
/// curve at point i plus sin^2(pi t / 2) times the first half of that at point i + 1. Nothing is solved but one scalar
/// equation a point; a point moves two spans on each side.
class Yuksel final : public Scheme {
 public:
  [[nodiscard]] static SchemeInfo describe();
  explicit Yuksel(const Parameters& parameters);

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;
};

}  // namespace kappabench
