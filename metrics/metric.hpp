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

struct Column;

/// One number of one metric on one curve, made from its column alone. NaN means "not defined here" (the column's help
/// says when).
struct Measurement {
  Measurement(const Column& of, double number, Method got_by);

  std::string column;
  std::string unit;
  double value;
  Method method;
};

/// One column of a metric's table, said once, in the metric's header and there in `namespace column`: metrics make
/// their numbers from it, `column::mvc_energy(1.5, Method::sampled)`, and readers ask for it.
struct Column {
  std::string name;  ///< unique over all metrics, snake_case: "parabola_energy_centred_mean"
  std::string unit;  ///< "1", "1/length", "rad", ...
  std::string help;  ///< one line

  [[nodiscard]] Measurement operator()(double value, Method method) const { return {*this, value, method}; }
};

inline Measurement::Measurement(const Column& of, double number, Method got_by)
    : column(of.name), unit(of.unit), value(number), method(got_by) {}

/// A measurement of a fitted curve. `measure` reads the curve and the input of the fit; metrics of locality and
/// invariance also fit again through the Scheme. It is called only for fits that have a curve, and gives one number for
/// each of `columns`, in their order: those of all_metrics() throw std::logic_error otherwise.
struct Metric {
  std::string id;
  std::string title;
  int version;  ///< raise when values change: cells of older versions are recomputed
  std::vector<Column> columns;
  std::function<std::vector<Measurement>(const Scheme&, const Fit&)> measure;
  bool refits = false;  ///< fits again through the Scheme, many times: asked for by name, not taken by default
};

/// The same metric, of any drawing: in its own frame (schemes/api/frame.hpp), numbers of unit 1/length carried back to
/// the plane; all columns NaN for curves that cannot be measured; held to its columns. all_metrics() are.
[[nodiscard]] Metric guarded(Metric metric);

/// All metrics, in the order of metrics/README.md.
[[nodiscard]] std::span<const Metric> all_metrics();

/// Throws std::invalid_argument naming the known ids.
[[nodiscard]] const Metric& find_metric(std::string_view id);

}  // namespace kappabench
