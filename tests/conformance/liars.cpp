// Schemes that lie, one lie each: `kappabench check` refutes what is false and nothing else. A curve that misses its
// own claim may be called not_converged by the framework; then `solves` falls with the claim.
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <variant>

#include "experiments/check/check.hpp"
#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

using Solve = std::function<Fit(const Input&)>;
using Resolve = std::function<Fit(const Fit&, const Edit&)>;
using Names = std::set<std::string>;

/// What the honest one claims: it is catmull-rom.
SchemeInfo honest_info() {
  SchemeInfo info = scheme("catmull-rom")->info();
  info.id = "liar";
  return info;
}

class Liar final : public Scheme {
 public:
  Liar(SchemeInfo info, Solve solve, Resolve resolve)
      : Scheme(std::move(info), scheme("catmull-rom")->parameters()),
        solve_(std::move(solve)),
        resolve_(std::move(resolve)) {}

 private:
  [[nodiscard]] Fit solve(const Input& input) const override { return solve_(input); }
  [[nodiscard]] Fit resolve(const Fit& fit, const Edit& edit) const override {
    return resolve_ ? resolve_(fit, edit) : solve_(apply(fit.input, edit));
  }

  Solve solve_;
  Resolve resolve_;
};

/// The names of the claims that are refuted.
Names refuted(const SchemeInfo& info, const Solve& solve, const Resolve& resolve = {}) {
  const check::Checked checked =
      check::check("liar", [&] { return std::make_shared<const Liar>(info, solve, resolve); });
  UNSCOPED_INFO(check::page(checked));
  Names names;
  for (const auto& [claim, finding] : checked.claims)
    if (finding.verdict == check::Verdict::refuted) names.insert(claim.name);
  CHECK(names.empty() == checked.sound());
  return names;
}

/// With `solves` or without, `names` are exactly these.
bool only(Names names, const Names& meant) {
  names.erase("solves");
  return names == meant;
}

Fit honest(const Input& input) {
  static const SchemePtr catmull_rom = scheme("catmull-rom");
  return catmull_rom->fit(input);
}

using Cubic = std::array<Vec2, 4>;

Cubic cubic_of(const Segment& segment) {
  const auto points = std::get<PolynomialForm>(segment.exact()).control_points;
  return {points.at(0), points.at(1), points.at(2), points.at(3)};
}

/// The fit with every segment, or its nodes and joints, made anew.
template <class Change>
Fit with_segments(Fit fit, Change change) {
  if (!fit.curve) return fit;
  std::vector<SegmentPtr> segments;
  for (int k = 0; k < fit.curve->size(); ++k) segments.push_back(change(k, cubic_of(fit.curve->segment(k))));
  fit.curve = Curve(std::move(segments), fit.curve->joints(), fit.curve->nodes(), fit.curve->closed());
  return fit;
}

template <class Reshape>
Fit reshaped(const Fit& fit, Reshape reshape) {
  return with_segments(fit, [&](int k, Cubic cubic) {
    reshape(k, cubic);
    return std::make_shared<PolynomialSegment>(cubic);
  });
}

void scale_first_handle(Cubic& cubic, double factor) { cubic[1] = cubic[0] + factor * (cubic[1] - cubic[0]); }

Fit with_joints(Fit fit, Continuity claimed) {
  if (!fit.curve) return fit;
  std::vector<Joint> joints = fit.curve->joints();
  for (Joint& joint : joints) joint.claimed = claimed;
  fit.curve = Curve(fit.curve->segments(), joints, fit.curve->nodes(), fit.curve->closed());
  return fit;
}

template <class Change>
Fit with_nodes(Fit fit, Change change) {
  if (!fit.curve) return fit;
  std::vector<Node> nodes = fit.curve->nodes();
  change(nodes);
  fit.curve = Curve(fit.curve->segments(), fit.curve->joints(), nodes, fit.curve->closed());
  return fit;
}

/// A cubic that lies of its second derivative, alone or in batches.
class LyingSegment final : public Segment {
 public:
  LyingSegment(const Cubic& cubic, bool alone, bool in_batches) : of_(cubic), alone_(alone), in_batches_(in_batches) {}

  [[nodiscard]] Jet jet(double t, int order) const override { return lie(of_.jet(t, order), order, alone_); }
  void jets(std::span<const double> t, int order, std::span<Jet> out) const override {
    for (std::size_t i = 0; i < t.size(); ++i) out[i] = lie(of_.jet(t[i], order), order, in_batches_);
  }
  [[nodiscard]] ExactForm exact() const override { return of_.exact(); }

 private:
  static Jet lie(Jet jet, int order, bool lies) {
    if (lies && order >= 2) jet.d[2] *= 1.001;
    return jet;
  }

  PolynomialSegment of_;
  bool alone_, in_batches_;
};

