#include "schemes/api/read_curve_json.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "schemes/api/find_nodes.hpp"
#include "schemes/segments/blend.hpp"
#include "schemes/segments/clothoid.hpp"
#include "schemes/segments/elliptic_arc.hpp"
#include "schemes/segments/intrinsic.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/rational.hpp"
#include "schemes/segments/reparametrized.hpp"
#include "schemes/segments/sampled.hpp"
#include "schemes/segments/trigonometric.hpp"

namespace kappabench {

namespace {

using Json = nlohmann::json;

/// A value of the text and how a person finds it, "mine.json: curve 1: segments[3].weights".
class Field {
 public:
  Field(const Json& value, std::string place) : value_(&value), place_(std::move(place)) {}

  [[noreturn]] void refuse(std::string_view expected) const {
    std::string found = value_->dump(-1, ' ', false, Json::error_handler_t::replace);
    constexpr std::size_t most = 40;
    if (found.size() > most) found = std::string(value_->type_name());
    throw std::invalid_argument(fmt::format("{}: {}; {}", place_, found, expected));
  }

  [[nodiscard]] bool has(const char* key) const { return value_->contains(key); }
  [[nodiscard]] Field operator[](const char* key) const {
    const auto found = value_->find(key);
    if (found == value_->end()) throw std::invalid_argument(fmt::format("{}: no \"{}\", which is needed", place_, key));
    return {*found, place_.ends_with(' ') ? place_ + key : place_ + "." + key};
  }
  [[nodiscard]] std::vector<Field> items() const {
    if (!value_->is_array()) refuse("a list is needed");
    std::vector<Field> list;
    list.reserve(value_->size());
    for (const Json& item : *value_) list.emplace_back(item, fmt::format("{}[{}]", place_, list.size()));
    return list;
  }
  template <class Item, class Read>
  [[nodiscard]] std::vector<Item> list_of(const Read& read) const {
    std::vector<Item> list;
    for (const Field& item : items()) list.push_back(read(item));
    return list;
  }

  [[nodiscard]] double number() const {
    if (!value_->is_number() || !std::isfinite(value_->get<double>())) refuse("a number is needed");
    return value_->get<double>();
  }
  [[nodiscard]] double number_or_null() const {
    return value_->is_null() ? std::numeric_limits<double>::quiet_NaN() : number();
  }
  [[nodiscard]] int index(std::size_t below) const {
    const double value = number();
    if (!value_->is_number_integer() || !(value >= 0.0 && value < static_cast<double>(below)))
      refuse(fmt::format("a whole number from 0 to {} is needed", static_cast<long>(below) - 1));
    return static_cast<int>(value);
  }
  [[nodiscard]] long whole() const {
    constexpr double most = 1e15;  // which a double still counts
    if (!value_->is_number_integer() || !(std::abs(number()) <= most)) refuse("a whole number is needed");
    return value_->get<long>();
  }
  [[nodiscard]] bool flag() const {
    if (!value_->is_boolean()) refuse("true or false is needed");
    return value_->get<bool>();
  }
  [[nodiscard]] std::string text() const {
    if (!value_->is_string()) refuse("a text is needed");
    return value_->get<std::string>();
  }
  [[nodiscard]] Vec2 point() const {
    if (!value_->is_array() || value_->size() != 2) refuse("a point [x, y] is needed");
    const std::vector<Field> xy = items();
    return {xy[0].number(), xy[1].number()};
  }
  [[nodiscard]] std::vector<double> numbers() const {
    return list_of<double>([](const Field& item) { return item.number(); });
  }
  [[nodiscard]] std::vector<Vec2> points() const {
    return list_of<Vec2>([](const Field& item) { return item.point(); });
  }
  [[nodiscard]] const Json& value() const { return *value_; }
  [[nodiscard]] const std::string& place() const { return place_; }

