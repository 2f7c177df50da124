#include "schemes/plugin/protocol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "schemes/api/read_curve_json.hpp"
#include "schemes/plugin/one_line.hpp"

namespace kappabench {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_counters = 64, longest_counter = 64;

/// What was said of the point, by the names and in the units of files.
Json json_of(const PointOptions& options) {
  Json object = Json::object();
  if (options.type) object["type"] = name(*options.type);
  for (const PointNumber& number : point_numbers)
    if (const std::optional<double>& value = options.*number.member)
      object[std::string(number.name)] = *value / number.file_unit;
  return object;
}

bool is_word(std::string_view text) {
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !text.empty() && text.size() <= longest_counter && text.find_first_not_of(allowed) == std::string_view::npos;
}

/// What a program says of its own fit. What only others can know of it is not its to say.
Report checked(Report report) {
  const auto refuse = [](const std::string& what) { throw std::invalid_argument(what); };
  if (report.outcome == Outcome::timed_out || report.outcome == Outcome::crashed)
    refuse(fmt::format("outcome '{}'; a program says converged, not_converged, unsupported_input or failed",
                       name(report.outcome)));
  if (report.counters.size() > most_counters)
    refuse(fmt::format("{} counters; at most {} are kept", report.counters.size(), most_counters));
  for (const auto& [counter, value] : report.counters)
    if (!is_word(counter))
      refuse(fmt::format("counter '{}'; letters, digits, _ and -, at most {}", one_line(counter, 80), longest_counter));
  if (report.iterations < 0) refuse(fmt::format("iterations: {}; an integer from 0 up", report.iterations));
  if (!std::isfinite(report.seconds) || report.seconds < 0.0)
    refuse(fmt::format("seconds: {}; a finite number from 0 up", report.seconds));
  report.message = one_line(report.message);
  report.warnings.clear();  // the framework finds them
  report.trace.clear();
  return report;
}

}  // namespace

std::string question_of(const Input& input, const Parameters& parameters) {
  Json points = Json::array(), options = Json::array(), values = Json::object();
  for (int i = 0; i < input.size(); ++i) {
    const Vec2& p = input.points[static_cast<std::size_t>(i)];
    points.push_back({p.x(), p.y()});
    options.push_back(json_of(input.options_of(i)));
  }
  for (const auto& entry : parameters.values())
    std::visit([&](const auto& value) { values[entry.first] = value; }, entry.second);
  const Json question{{"format", "kappabench-input"}, {"version", 1},       {"points", points},
                      {"closed", input.closed},       {"options", options}, {"parameters", values}};
  return question.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Fit fit_of_answer(std::string_view line, const Input& input, const SchemeInfo& info) {
  const std::string source = fmt::format("{}: answer", info.plugin);
  std::vector<CurveRecord> records = read_curves(line, source);
  if (records.size() != 1)
    throw std::invalid_argument(fmt::format("{}: {} curves; one is asked", source, records.size()));
  CurveRecord& record = records.front();
  try {
    Fit fit{.input = input, .curve = std::nullopt, .report = checked(std::move(record.report))};
    const Outcome outcome = fit.report.outcome;
    if (outcome == Outcome::converged && record.segments.empty())
      throw std::invalid_argument("converged, but no segments; without a curve the outcome is failed");
    if ((outcome == Outcome::converged || outcome == Outcome::not_converged) && !record.segments.empty())
      fit.curve = curve_of(record, {.closed = input.closed, .points = input.points, .claimed = info.traits.continuity});
    return fit;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", source, error.what()));
  }
}

}  // namespace kappabench
