#include "schemes/api/curve_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <ranges>
#include <span>
#include <vector>

namespace kappabench {

namespace {

std::string quote(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}
std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.17g}", value) : "null"; }
std::string point(const Vec2& p) { return fmt::format("[{},{}]", number(p.x()), number(p.y())); }

/// "[" items "]", each item written by `write`.
template <class Items, class Write>
std::string list(const Items& items, Write write) {
  std::vector<std::string> texts;
  for (const auto& item : items) texts.push_back(write(item));
  return fmt::format("[{}]", fmt::join(texts, ","));
}

std::string segment_json(const Segment& segment);

struct FormJson {
  std::string operator()(const PolynomialForm& form) const {
    return fmt::format(R"({{"type":"polynomial","control_points":{}}})", list(form.control_points, point));
  }
  std::string operator()(const TrigonometricForm& form) const {
    return fmt::format(R"({{"type":"trigonometric","control_points":{}}})", list(form.control_points, point));
  }
  std::string operator()(const ClothoidForm& form) const {
    return fmt::format(R"({{"type":"clothoid","start":{},"angle":{},"curvature":{},"curvature_rate":{},"length":{}}})",
                       point(form.start), number(form.angle), number(form.curvature), number(form.curvature_rate),
                       number(form.length));
  }
  std::string operator()(const IntrinsicForm& form) const {
    return fmt::format(
        R"({{"type":"intrinsic","start":{},"angle":{},"length":{},"degree":{},"knots":{},"control_curvatures":{}}})",
        point(form.start), number(form.angle), number(form.length), form.degree, list(form.knots, number),
        list(form.control_curvatures, number));
  }
  std::string operator()(const BlendForm& form) const {
    return fmt::format(R"({{"type":"blend","from":{},"to":{}}})", segment_json(*form.from), segment_json(*form.to));
  }
  std::string operator()(const EllipticArcForm& form) const {
    return fmt::format(R"({{"type":"elliptic_arc","centre":{},"axis_a":{},"axis_b":{},"from":{},"to":{}}})",
                       point(form.centre), point(form.axis_a), point(form.axis_b), number(form.from), number(form.to));
  }
  std::string operator()(const ReparametrizedForm& form) const {
    return fmt::format(R"({{"type":"reparametrized","start_speed":{},"of":{}}})", number(form.start_speed),
                       segment_json(*form.of));
  }
  std::string operator()(const OpaqueForm&) const { return R"({"type":"opaque"})"; }
};

std::string segment_json(const Segment& segment) { return std::visit(FormJson{}, segment.exact()); }

std::string parameter_json(const ParameterValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return quote(*text);
  if (const auto* real = std::get_if<double>(&value)) return number(*real);
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  return fmt::format("{}", std::get<long>(value));
}

std::string parameters_json(const Parameters& parameters) {
  return fmt::format("{{{}}}", fmt::join(parameters.values() | std::views::transform([](const auto& entry) {
                                           return fmt::format("{}:{}", quote(entry.first),
                                                              parameter_json(entry.second));
                                         }),
                                         ","));
}

std::string counters_json(const std::map<std::string, long>& counters) {
  std::vector<std::string> texts;
  for (const auto& [name, value] : counters) texts.push_back(fmt::format("{}:{}", quote(name), value));
  return fmt::format("{{{}}}", fmt::join(texts, ","));
}

std::string node_json(const Node& node) {
  return fmt::format(R"({{"point":{},"segment":{},"t":{},"pinned":{},"at_inflection":{},"curvature_minimum":{}}})",
                     node.point, node.segment, number(node.t), node.pinned, node.at_inflection, node.curvature_minimum);
}

std::string joint_json(const Joint& joint) {
  return fmt::format(R"({{"segment":{},"claimed":{}}})", joint.segment, quote(name(joint.claimed)));
}

}  // namespace

std::string curve_json(const Scheme& scheme, const Fit& fit) {
  const auto& report = fit.report;
  const bool has_curve = fit.curve.has_value();
  return fmt::format(
      R"({{"format":"kappabench-curve","version":1,"scheme":{},"parameters":{},"closed":{},)"
      R"("outcome":{},"message":{},"iterations":{},"residual":{},"seconds":{},"counters":{},)"
      R"("segments":{},"nodes":{},"joints":{}}})",
      quote(scheme.info().id), parameters_json(scheme.parameters()), fit.input.closed, quote(name(report.outcome)),
      quote(report.message), report.iterations, number(report.residual), number(report.seconds),
      counters_json(report.counters),
      has_curve ? list(fit.curve->segments(), [](const SegmentPtr& segment) { return segment_json(*segment); }) : "[]",
      has_curve ? list(fit.curve->nodes(), node_json) : "[]", has_curve ? list(fit.curve->joints(), joint_json) : "[]");
}

}  // namespace kappabench
