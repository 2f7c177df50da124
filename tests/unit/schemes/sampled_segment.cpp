#include "schemes/segments/sampled.hpp"

#include <cmath>
#include <limits>

#include "schemes/curve/exact_curvature.hpp"
#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"

using namespace kappabench;

namespace {

/// `count` samples of a segment, closer together where t is small.
SampledForm samples(const Segment& of, int count) {
  SampledForm form;
  for (int i = 0; i < count; ++i) {
    const double v = static_cast<double>(i) / (count - 1), t = v * (1.0 + v) / 2.0;
    const Jet jet = of.jet(t, 2);
    form.t.push_back(t);
    form.position.push_back(jet.d[0]);
    form.first.push_back(jet.d[1]);
    form.second.push_back(jet.d[2]);
  }
  return form;
}

const PolynomialSegment wave(std::vector<Vec2>{{0, 0}, {1, 4}, {2, -5}, {3, 4}, {4, 0}});

}  // namespace

TEST_CASE("samples of a quintic or less give it back, with every derivative") {
  const SampledSegment sampled(samples(wave, 7));
  for (const double t : {0.0, 0.01, 0.3, 0.62, 1.0}) {
    const Jet a = sampled.jet(t, 4), b = wave.jet(t, 4);
    for (std::size_t r = 0; r <= 4; ++r)
      CHECK((a.d[r] - b.d[r]).norm() <= 1e-11 * std::pow(10.0, static_cast<double>(r)) * (1.0 + b.d[r].norm()));
  }
  const SegmentPtr placed = sampled.placed({.scale = 2.0, .shift = {1, 1}});
  CHECK((placed->jet(0.4, 2).d[2] - 2.0 * wave.jet(0.4, 2).d[2]).norm() <= 1e-9);
}

TEST_CASE("what is measured on samples is what the curve has, and is called sampled") {
  const SignChanges exact = curvature_extrema(wave), known = inflections(wave);
  for (const int count : {2, 9, 1000}) {
    const SampledSegment sampled(samples(wave, count));
    const SignChanges extrema = curvature_extrema(sampled), changes = inflections(sampled);
    CHECK(extrema.certification == Certification::sampled);
    REQUIRE(extrema.at.size() == exact.at.size());
    for (std::size_t i = 0; i < exact.at.size(); ++i)
      CHECK(extrema.at[i].mid() == Approx(exact.at[i].mid()).margin(1e-6));
    CHECK(changes.at.size() == known.at.size());
  }
}

TEST_CASE("sampled segments refuse what they are not") {
  const SampledForm good = samples(wave, 4);
  const auto refused = [&](auto change) {
    SampledForm form = good;
    change(form);
    CHECK_THROWS_AS(SampledSegment(form), std::invalid_argument);
  };
  refused([](SampledForm& f) { f = {}; });
  refused([](SampledForm& f) { f.position.pop_back(); });
  refused([](SampledForm& f) { f.second.pop_back(); });
  refused([](SampledForm& f) { f.t.front() = 0.1; });
  refused([](SampledForm& f) { f.t.back() = 2.0; });
  refused([](SampledForm& f) { f.t[1] = f.t[2]; });
  refused([](SampledForm& f) { f.t[1] = std::numeric_limits<double>::quiet_NaN(); });
  refused([](SampledForm& f) { f.first[1].x() = std::numeric_limits<double>::infinity(); });
}
