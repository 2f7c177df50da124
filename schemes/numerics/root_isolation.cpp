#include "schemes/numerics/root_isolation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace kappabench {
namespace {

constexpr int max_double_depth = 40;
constexpr double finest_bracket = 0x1p-51;

int sign_of(const Bounded& a) { return a.sign(); }
int sign_of(const Integer& a) { return a.sign(); }

enum class Variation { none, one, unclear };

/// Unclear means two or more sign changes, or undecided coefficients where they matter. An undecided coefficient
/// between a plus and a minus does not matter: whatever its sign, the number of changes stays one.
Variation variation_of(const BinaryForm<Bounded>& form) {
  if (sign_of(form.front()) == 0 || sign_of(form.back()) == 0) return Variation::unclear;
  int changes = 0;
  int before = sign_of(form.front());
  bool gap = false;
  for (const Bounded& coefficient : form) {
    const int sign = sign_of(coefficient);
    if (sign == 0) {
      gap = true;
      continue;
    }
    if (sign != before) {
      ++changes;
    } else if (gap) {
      return Variation::unclear;
    }
    gap = false;
    before = sign;
  }
  return changes == 0 ? Variation::none : changes == 1 ? Variation::one : Variation::unclear;
}

Bounded value_at(const BinaryForm<Bounded>& form, double t) {
  const Bounded s = Bounded(1.0) - Bounded(t);
  Bounded power(1.0);
  Bounded result = form.back();
  for (std::size_t i = form.size() - 1; i-- > 0;) {
    power = power * s;
    result = result * Bounded(t) + form[i] * power;
  }
  return result;
}

/// The sign of the form at the dyadic number t in (0, 1), exactly.
int sign_at(const BinaryForm<Integer>& form, double t) {
  int exponent = 0;
  const double mantissa = std::frexp(t, &exponent);
  const Integer numerator(static_cast<long long>(std::ldexp(mantissa, 53)));
  const Integer s = (Integer(1) << static_cast<unsigned>(53 - exponent)) - numerator;
  Integer power(1);
  Integer result = form.back();
  for (std::size_t i = form.size() - 1; i-- > 0;) {
    power *= s;
    result = result * numerator + form[i] * power;
  }
  return result.sign();
}

/// Bisects a bracket whose sign right of `lo` is `sign_lo`; `sign` may return 0, for an exact zero or for undecided.
template <class Sign>
RootBracket refine(RootBracket bracket, int sign_lo, bool zero_is_root, const Sign& sign) {
  while (bracket.hi - bracket.lo > finest_bracket) {
    const double mid = bracket.mid();
    if (mid <= bracket.lo || mid >= bracket.hi) break;
    const int at_mid = sign(mid);
    if (at_mid == 0) return zero_is_root ? RootBracket{mid, mid} : bracket;
    (at_mid == sign_lo ? bracket.lo : bracket.hi) = mid;
  }
  return bracket;
}

bool isolate(const BinaryForm<Bounded>& whole, const BinaryForm<Bounded>& part, RootBracket range, int depth,
             std::vector<RootBracket>& found) {
  switch (variation_of(part)) {
    case Variation::none:
      return true;
    case Variation::one:
      found.push_back(
          refine(range, sign_of(part.front()), false, [&](double t) { return sign_of(value_at(whole, t)); }));
      return true;
    case Variation::unclear:
      break;
  }
  if (depth == max_double_depth) return false;
  const auto [left, right] = halves(part);
  if (sign_of(right.front()) == 0) return false;
  return isolate(whole, left, {range.lo, range.mid()}, depth + 1, found) &&
         isolate(whole, right, {range.mid(), range.hi}, depth + 1, found);
}

int variations(const BinaryForm<Integer>& form) {
  int changes = 0;
  int before = 0;
  for (const Integer& coefficient : form) {
    const int sign = sign_of(coefficient);
    if (sign == 0) continue;
    if (before != 0 && sign != before) ++changes;
    before = sign;
  }
  return changes;
}

int first_sign(const BinaryForm<Integer>& form) {
  for (const Integer& coefficient : form) {
    if (coefficient != 0) return sign_of(coefficient);
  }
  return 0;
}

/// `part` is `whole` over `range`, square-free, without roots at its ends.
void isolate(const BinaryForm<Integer>& whole, BinaryForm<Integer> part, RootBracket range,
             std::vector<RootBracket>& found) {
  const int changes = variations(part);
  if (changes == 0) return;
  if (changes == 1) {
    found.push_back(refine(range, first_sign(part), true, [&](double t) { return sign_at(whole, t); }));
    return;
  }
  auto [left, right] = halves(part);
  part.clear();
  const double mid = range.mid();
  const bool root_at_mid = right.front() == 0;
  if (root_at_mid) {
    left.pop_back();
    right.erase(right.begin());
  }
  isolate(whole, std::move(left), {range.lo, mid}, found);
  if (root_at_mid) found.push_back({mid, mid});
  isolate(whole, std::move(right), {mid, range.hi}, found);
}

// Polynomials in x = t / (1 - t) have the same coefficients, lowest first; (0, 1) becomes (0, infinity).

void trim(BinaryForm<Integer>& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

void make_primitive(BinaryForm<Integer>& p) {
  Integer content = 0;
  for (const Integer& coefficient : p) content = gcd(content, coefficient);
  if (content > 1) {
    for (Integer& coefficient : p) coefficient /= content;
  }
}

/// Remainder of a by b up to a constant factor, primitive.
BinaryForm<Integer> pseudo_remainder(BinaryForm<Integer> a, const BinaryForm<Integer>& b) {
  while (a.size() >= b.size()) {
    const Integer common = gcd(a.back(), b.back());
    const Integer of_a = b.back() / common;
    const Integer of_b = a.back() / common;
    const std::size_t shift = a.size() - b.size();
    for (Integer& coefficient : a) coefficient *= of_a;
    for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] -= of_b * b[i];
    trim(a);
  }
  make_primitive(a);
  return a;
}

BinaryForm<Integer> common_divisor(BinaryForm<Integer> a, BinaryForm<Integer> b) {
  while (!b.empty()) {
    BinaryForm<Integer> r = pseudo_remainder(std::move(a), b);
    a = std::move(b);
    b = std::move(r);
  }
  make_primitive(a);
  return a;
}

/// True proves that p has no multiple root: p and its derivative have no common factor modulo a prime that does not
/// divide the leading coefficient, hence none at all. Much faster than the divisor itself, and enough for nearly every
/// curve.
bool square_free_modulo_prime(const BinaryForm<Integer>& p) {
  constexpr std::uint64_t prime = 2147483647;
  using Residues = std::vector<std::uint64_t>;
  const auto trimmed = [](Residues r) {
    while (!r.empty() && r.back() == 0) r.pop_back();
    return r;
  };
  const auto inverse = [](std::uint64_t a) {  // a^(prime - 2)
    std::uint64_t result = 1;
    for (std::uint64_t e = prime - 2; e > 0; e >>= 1U) {
      if (e & 1U) result = result * a % prime;
      a = a * a % prime;
    }
    return result;
  };
  Residues a;
  Residues b;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Integer residue = (p[i] % prime + prime) % prime;
    a.push_back(residue.convert_to<std::uint64_t>());
    if (i > 0) b.push_back(a.back() * i % prime);
  }
  if (a.back() == 0) return false;
  b = trimmed(b);
  while (!b.empty()) {
    while (a.size() >= b.size()) {
      const std::uint64_t factor = a.back() * inverse(b.back()) % prime;
      const std::size_t shift = a.size() - b.size();
      for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] = (a[i + shift] + (prime - factor) * b[i]) % prime;
      a = trimmed(a);
    }
    std::swap(a, b);
  }
  return a.size() == 1;
}