/// Additions that no compiler leaves out.
void burn(double additions) {
  volatile double sum = 0.0;
  for (double k = 0.0; k < additions; k += 1.0) sum = sum + k;
}

}  // namespace

TEST_CASE("an honest scheme passes") { CHECK(refuted(honest_info(), honest) == Names{}); }

TEST_CASE("false continuity is refuted") {
  SchemeInfo info = honest_info();
  info.traits.continuity = Continuity::g2;
  SECTION("joints that claim G2 and are G1") {
    CHECK(only(refuted(info, [](const Input& input) { return with_joints(honest(input), Continuity::g2); }),
               {"continuity"}));
  }
  SECTION("a scheme that claims G2 of which no joint does") { CHECK(only(refuted(info, honest), {"continuity"})); }
  SECTION("joints that claim G1 and are G0") {
    const auto kinked = [](const Input& input) {
      return reshaped(honest(input), [](int, Cubic& c) { c[1] += 0.01 * (c[3] - c[0]); });
    };
    CHECK(only(refuted(honest_info(), kinked), {"continuity", "reversal"}));
  }
}

TEST_CASE("false locality is refuted") {
  SchemeInfo info = honest_info();
  info.traits.locality = 1;
  CHECK(refuted(info, honest) == Names{"locality"});
}

TEST_CASE("false symmetries are refuted, each by its own claim") {
  SchemeInfo info = honest_info();
  SECTION("reversal") {
    const auto lie = [](const Input& input) {
      return reshaped(honest(input), [](int, Cubic& c) { scale_first_handle(c, 0.9); });
    };
    CHECK(refuted(info, lie) == Names{"reversal"});
  }
  SECTION("cyclic shift: the first segment is not as the others") {
    info.traits.reversal_invariant = false;
    const auto lie = [](const Input& input) {
      return reshaped(honest(input), [](int k, Cubic& c) { scale_first_handle(c, k == 0 ? 0.9 : 1.0); });
    };
    CHECK(refuted(info, lie) == Names{"cyclic shift"});
  }
  SECTION("similarity: a bare length, which large and small drawings meet too") {
    const auto lie = [](const Input& input) {
      return reshaped(honest(input), [](int, Cubic& c) {
        const double factor = 1.0 / (1.0 + 0.001 * (c[3] - c[0]).norm());
        scale_first_handle(c, factor);
        c[2] = c[3] + factor * (c[2] - c[3]);
      });
    };
    CHECK(refuted(info, lie) == Names{"similarity", "far"});
  }
  SECTION("mirror: tangents turned to the left") {
    const auto lie = [](const Input& input) {
      return reshaped(honest(input), [](int, Cubic& c) {
        const auto turned = [](const Vec2& v) { return Vec2(v + 0.1 * left_normal(v)); };
        c[1] = c[0] + turned(c[1] - c[0]);
        c[2] = c[3] + turned(c[2] - c[3]);
      });
    };
    CHECK(refuted(info, lie) == Names{"mirror"});
  }
}

TEST_CASE("state that leaks from fit to fit is refuted, in the last digits too") {
  const auto previous = std::make_shared<std::atomic<int>>(0);
  const auto lie = [previous](const Input& input) {
    const double factor = 1.0 + 0x1p-45 * previous->exchange(input.size());
    return reshaped(honest(input), [&](int, Cubic& c) { scale_first_handle(c, factor); });
  };
  const Names names = refuted(honest_info(), lie);
  CHECK(names.contains("determinism"));
  // Fits at once leak as well; nothing else looks at the last digits.
  CHECK((names == Names{"determinism"} || names == Names{"determinism", "threads"}));
}

TEST_CASE("scratch that threads share is refuted") {
  const auto scratch = std::make_shared<std::atomic<double>>(0.0);
  const auto lie = [scratch](const Input& input) {
    const double own = input.points[0].x();
    scratch->store(own);
    // Long enough that all 8 have written.
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const double factor = scratch->load() == own ? 1.0 : 0.9;
    return reshaped(honest(input), [&](int, Cubic& c) { scale_first_handle(c, factor); });
  };
  CHECK(refuted(honest_info(), lie) == Names{"threads"});
}

TEST_CASE("wrong derivatives are refuted, alone and in batches") {
  for (const auto& [alone, in_batches] : {std::pair{true, true}, {true, false}, {false, true}}) {
    const auto lie = [a = alone, b = in_batches](const Input& input) {
      return with_segments(honest(input),
                           [&](int, const Cubic& cubic) { return std::make_shared<LyingSegment>(cubic, a, b); });
    };
    CHECK(refuted(honest_info(), lie) == Names{"jets"});
  }
}

TEST_CASE("a refit that is not the fit is refuted") {
  const Resolve lie = [](const Fit& fit, const Edit& edit) {
    return reshaped(honest(apply(fit.input, edit)), [](int, Cubic& c) { scale_first_handle(c, 0.99); });
  };
  CHECK(refuted(honest_info(), honest, lie) == Names{"refit"});
}

