#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/check/cases.hpp"
#include "schemes/api/registry.hpp"

namespace kappabench::check {

/// Fits, and makes of an exception the outcome `crashed` with its text: a scheme must not throw, and a check must not
/// end because one does.
[[nodiscard]] Fit tried_fit(const Scheme& scheme, const Input& input);
[[nodiscard]] Fit tried_refit(const Scheme& scheme, const Fit& fit, const Edit& edit);

/// Did the framework find that the curve misses what it claims? It says so in the message; the solver's own trouble
/// does not speak of claims.
[[nodiscard]] bool misses_own_claim(const Fit& fit);

/// A case and its fit.
struct Trial {
  Case shown;
  Fit fit;
};

/// A scheme on the bench: what it says of itself, and fits that all claims look at, made once.
class SchemeUnderTest {
 public:
  /// `text` is what a person calls it, "ID[:key=value,...]"; `make` makes a new instance.
  SchemeUnderTest(std::string text, std::function<SchemePtr()> make);

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const Scheme& scheme() const { return *scheme_; }
  [[nodiscard]] const SchemeInfo& info() const { return scheme_->info(); }
  [[nodiscard]] const SchemeTraits& traits() const { return scheme_->info().traits; }
  [[nodiscard]] SchemePtr another() const { return make_(); }

  [[nodiscard]] Fit fit(const Input& input) const { return tried_fit(*scheme_, input); }

  [[nodiscard]] const std::vector<Trial>& benign() const { return benign_; }
  [[nodiscard]] const std::vector<Trial>& drawn() const { return drawn_; }
  /// Both of the above.
  [[nodiscard]] std::vector<const Trial*> trials() const;
  /// Those of `trials` whose curves are held against what the scheme claims: the converged ones, and those that the
  /// framework has made `not_converged` because they miss their own claim. If too few benign inputs converge, all
  /// curves.
  [[nodiscard]] std::vector<const Trial*> curves() const;
  /// Those of `curves` that are benign and have at most 13 points: what is fitted again and again.
  [[nodiscard]] std::vector<const Trial*> short_curves() const;

  /// Of the benign inputs, how many did not converge; fine up to one in ten.
  [[nodiscard]] long unsolved() const;
  [[nodiscard]] bool solves() const { return 10 * unsolved() <= static_cast<long>(benign_.size()); }

 private:
  [[nodiscard]] bool judged(const Fit& fit) const;

  std::string text_;
  std::function<SchemePtr()> make_;
  SchemePtr scheme_;
  std::vector<Trial> benign_;
  std::vector<Trial> drawn_;
};

}  // namespace kappabench::check
