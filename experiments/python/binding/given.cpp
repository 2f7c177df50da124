#include "experiments/python/binding/given.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "schemes/api/read_curve_json.hpp"
#include "schemes/api/soundness.hpp"

namespace kappabench::python {

namespace {

/// Stands for the scheme of a curve that was read.
class GivenScheme final : public Scheme {
 public:
  GivenScheme(SchemeInfo info, Parameters parameters) : Scheme(std::move(info), std::move(parameters)) {}

 private:
  [[nodiscard]] Fit solve(const Input& input) const override {
    return {
        .input = input,
        .curve = std::nullopt,
        .report = {.outcome = Outcome::unsupported_input, .message = "a curve that was read cannot be fitted again"}};
  }
};

SchemePtr scheme_with(std::string id, std::vector<ParameterSpec> specs, const CurveRecord& record) {
  SchemeInfo info{
      .id = std::move(id), .title = "a curve that was read", .citation = {}, .parameters = std::move(specs)};
  Parameters parameters(info.parameters, record.parameters);
  return std::make_shared<const GivenScheme>(std::move(info), std::move(parameters));
}

SchemePtr scheme_of(const CurveRecord& record, const Registry& registry) {
  const std::vector<SchemeInfo> known = registry.list();
  const auto scheme = std::ranges::find(known, record.scheme, &SchemeInfo::id);
  try {
    if (scheme != known.end()) return scheme_with(record.scheme, scheme->parameters, record);
  } catch (const std::invalid_argument&) {
    // Another scheme of that name, or another version of it: the record's own parameters will do.
  }
  std::vector<ParameterSpec> specs;
  specs.reserve(record.parameters.size());
  for (const auto& [name, value] : record.parameters)
    specs.push_back({.name = name, .default_value = value, .help = {}});
  return scheme_with(record.scheme.empty() ? "curve" : record.scheme, std::move(specs), record);
}

std::vector<Vec2> ends_of_segments(const CurveRecord& record, bool closed) {
  std::vector<Vec2> points;
  points.reserve(record.segments.size() + 1);
  for (const SegmentPtr& segment : record.segments) points.push_back(position_at(*segment, 0.0));
  if (!closed) points.push_back(position_at(*record.segments.back(), 1.0));
  return points;
}

/// Where the nodes are, by their points.
std::vector<Vec2> places_of_nodes(const CurveRecord& record, std::string_view source) {
  std::vector<Vec2> points;
  const double missing = std::numeric_limits<double>::quiet_NaN();
  for (const Node& node : *record.nodes) {
    const auto point = static_cast<std::size_t>(node.point);
    if (point >= points.size()) points.resize(std::min(point, record.nodes->size()) + 1, {missing, missing});
    if (point >= points.size() || node.segment < 0 || node.segment >= static_cast<int>(record.segments.size()))
      continue;
    if (!points[point].allFinite())
      points[point] = position_at(*record.segments[static_cast<std::size_t>(node.segment)], node.t);
  }
  if (std::ranges::any_of(points, [](const Vec2& p) { return !p.allFinite(); }))
    throw std::invalid_argument(fmt::format("{}: nodes leave out a point; give the points", source));
  return points;
}

Input input_of(const CurveRecord& record, std::string_view source) {
  const bool closed = record.closed.value_or(false);
  const bool by_nodes = record.nodes && !record.nodes->empty();
  return {.points = record.segments.empty() ? std::vector<Vec2>{}
                    : by_nodes              ? places_of_nodes(record, source)
                                            : ends_of_segments(record, closed),
          .closed = closed};
}

Fitted given(const CurveRecord& record, std::string_view source, const Registry& registry,
             const std::optional<Input>& points) {
  Fitted fitted{scheme_of(record, registry),
                {.input = points ? *points : input_of(record, source), .report = record.report}};
  Fit& fit = fitted.fit;
  fit.input.closed = record.closed.value_or(fit.input.closed);
  if (record.segments.empty()) {
    if (fit.report.outcome == Outcome::converged) fit.report.outcome = Outcome::failed;
    return fitted;
  }
  fit.curve = curve_of(record, {.closed = fit.input.closed, .points = fit.input.points});
  if (fit.report.outcome != Outcome::converged) return fitted;
  if (std::string miss = unsoundness(*fit.curve, fit.input); !miss.empty()) {
    fit.report.outcome = Outcome::not_converged;
    fit.report.message = "misses its claim: " + miss;
  }
  return fitted;
}

}  // namespace

std::vector<Fitted> given_curves(std::string_view json, std::string_view source, const Registry& registry,
                                 const std::optional<Input>& points) {
  const std::vector<CurveRecord> records = read_curves(json, source);
  std::vector<Fitted> curves;
  curves.reserve(records.size());
  for (const CurveRecord& record : records) curves.push_back(given(record, source, registry, points));
  return curves;
}

bool is_given(const Scheme& scheme) { return dynamic_cast<const GivenScheme*>(&scheme) != nullptr; }

}  // namespace kappabench::python
