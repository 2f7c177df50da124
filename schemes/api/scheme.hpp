#pragma once

#include <map>
#include <string>
#include <vector>

#include "schemes/api/edit.hpp"
#include "schemes/api/fit.hpp"
#include "schemes/api/parameters.hpp"
#include "schemes/curve/placement.hpp"

namespace kappabench {

/// What a scheme claims about itself; the claims that `kappabench check` tries and the metrics test the claims.
struct SchemeTraits {
  bool open = true;
  bool closed = true;
  int fewest_open_points = 3;
  int fewest_closed_points = 3;
  Continuity continuity = Continuity::g2;
  std::string continuity_exceptions{};  ///< in words, empty for none
  /// How many spans on each side of a moved point may change; -1 means all of them.
  int locality = -1;
  bool similarity_invariant = true;
  bool reversal_invariant = true;
  bool cyclic_shift_invariant = true;  ///< closed curves
  bool repeats_allowed = false;        ///< takes coincident consecutive points
  bool hermite = false;                ///< fits two points with given tangents, and curvatures if given
  /// A refit gives the curve that a fit of the edited input gives. Not so where a curve depends on how it was made.
  bool refit_is_fit = true;
};

/// A mark that a scheme may set on a node. A counter of the same name counts the nodes that have it.
struct MarkSpec {
  std::string name;
  std::string help;
};

struct SchemeInfo {
  std::string id;
  std::string title;     ///< a few words
  std::string citation;  ///< authors, title, venue, year
  std::vector<ParameterSpec> parameters{};
  SchemeTraits traits{};
  int version = 1;                ///< raise when results change: cells of older versions are recomputed
  std::vector<MarkSpec> marks{};  ///< all that it may set on nodes
  std::map<std::string, std::string> libraries{};  ///< those of its own that it computes with, and their versions
  /// Of a scheme from outside: the file it came from, and a digest of all that it consists of, part of every key.
  std::string plugin{};
  std::string plugin_digest{};
};

/// A way to turn points into a curve, with its parameters already chosen. Immutable; `fit` may be called
/// from several threads.
class Scheme {
 public:
  virtual ~Scheme() = default;

  [[nodiscard]] const SchemeInfo& info() const { return info_; }
  [[nodiscard]] const Parameters& parameters() const { return parameters_; }

  /// Fits `input`. Never throws for bad data: input that no scheme can take (NaN, coincident consecutive
  /// points, too few points, open or closed where the traits say no) is refused here as
  /// `unsupported_input` with one line, so authors of schemes need not check it again.
  ///
  /// Input that is far from the origin or of uncommon size is solved in its own frame (schemes/api/frame.hpp) if the
  /// scheme is similarity invariant. A curve that misses what it claims becomes `not_converged`
  /// (schemes/api/soundness.hpp); wild spans become warnings (schemes/api/warnings.hpp), and the first one the message
  /// if there was none.
  [[nodiscard]] Fit fit(const Input& input) const;

  /// Fits the edited input of an earlier fit; by default from scratch.
  [[nodiscard]] Fit refit(const Fit& fit, const Edit& edit) const;

 protected:
  Scheme(SchemeInfo info, Parameters parameters);

 private:
  friend class LibraryScheme;  // schemes/plugin: the same scheme, that knows where it came from

  /// The author's part: curve and report for an input that passed the checks.
  [[nodiscard]] virtual Fit solve(const Input& input) const = 0;
  [[nodiscard]] virtual Fit resolve(const Fit& fit, const Edit& edit) const;

  /// The identity for a scheme that is not similarity invariant.
  [[nodiscard]] Placement frame_for(const Input& input) const;

  SchemeInfo info_;
  Parameters parameters_;
};

/// Why no scheme with these traits can fit the input, in one line; empty if it can.
[[nodiscard]] std::string reason_unsupported(const SchemeTraits& traits, const Input& input);

}  // namespace kappabench
