#include "schemes/curve/curve.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace kappabench {

std::string_view name(Continuity continuity) {
  switch (continuity) {
    case Continuity::g0:
      return "G0";
    case Continuity::g1:
      return "G1";
    case Continuity::g1_equal_magnitude:
      return "G1 |k|";
    case Continuity::g2:
      return "G2";
    case Continuity::c1:
      return "C1";
    case Continuity::c2:
      return "C2";
  }
  throw std::logic_error("name(Continuity): not a value of the enumeration");
}

bool Node::has(std::string_view mark) const { return std::ranges::find(marks, mark) != marks.end(); }

namespace {

bool is_word(const std::string& mark) { return !mark.empty() && mark.find_first_of(" \t\r\n") == std::string::npos; }

void put_in_order(std::vector<std::string>& marks) {
  if (!std::ranges::all_of(marks, is_word))
    throw std::invalid_argument("Curve: a node has a mark that is not one word; write it without blanks");
  std::ranges::sort(marks);
  const auto repeated = std::ranges::unique(marks);
  marks.erase(repeated.begin(), repeated.end());
}

}  // namespace

Curve::Curve(std::vector<SegmentPtr> segments, std::vector<Joint> joints, std::vector<Node> nodes, bool closed)
    : segments_(std::move(segments)), joints_(std::move(joints)), nodes_(std::move(nodes)), closed_(closed) {
  if (segments_.empty()) throw std::invalid_argument("Curve: no segments; at least one is needed");
  const std::size_t expected = closed_ ? segments_.size() : segments_.size() - 1;
  if (joints_.size() != expected) throw std::invalid_argument("Curve: a joint is needed wherever two segments meet");
  const auto exists = [this](int segment) { return segment >= 0 && segment < size(); };
  for (const Joint& joint : joints_)
    if (!exists(joint.segment)) throw std::invalid_argument("Curve: a joint names a segment that does not exist");
  for (Node& node : nodes_) {
    if (!exists(node.segment)) throw std::invalid_argument("Curve: a node names a segment that does not exist");
    put_in_order(node.marks);
  }
}

Curve place(const Curve& curve, const Placement& placement) {
  std::vector<SegmentPtr> segments;
  segments.reserve(curve.segments().size());
  for (const SegmentPtr& segment : curve.segments()) segments.push_back(place(segment, placement));
  return {std::move(segments), curve.joints(), curve.nodes(), curve.closed()};
}

CurveSamples sample(const Curve& curve, int per_segment, int order) {
  if (per_segment < 2) throw std::invalid_argument("sample: at least 2 parameters a segment are needed");
  const auto count = static_cast<std::size_t>(per_segment);
  CurveSamples samples{.t = std::vector<double>(count), .jets = {}, .order = order};
  for (std::size_t j = 0; j < count; ++j) samples.t[j] = static_cast<double>(j) / static_cast<double>(count - 1);
  samples.jets.resize(count * static_cast<std::size_t>(curve.size()));
  std::span<Jet> rest{samples.jets};
  for (const SegmentPtr& segment : curve.segments()) {
    segment->jets(samples.t, order, rest.first(count));
    rest = rest.subspan(count);
  }
  return samples;
}

}  // namespace kappabench
