#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "schemes/api/scheme.hpp"

namespace kappabench {

/// How a number was got: `exact` by closed form or certified root isolation (to rounding), `enclosed` by an
/// interval that is known to hold it, `sampled` from finitely many evaluations.
enum class Method { exact, enclosed, sampled };

[[nodiscard]] std::string_view name(Method method);

/// One number of one metric on one curve. NaN means "not defined here" (its column's help says when).
struct Measurement {
  std::string column;
  double value;
  Method method;
};

/// One column of a metric's table.
struct Column {
  std::string name;  ///< unique over all metrics, snake_case: "parabola_energy_centred_mean"
  std::string unit;  ///< "1", "1/length", "rad", ...
  std::string help;  ///< one line
};

/// A measurement of a fitted curve. `measure` reads the curve and the input of the fit; metrics of locality and
/// invariance also fit again through the Scheme. It is called only for fits that have a curve.
struct Metric {
  std::string id;
  std::string title;
  int version;  ///< raise when values change: cells of older versions are recomputed
  std::vector<Column> columns;
  std::function<std::vector<Measurement>(const Scheme&, const Fit&)> measure;
  bool refits = false;  ///< fits again through the Scheme, many times: asked for by name, not taken by default
};

/// All metrics, in the order of metrics/README.md.
[[nodiscard]] std::span<const Metric> all_metrics();

/// Throws std::invalid_argument naming the known ids.
[[nodiscard]] const Metric& find_metric(std::string_view id);

}  // namespace kappabench
