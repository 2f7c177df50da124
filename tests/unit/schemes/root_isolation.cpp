#include "schemes/numerics/root_isolation.hpp"

#include <random>

#include "tests/catch.hpp"

using namespace kappabench;

namespace {

/// (q t - p s-part): the linear form with its root at t = p / q, i.e. q t - p (s + t).
BinaryForm<Integer> linear(int p, int q) {
  BinaryForm<Integer> form;
  form.emplace_back(-p);
  form.emplace_back(q - p);
  return form;
}

BinaryForm<Integer> power(const BinaryForm<Integer>& form, int k) {
  BinaryForm<Integer> result(1, Integer(1));
  for (int i = 0; i < k; ++i) result = product(result, form);
  return result;
}

BinaryForm<Bounded> bounded(const BinaryForm<Integer>& form) {
  BinaryForm<Bounded> result;
  for (const Integer& c : form) result.emplace_back(c.convert_to<double>());
  return result;
}

}  // namespace

TEST_CASE("exact isolation counts roots of odd multiplicity once and skips even ones", "[roots]") {
  // (t - 1/3)(t - 1/2)^2 (t - 3/5)^3 (t - 4/5)^4, and roots at 0, 1 and outside.
  BinaryForm<Integer> form = product(power(linear(1, 3), 1), power(linear(1, 2), 2));
  form = product(form, product(power(linear(3, 5), 3), power(linear(4, 5), 4)));
  form = product(form, product(power(linear(0, 1), 2), power(linear(1, 1), 1)));
  form = product(form, product(linear(7, 5), linear(-1, 9)));
  const auto roots = isolate_sign_changes(form);
  REQUIRE(roots.size() == 2);
  CHECK(roots[0].lo <= 1.0 / 3.0);
  CHECK(roots[0].hi >= 1.0 / 3.0);
  CHECK(roots[1].mid() == Approx(0.6).epsilon(1e-14));
  for (const RootBracket& root : roots) CHECK(root.hi - root.lo <= 1e-15);
}

TEST_CASE("a root at a bisection point is found exactly", "[roots]") {
  // Roots 1/4, 1/2, 3/4, and 5/8: the bisection meets three of them.
  BinaryForm<Integer> form = product(product(linear(1, 4), linear(1, 2)), product(linear(3, 4), linear(5, 8)));
  const auto roots = isolate_sign_changes(form);
  REQUIRE(roots.size() == 4);
  const double expected[] = {0.25, 0.5, 0.625, 0.75};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(roots[i].lo <= expected[i]);
    CHECK(roots[i].hi >= expected[i]);
    CHECK(roots[i].hi - roots[i].lo <= 1e-15);
  }
}

TEST_CASE("the zero and the constant polynomial have no sign changes", "[roots]") {
  CHECK(isolate_sign_changes(BinaryForm<Integer>{}).empty());
  CHECK(isolate_sign_changes(BinaryForm<Integer>(5, Integer(0))).empty());
  CHECK(isolate_sign_changes(BinaryForm<Integer>(1, Integer(7))).empty());
  CHECK_FALSE(isolate_sign_changes(BinaryForm<Bounded>(5, Bounded(0.0))).has_value());
}

TEST_CASE("two roots closer than a double can tell are still separated exactly", "[roots]") {
  // Roots at 1/3 and 1/3 + 1e-9 / 3.
  BinaryForm<Integer> second;
  second.emplace_back(-1000000001);
  second.emplace_back(3000000000LL - 1000000001LL);
  const auto roots = isolate_sign_changes(product(linear(1, 3), second));
  REQUIRE(roots.size() == 2);
  CHECK(roots[1].mid() - roots[0].mid() == Approx(1e-9 / 3.0).epsilon(1e-5));
}

TEST_CASE("double precision refuses what rounding leaves open", "[roots]") {
  CHECK_FALSE(isolate_sign_changes(bounded(product(linear(1, 3), linear(1, 3)))).has_value());
  CHECK_FALSE(isolate_sign_changes(bounded(product(linear(0, 1), linear(1, 3)))).has_value());
}

TEST_CASE("double precision agrees with exact arithmetic wherever it decides", "[roots]") {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> coefficient(-1000, 1000);
  int decided = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    BinaryForm<Integer> form;
    const int degree = 1 + trial % 14;
    for (int i = 0; i <= degree; ++i) form.emplace_back(coefficient(random));
    const auto exact = isolate_sign_changes(form);
    const auto fast = isolate_sign_changes(bounded(form));
    if (!fast) continue;
    ++decided;
    REQUIRE(fast->size() == exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
      CHECK((*fast)[i].lo <= exact[i].hi);
      CHECK((*fast)[i].hi >= exact[i].lo);
    }
  }
  CHECK(decided > 1900);
}

TEST_CASE("bounds of Bounded hold the exact value", "[roots]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int trial = 0; trial < 1000; ++trial) {
    using Rational = boost::multiprecision::cpp_rational;
    Bounded b(number(random));
    Rational exact(b.value);
    for (int i = 0; i < 8; ++i) {
      const double x = number(random);
      const double y = number(random);
      b = b * Bounded(x) + Bounded(y) - Bounded(0.1);
      exact = exact * Rational(x) + Rational(y) - Rational(0.1);
    }
    CHECK(abs(exact - Rational(b.value)) <= Rational(b.error));
    CHECK(b.error < 1e-14);
  }
}
