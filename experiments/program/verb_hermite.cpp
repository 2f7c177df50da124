#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

#include "datasets/text.hpp"
#include "experiments/program/errors.hpp"
#include "experiments/program/in_child.hpp"
#include "experiments/program/verbs.hpp"
#include "experiments/program/write_fits.hpp"

namespace kappabench {

namespace {

/// Radians in (-pi, pi], so that equal directions are equal numbers. Whole turns are taken off while that is exact.
double heading(double degrees) {
  const double least = std::remainder(degrees, 360.0);
  return (least == -180.0 ? 180.0 : least) * std::numbers::pi / 180.0;
}

/// One end as the user writes it, "x,y,DEG" or "x,y,DEG,kappa", added to `input`. Throws DataError.
void add_end(Input& input, std::string_view option, std::string_view text) {
  const Place place{.file = fmt::format("{} {}", option, in_quotes(text))};
  const std::vector<std::string_view> fields = split(text, ',');
  if (fields.size() != 3 && fields.size() != 4)
    refuse(place, fmt::format("{} number{}", fields.size(), fields.size() == 1 ? "" : "s"),
           "write x,y,DEG or x,y,DEG,kappa: a point, the direction there in degrees, and its curvature");
  const auto number = [&](std::size_t i, std::string_view what) {
    return parse_number(trimmed(fields[i]), what, place);
  };
  input.points.emplace_back(number(0, "x"), number(1, "y"));
  PointOptions options{.tangent = heading(number(2, "DEG"))};
  if (fields.size() == 4) options.curvature = number(3, "kappa");
  input.options.push_back(options);
}

SchemePtr hermite_scheme(const Registry& registry, const std::string& text) {
  SchemePtr scheme = registry.parse(text);
  if (scheme->info().traits.hermite) return scheme;
  std::vector<std::string> able;
  for (const SchemeInfo& info : registry.list())
    if (info.traits.hermite) able.push_back(info.id);
  throw UsageError(fmt::format("scheme '{}' does not take two points with tangents; those that do are {}",
                               scheme->info().id, fmt::join(able, ", ")));
}

}  // namespace

int hermite(const Registry& registry, const HermiteArguments& arguments) {
  const SchemePtr scheme = hermite_scheme(registry, arguments.scheme);
  Input input;
  add_end(input, "--from", arguments.from);
  add_end(input, "--to", arguments.to);
  const std::string ends = fmt::format("from {} to {}", arguments.from, arguments.to);
  if (mean_chord(input) == 0.0) throw UsageError(ends + ": the points coincide; give two different ones");
  const auto fit_it = [&] {
    return static_cast<int>(write_fits(arguments.output, arguments.format, *scheme, {scheme->fit(input)}, ends));
  };
  return scheme->info().plugin.empty() ? fit_it()
                                       : in_child(fmt::format("{}: scheme {}", ends, scheme->info().id), fit_it);
}

}  // namespace kappabench