TEST_CASE("points without a node and nodes beside their points are refuted") {
  SchemeInfo info = honest_info();
  info.traits.locality = -1;
  info.traits.reversal_invariant = info.traits.cyclic_shift_invariant = false;
  const auto missing = [](const Input& input) {
    return with_nodes(honest(input), [](std::vector<Node>& nodes) { nodes.erase(nodes.begin() + 1); });
  };
  CHECK(only(refuted(info, missing), {"interpolation"}));
  const auto beside = [](const Input& input) {
    return with_nodes(honest(input), [](std::vector<Node>& nodes) { nodes[1].t = nodes[1].t == 0.0 ? 1e-3 : 0.999; });
  };
  CHECK(only(refuted(info, beside), {"interpolation"}));
}

TEST_CASE("marks that are not listed and counters that do not count are refuted") {
  const auto marked = [](const Input& input) {
    return with_nodes(honest(input), [](std::vector<Node>& nodes) { nodes[0].marks = {"special"}; });
  };
  CHECK(refuted(honest_info(), marked) == Names{"marks"});
  SchemeInfo info = honest_info();
  info.marks = {{"special", "the first one"}};
  const auto counted = [&](const Input& input) {
    Fit fit = marked(input);
    fit.report.counters["special"] = 2;
    return fit;
  };
  CHECK(refuted(info, counted) == Names{"marks"});
}

TEST_CASE("a throw, silence and a NaN are refuted") {
  const auto four_points = [](const Solve& otherwise) {
    return [otherwise](const Input& input) { return input.size() == 4 ? otherwise(input) : honest(input); };
  };
  CHECK(refuted(honest_info(), four_points([](const Input&) -> Fit { throw std::runtime_error("four"); })) ==
        Names{"outcome"});
  CHECK(refuted(honest_info(), four_points([](const Input& input) {
                  return Fit{.input = input, .curve = std::nullopt, .report = {.outcome = Outcome::failed}};
                })) == Names{"outcome"});
  const auto broken = [](const Input& input) {
    return reshaped(honest(input), [&](int k, Cubic& c) {
      if (k == 2 && input.size() >= 8) c[1].x() = std::numeric_limits<double>::quiet_NaN();
    });
  };
  // The framework may withhold such a curve: then the scheme does not solve what is benign.
  const Names names = refuted(honest_info(), broken);
  CHECK((names.contains("outcome") || names.contains("solves")));
}

TEST_CASE("a scheme that does not solve what is benign is refuted") {
  const auto lie = [](const Input& input) {
    Fit fit = honest(input);
    fit.report.outcome = Outcome::not_converged;
    fit.report.message = "tired";
    return fit;
  };
  CHECK(refuted(honest_info(), lie) == Names{"solves"});
}

TEST_CASE("a curve that the framework finds to miss its own claim is refuted, though the others converge") {
  const auto lie = [](const Input& input) {
    Fit fit = honest(input);
    if (input.size() != 24) return fit;
    fit.report.outcome = Outcome::not_converged;
    fit.report.message = "joint 3 claims G1 and turns by 0.1 rad";
    return fit;
  };
  CHECK(refuted(honest_info(), lie) == Names{"solves"});
}

TEST_CASE("points that are claimed and refused are refuted") {
  const auto refuse = [](const Input& input) {
    return Fit{.input = input,
               .curve = std::nullopt,
               .report = {.outcome = Outcome::unsupported_input, .message = "not such points"}};
  };
  SchemeInfo info = honest_info();
  SECTION("fewest points") {
    CHECK(refuted(info, [&](const Input& input) { return input.size() < 4 ? refuse(input) : honest(input); }) ==
          Names{"points"});
  }
  SECTION("repeats") {
    info.traits.repeats_allowed = true;
    CHECK(refuted(info, honest) == Names{"points"});
  }
  SECTION("closed curves") {
    const Names names = refuted(info, [&](const Input& input) { return input.closed ? refuse(input) : honest(input); });
    CHECK(names.contains("points"));
    CHECK(only(names, {"points"}));
  }
}

TEST_CASE("tangents that are claimed and not met are refuted") {
  SchemeInfo info = honest_info();
  info.traits.hermite = true;
  CHECK(refuted(info, honest) == Names{"hermite"});
}

TEST_CASE("cubic growth is refuted, quadratic is not") {
  const auto burning = [](double factor, int power) {
    return [=](const Input& input) {
      burn(factor * std::pow(input.size(), power));
      return honest(input);
    };
  };
  CHECK(refuted(honest_info(), burning(0.1, 3)) == Names{"growth"});
  CHECK(refuted(honest_info(), burning(2.0, 2)) == Names{});
}