 private:
  const Json* value_;
  std::string place_;
};

constexpr int deepest = 8;  // blends of reparametrisations of ...: no more makes sense, and a stack is finite

SegmentPtr segment_of(const Field& json, int depth = 0);

std::vector<Vec2> vectors_of(const Field& json, const char* x, const char* y) {
  const std::vector<double> xs = json[x].numbers(), ys = json[y].numbers();
  if (xs.size() != ys.size()) json.refuse(fmt::format("as many {} as {} are needed", x, y));
  std::vector<Vec2> vectors;
  vectors.reserve(xs.size());
  for (std::size_t i = 0; i < xs.size(); ++i) vectors.emplace_back(xs[i], ys[i]);
  return vectors;
}

SegmentPtr trigonometric(const Field& json) {
  const std::vector<Vec2> p = json["control_points"].points();
  std::array<Vec2, 5> controls;
  if (p.size() != controls.size()) json["control_points"].refuse("5 control points are needed");
  std::ranges::copy(p, controls.begin());
  return std::make_shared<TrigonometricSegment>(controls);
}

double positive(const Field& json) {
  const double value = json.number();
  if (!(value > 0.0)) json.refuse("a positive number is needed");
  return value;
}

IntrinsicForm intrinsic(const Field& json) {
  constexpr std::size_t above_highest_degree = 10;  // BSplineBasis
  return {.start = json["start"].point(),
          .angle = json["angle"].number(),
          .length = positive(json["length"]),
          .degree = json["degree"].index(above_highest_degree),
          .knots = json["knots"].numbers(),
          .control_curvatures = json["control_curvatures"].numbers()};
}

/// Kinds of segments check what they are made from; what they throw gets its place.
SegmentPtr segment_of_type(std::string_view type, const Field& json, int depth) {
  const auto points = [&] { return json["control_points"].points(); };
  if (type == "polynomial") return std::make_shared<PolynomialSegment>(points());
  if (type == "rational")
    return std::make_shared<RationalSegment>(
        RationalForm{.control_points = points(), .weights = json["weights"].numbers()});
  if (type == "trigonometric") return trigonometric(json);
  if (type == "clothoid")
    return std::make_shared<ClothoidSegment>(ClothoidForm{.start = json["start"].point(),
                                                          .angle = json["angle"].number(),
                                                          .curvature = json["curvature"].number(),
                                                          .curvature_rate = json["curvature_rate"].number(),
                                                          .length = positive(json["length"])});
  if (type == "intrinsic") return std::make_shared<IntrinsicSegment>(intrinsic(json));
  if (type == "elliptic_arc")
    return std::make_shared<EllipticArcSegment>(EllipticArcForm{.centre = json["centre"].point(),
                                                                .axis_a = json["axis_a"].point(),
                                                                .axis_b = json["axis_b"].point(),
                                                                .from = json["from"].number(),
                                                                .to = json["to"].number()});
  if (type == "blend")
    return std::make_shared<BlendSegment>(segment_of(json["from"], depth + 1), segment_of(json["to"], depth + 1));
  if (type == "reparametrized")
    return std::make_shared<ReparametrizedSegment>(segment_of(json["of"], depth + 1), positive(json["start_speed"]));
  if (type == "sampled")
    return std::make_shared<SampledSegment>(SampledForm{.t = json["t"].numbers(),
                                                        .position = vectors_of(json, "x", "y"),
                                                        .first = vectors_of(json, "dx", "dy"),
                                                        .second = vectors_of(json, "ddx", "ddy")});
  json["type"].refuse(
      "known are polynomial, rational, trigonometric, clothoid, intrinsic, elliptic_arc, blend, reparametrized, "
      "sampled");
}

SegmentPtr segment_of(const Field& json, int depth) {
  if (!json.value().is_object()) json.refuse("a segment is an object");
  if (depth > deepest) json.refuse(fmt::format("segments within segments go {} deep at most", deepest));
  const std::string type = json["type"].text();
  try {
    return segment_of_type(type, json, depth);
  } catch (const std::invalid_argument& error) {
    const std::string_view why = error.what();
    if (why.starts_with(json.place())) throw;
    throw std::invalid_argument(fmt::format("{}: {}", json.place(), why));
  }
}

Continuity continuity_of(const Field& json) {
  using enum Continuity;
  const std::string text = json.text();
  for (const Continuity known : {g0, g1, g1_equal_magnitude, g2, c1, c2})
    if (name(known) == text) return known;
  json.refuse("known are G0, G1, G1 |k|, G2, C1, C2");
}

Outcome outcome_of(const Field& json) {
  using enum Outcome;
  const std::string text = json.text();
  for (const Outcome known : {converged, not_converged, unsupported_input, failed, timed_out, crashed})
    if (name(known) == text) return known;
  json.refuse("known are converged, not_converged, unsupported_input, failed, timed_out, crashed");
}

ParameterValue parameter_of(const Field& json) {
  if (json.value().is_boolean()) return json.flag();
  if (json.value().is_number_integer()) return json.whole();
  if (json.value().is_number()) return json.number();
  return json.text();
}

Node node_of(const Field& json, std::size_t segments) {
  constexpr std::size_t most_points = std::size_t{1} << 30U;
  Node node{
      .point = json["point"].index(most_points), .segment = json["segment"].index(segments), .t = json["t"].number()};
  if (!(node.t >= 0.0 && node.t <= 1.0)) json["t"].refuse("a parameter from 0 to 1 is needed");
  if (json.has("marks")) node.marks = json["marks"].list_of<std::string>([](const Field& mark) { return mark.text(); });
  return node;
}

Joint joint_of(const Field& json, std::size_t segments) {
  return {.segment = json["segment"].index(segments), .claimed = continuity_of(json["claimed"])};
}

Report report_of(const Field& json) {
  Report report{.outcome = Outcome::converged};
  if (json.has("outcome")) report.outcome = outcome_of(json["outcome"]);
  if (json.has("message")) report.message = json["message"].text();
  if (json.has("iterations")) report.iterations = static_cast<int>(json["iterations"].whole());
  if (json.has("residual")) report.residual = json["residual"].number_or_null();
  if (json.has("seconds")) report.seconds = json["seconds"].number_or_null();
  if (json.has("counters"))
    for (const auto& [name, count] : json["counters"].value().items())
      report.counters[name] = Field(count, json.place() + "counters." + name).whole();
  if (json.has("warnings"))
    for (const Field& warning : json["warnings"].items()) report.warnings[warning.text()] = 1;
  return report;
}

void check_head(const Field& json) {
  if (!json.value().is_object()) json.refuse("a curve is an object");
  if (json.has("format") && json["format"].text() != "kappabench-curve")
    json["format"].refuse("\"kappabench-curve\" is needed");
  if (json.has("version") && json["version"].value() != 1 && json["version"].value() != 2)
    json["version"].refuse("versions 1 and 2 are known");
}

CurveRecord record_of(const Field& json) {
  check_head(json);
  CurveRecord record{.report = report_of(json)};
  if (json.has("scheme")) record.scheme = json["scheme"].text();
  if (json.has("parameters"))
    for (const auto& [name, value] : json["parameters"].value().items())
      record.parameters[name] = parameter_of(Field(value, json.place() + "parameters." + name));
  if (json.has("closed")) record.closed = json["closed"].flag();
  if (json.has("segments") || record.report.outcome == Outcome::converged)
    record.segments = json["segments"].list_of<SegmentPtr>([](const Field& item) { return segment_of(item); });
  const std::size_t count = record.segments.size();
  if (json.has("nodes"))
    record.nodes = json["nodes"].list_of<Node>([count](const Field& item) { return node_of(item, count); });
  if (json.has("joints"))
    record.joints = json["joints"].list_of<Joint>([count](const Field& item) { return joint_of(item, count); });
  return record;
}

Json parsed(std::string_view text, std::string_view source) {
  try {
    return Json::parse(text);
  } catch (const Json::exception& error) {
    // "[json.exception.parse_error.101] parse error at line 1, column 9: ..."
    const std::string_view words = error.what();
    const std::size_t start = words.find("] ");
    throw std::invalid_argument(
        fmt::format("{}: not JSON: {}", source, words.substr(start == std::string_view::npos ? 0 : start + 2)));
  }
}

}  // namespace

std::vector<CurveRecord> read_curves(std::string_view json, std::string_view source) {
  const Json document = parsed(json, source);
  if (document.is_object()) return {record_of(Field(document, fmt::format("{}: ", source)))};
  if (!document.is_array() || document.empty())
    throw std::invalid_argument(
        fmt::format("{}: no curve; an array of objects of format kappabench-curve is needed", source));
  std::vector<CurveRecord> records;
  records.reserve(document.size());
  for (const Json& object : document)
    records.push_back(record_of(Field(object, fmt::format("{}: curve {}: ", source, records.size()))));
  return records;
}

Curve curve_of(const CurveRecord& record, const CurveDefaults& defaults) {
  const bool closed = record.closed.value_or(defaults.closed);
  const auto count = static_cast<int>(record.segments.size());
  std::vector<Joint> joints;
  if (record.joints)
    joints = *record.joints;
  else
    for (int i = 0; i + (closed ? 0 : 1) < count; ++i) joints.push_back({i, defaults.claimed});
  std::vector<Node> nodes = record.nodes ? *record.nodes : find_nodes(record.segments, closed, defaults.points);
  return {record.segments, std::move(joints), std::move(nodes), closed};
}

}  // namespace kappabench
