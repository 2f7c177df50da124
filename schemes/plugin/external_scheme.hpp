#pragma once

#include <memory>

#include "schemes/api/scheme.hpp"
#include "schemes/plugin/manifest.hpp"
#include "schemes/plugin/process.hpp"

namespace kappabench {

/// What a manifest describes, and its program.
struct External {
  explicit External(Manifest described) : manifest(std::move(described)), process(manifest.command) {}

  Manifest manifest;
  Process process;
};

/// A scheme that asks an external program (README.md). Whatever the program does is an outcome, with one line that
/// names the manifest: no answer in time is `timed_out`; a program that ends before it answers has `crashed`; one that
/// cannot be started, and an answer that is none, `failed`. The seconds of its fits are those that the program says, or
/// from question to answer if it says none; the counter `external` (timed_outside.hpp) marks them.
class ExternalScheme final : public Scheme {
 public:
  ExternalScheme(std::shared_ptr<External> external, Parameters parameters);

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;

  std::shared_ptr<External> external_;
};

}  // namespace kappabench
