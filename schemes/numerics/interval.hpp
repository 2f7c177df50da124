#pragma once

#include <algorithm>
#include <boost/numeric/interval/arith.hpp>
#include <boost/numeric/interval/arith2.hpp>
#include <boost/numeric/interval/checking.hpp>
#include <boost/numeric/interval/interval.hpp>
#include <boost/numeric/interval/policies.hpp>
#include <boost/numeric/interval/rounding.hpp>
#include <boost/numeric/interval/transc.hpp>
#include <boost/numeric/interval/utility.hpp>
#include <cmath>
#include <limits>

namespace kappabench {

namespace detail {

/// A rounding policy of Boost.Interval that leaves the processor's rounding mode alone: each result is moved outward by
/// at least one unit in its last place, twice what rounding to nearest can have done to it. As rigorous where there are
/// no rounding modes (WebAssembly), faster where there are, and safe from optimisers that assume the usual one.
struct OutwardRounding {
  static double down(double v) { return v - (std::abs(v) * 0x1p-52 + std::numeric_limits<double>::min()); }
  static double up(double v) { return v + (std::abs(v) * 0x1p-52 + std::numeric_limits<double>::min()); }

  void init() {}
  template <class Exact>
  double conv_down(const Exact& v) {
    return v;
  }
  template <class Exact>
  double conv_up(const Exact& v) {
    return v;
  }
  double add_down(double x, double y) { return down(x + y); }
  double add_up(double x, double y) { return up(x + y); }
  double sub_down(double x, double y) { return down(x - y); }
  double sub_up(double x, double y) { return up(x - y); }
  double mul_down(double x, double y) { return down(x * y); }
  double mul_up(double x, double y) { return up(x * y); }
  double div_down(double x, double y) { return down(x / y); }
  double div_up(double x, double y) { return up(x / y); }
  double median(double x, double y) { return 0.5 * (x + y); }
  double int_down(double x) { return std::floor(x); }
  double int_up(double x) { return std::ceil(x); }
  // The cosine of a mathematical library is good to one unit in the last place: two are given.
  double cos_down(double x) { return std::max(-1.0, down(down(std::cos(x)))); }
  double cos_up(double x) { return std::min(1.0, up(up(std::cos(x)))); }
};

}  // namespace detail

/// An interval that holds the exact result of the operations it came from. A number that is not finite makes it empty
/// or NaN, for which every comparison below is false: nothing is then claimed.
using Interval = boost::numeric::interval<
    double,
    boost::numeric::interval_lib::policies<boost::numeric::interval_lib::save_state_nothing<detail::OutwardRounding>,
                                           boost::numeric::interval_lib::checking_base<double>>>;

/// The certified sign: 1, -1, or 0 for "undecided".
[[nodiscard]] inline int sign_of(const Interval& v) { return v.lower() > 0.0 ? 1 : v.upper() < 0.0 ? -1 : 0; }

/// Bounds of the absolute value.
[[nodiscard]] inline double largest(const Interval& v) { return std::max(std::abs(v.lower()), std::abs(v.upper())); }

}  // namespace kappabench
