#include "schemes/api/curve_json.hpp"

#include <nlohmann/json.hpp>
#include <variant>
#include <vector>

namespace kappabench {

namespace {

// A number that is not finite becomes null, any other the shortest text that reads back to the same bits.
using Json = nlohmann::ordered_json;

Json json_of(const Vec2& p) { return Json::array({p.x(), p.y()}); }

Json json_of(const SegmentPtr& segment);
Json json_of(const Node& node);
Json json_of(const Joint& joint);

/// The items as an array, each by its own json_of.
template <class Item>
Json json_of(const std::vector<Item>& items) {
  Json list = Json::array();
  for (const Item& item : items) list.push_back(json_of(item));
  return list;
}

/// One coordinate of many vectors.
std::vector<double> coordinates(const std::vector<Vec2>& vectors, int axis) {
  std::vector<double> values;
  values.reserve(vectors.size());
  for (const Vec2& v : vectors) values.push_back(v[axis]);
  return values;
}

/// What a segment without a form is written as.
SampledForm samples_of(const Segment& segment) {
  constexpr int steps = 128;
  SampledForm form;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Jet jet = segment.jet(t, 2);
    form.t.push_back(t);
    form.position.push_back(jet.d[0]);
    form.first.push_back(jet.d[1]);
    form.second.push_back(jet.d[2]);
  }
  return form;
}

struct FormJson {
  const Segment& segment;

  Json operator()(const PolynomialForm& form) const {
    return {{"type", "polynomial"}, {"control_points", json_of(form.control_points)}};
  }
  Json operator()(const RationalForm& form) const {
    return {{"type", "rational"}, {"control_points", json_of(form.control_points)}, {"weights", form.weights}};
  }
  Json operator()(const TrigonometricForm& form) const {
    Json points = Json::array();
    for (const Vec2& p : form.control_points) points.push_back(json_of(p));
    return {{"type", "trigonometric"}, {"control_points", points}};
  }
  Json operator()(const ClothoidForm& form) const {
    return {{"type", "clothoid"},          {"start", json_of(form.start)},          {"angle", form.angle},
            {"curvature", form.curvature}, {"curvature_rate", form.curvature_rate}, {"length", form.length}};
  }
  Json operator()(const IntrinsicForm& form) const {
    return {{"type", "intrinsic"},
            {"start", json_of(form.start)},
            {"angle", form.angle},
            {"length", form.length},
            {"degree", form.degree},
            {"knots", form.knots},
            {"control_curvatures", form.control_curvatures}};
  }
  Json operator()(const BlendForm& form) const {
    return {{"type", "blend"}, {"from", json_of(form.from)}, {"to", json_of(form.to)}};
  }
  Json operator()(const EllipticArcForm& form) const {
    return {{"type", "elliptic_arc"},
            {"centre", json_of(form.centre)},
            {"axis_a", json_of(form.axis_a)},
            {"axis_b", json_of(form.axis_b)},
            {"from", form.from},
            {"to", form.to}};
  }
  Json operator()(const ReparametrizedForm& form) const {
    return {{"type", "reparametrized"}, {"start_speed", form.start_speed}, {"of", json_of(form.of)}};
  }
  Json operator()(const SampledForm& form) const {
    return {{"type", "sampled"},
            {"t", form.t},
            {"x", coordinates(form.position, 0)},
            {"y", coordinates(form.position, 1)},
            {"dx", coordinates(form.first, 0)},
            {"dy", coordinates(form.first, 1)},
            {"ddx", coordinates(form.second, 0)},
            {"ddy", coordinates(form.second, 1)}};
  }
  Json operator()(const OpaqueForm&) const { return (*this)(samples_of(segment)); }
};

Json json_of(const SegmentPtr& segment) { return std::visit(FormJson{*segment}, segment->exact()); }

Json json_of(const Node& node) {
  return {{"point", node.point}, {"segment", node.segment}, {"t", node.t}, {"marks", node.marks}};
}

Json json_of(const Joint& joint) { return {{"segment", joint.segment}, {"claimed", name(joint.claimed)}}; }

Json json_of(const Parameters& parameters) {
  Json object = Json::object();
  for (const auto& entry : parameters.values())
    std::visit([&](const auto& value) { object[entry.first] = value; }, entry.second);
  return object;
}

Json json_of(const Scheme& scheme, const Fit& fit) {
  const Report& report = fit.report;
  Json counters = Json::object(), warnings = Json::array();
  for (const auto& [counter, value] : report.counters) counters[counter] = value;
  for (const auto& warning : report.warnings) warnings.push_back(warning.first);
  return {{"format", "kappabench-curve"},
          {"version", 2},
          {"scheme", scheme.info().id},
          {"parameters", json_of(scheme.parameters())},
          {"closed", fit.input.closed},
          {"outcome", name(report.outcome)},
          {"message", report.message},
          {"warnings", warnings},
          {"iterations", report.iterations},
          {"residual", report.residual},
          {"seconds", report.seconds},
          {"counters", counters},
          {"segments", fit.curve ? json_of(fit.curve->segments()) : Json::array()},
          {"nodes", fit.curve ? json_of(fit.curve->nodes()) : Json::array()},
          {"joints", fit.curve ? json_of(fit.curve->joints()) : Json::array()}};
}

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

std::string curve_json(const Scheme& scheme, const Fit& fit) { return text_of(json_of(scheme, fit)); }

std::string curves_json(const Scheme& scheme, std::span<const Fit> fits) {
  std::string text = "[";
  for (const Fit& fit : fits) {
    if (text.size() > 1) text += ",\n";
    text += text_of(json_of(scheme, fit));
  }
  return text + "]\n";
}

}  // namespace kappabench
