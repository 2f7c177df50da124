#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/check/claim.hpp"

namespace kappabench::check {

/// A claim, and what came of it.
struct Judged {
  Claim claim;
  Finding finding;
};

/// Everything about one scheme.
struct Checked {
  std::string scheme;  ///< "ID[:key=value,...]"
  std::string title;
  std::vector<Judged> claims;

  [[nodiscard]] bool sound() const;  ///< nothing is refuted
};

/// `done` of `total` claims are judged; `last` is the name of the last one.
using Progress = std::function<void(std::size_t done, std::size_t total, std::string_view last)>;

/// Tries every claim of the scheme that `make` makes. A test that throws, by what a scheme has returned, refutes its
/// claim.
[[nodiscard]] Checked check(const std::string& text, const std::function<SchemePtr()>& make,
                            const Progress& progress = {});

/// A page for a person: a table of claims, then the refutations.
[[nodiscard]] std::string page(const Checked& checked);
/// One line a scheme, then the refutations.
[[nodiscard]] std::string overview(const std::vector<Checked>& all);
/// For machines.
[[nodiscard]] std::string json(const std::vector<Checked>& all);

}  // namespace kappabench::check