/// a / b for primitive b that divides the primitive a (Gauss's lemma: the quotient has integer coefficients).
BinaryForm<Integer> exact_quotient(BinaryForm<Integer> a, const BinaryForm<Integer>& b) {
  BinaryForm<Integer> quotient(a.size() - b.size() + 1, Integer(0));
  for (std::size_t k = quotient.size(); k-- > 0;) {
    quotient[k] = a[k + b.size() - 1] / b.back();
    for (std::size_t i = 0; i < b.size(); ++i) a[i + k] -= quotient[k] * b[i];
  }
  return quotient;
}

}  // namespace

std::optional<std::vector<RootBracket>> isolate_sign_changes(const BinaryForm<Bounded>& form) {
  if (form.empty()) return std::nullopt;
  std::vector<RootBracket> found;
  if (sign_of(form.front()) == 0 || sign_of(form.back()) == 0) return std::nullopt;
  if (!isolate(form, form, {0.0, 1.0}, 0, found)) return std::nullopt;
  return found;
}

BinaryForm<Integer> odd_part(const BinaryForm<Integer>& form) {
  BinaryForm<Integer> p = form;
  trim(p);
  p.erase(p.begin(), std::find_if(p.begin(), p.end(), [](const Integer& c) { return c != 0; }));
  if (p.size() < 2) return p;
  make_primitive(p);
  if (square_free_modulo_prime(p)) return p;
  BinaryForm<Integer> rest = common_divisor(p, partial_t(p));
  if (rest.size() == 1) return p;
  BinaryForm<Integer> factors = exact_quotient(p, rest);
  BinaryForm<Integer> odd{Integer(1)};
  for (bool multiplicity_is_odd = true; factors.size() > 1; multiplicity_is_odd = !multiplicity_is_odd) {
    const BinaryForm<Integer> shared = common_divisor(factors, rest);
    if (multiplicity_is_odd) odd = product(odd, exact_quotient(factors, shared));
    rest = exact_quotient(rest, shared);
    factors = shared;
  }
  return odd;
}

std::vector<RootBracket> isolate_sign_changes(const BinaryForm<Integer>& form) {
  const BinaryForm<Integer> simple = odd_part(form);
  std::vector<RootBracket> found;
  if (simple.size() > 1) isolate(simple, simple, {0.0, 1.0}, found);
  return found;
}

}  // namespace kappabench
