#include <fmt/format.h>
#include <toml++/toml.h>

#include <cmath>

#include "datasets/fields.hpp"
#include "datasets/readers.hpp"

namespace kappabench {
namespace {

constexpr std::string_view point_form = "a point is [x, y] or {x = .., y = .., key = ..}";

/// Reads a parsed TOML tree; every message carries the line of the node that it is about.
class TomlReader {
 public:
  explicit TomlReader(std::string_view file) : file_(file) {}

  [[nodiscard]] Drawing read(const toml::table& root) const {
    Drawing drawing;
    for (const auto& [key, node] : root) {
      if (key.str() == "curve") {
        for (const toml::node& curve : array(node, "curve", "write [[curve]] before each curve")) {
          drawing.curves.push_back(read_curve(curve));
        }
      } else if (find_metadata(key.str()) != nullptr) {
        set_metadata(drawing, key.str(), text(node, key.str()), place(node));
      } else {
        refuse(place(node), fmt::format("unknown key {}", in_quotes(key.str())),
               "known are title, stands-in-for, source, licence, units, curve");
      }
    }
    if (drawing.curves.empty()) refuse({file_, 0}, "no curves", "write [[curve]] and points = [[x, y], ..]");
    return drawing;
  }

 private:
  [[nodiscard]] Place place(const toml::node& node) const { return {file_, node.source().begin.line}; }

  [[nodiscard]] const toml::array& array(const toml::node& node, std::string_view what,
                                         std::string_view instead) const {
    if (!node.is_array()) refuse(place(node), fmt::format("{} is not an array", what), instead);
    return *node.as_array();
  }

  [[nodiscard]] std::string text(const toml::node& node, std::string_view what) const {
    const auto* value = node.as_string();
    if (value == nullptr) refuse(place(node), fmt::format("{} is not a text", what), "put it in quotation marks");
    if (value->get().find_first_of("\r\n") != std::string::npos) {
      refuse(place(node), fmt::format("{} has several lines", what), "write it on one line");
    }
    return value->get();
  }

  [[nodiscard]] double number(const toml::node& node, std::string_view what) const {
    double value = std::nan("");
    if (const auto* integer = node.as_integer()) value = static_cast<double>(integer->get());
    if (const auto* real = node.as_floating_point()) value = real->get();
    if (!std::isfinite(value)) refuse(place(node), fmt::format("{} is not a finite number", what), point_form);
    return value;
  }

  [[nodiscard]] Input read_curve(const toml::node& node) const {
    if (!node.is_table()) refuse(place(node), "curve is not a table", "write [[curve]] before each curve");
    Input curve;
    for (const auto& [key, value] : *node.as_table()) {
      if (key.str() == "closed") {
        if (!value.is_boolean()) refuse(place(value), "closed is not a boolean", "give true or false");
        curve.closed = value.as_boolean()->get();
      } else if (key.str() == "points") {
        for (const toml::node& point : array(value, "points", "give points = [[x, y], ..]")) read_point(curve, point);
      } else {
        refuse(place(value), fmt::format("unknown key {} of a curve", in_quotes(key.str())),
               "known are closed, points");
      }
    }
    if (curve.points.empty()) refuse(place(node), "a curve without points", "give points = [[x, y], ..]");
    drop_unsaid_options(curve);
    return curve;
  }

  void read_point(Input& curve, const toml::node& node) const {
    PointOptions options;
    if (const toml::array* pair = node.as_array()) {
      if (pair->size() != 2) refuse(place(node), fmt::format("a point of {} numbers", pair->size()), point_form);
      curve.points.emplace_back(number((*pair)[0], "x"), number((*pair)[1], "y"));
    } else if (const toml::table* table = node.as_table()) {
      if (!table->contains("x") || !table->contains("y")) refuse(place(node), "a point without x or y", point_form);
      curve.points.emplace_back(number(*table->get("x"), "x"), number(*table->get("y"), "y"));
      options = read_options(*table);
    } else {
      refuse(place(node), "this is not a point", point_form);
    }
    curve.options.push_back(options);
  }

  [[nodiscard]] PointOptions read_options(const toml::table& table) const {
    PointOptions options;
    for (const auto& [key, node] : table) {
      if (key.str() == "x" || key.str() == "y") continue;
      if (key.str() == "type") {
        options.type = parse_type(text(node, "type"), place(node));
      } else if (const PointNumber* known = find_number_key(key.str())) {
        options.*(known->member) = number(node, known->name) * known->file_unit;
      } else {
        refuse(place(node), fmt::format("unknown key {} of a point", in_quotes(key.str())),
               fmt::format("known are x, y, {}", point_keys_text()));
      }
    }
    return options;
  }

  std::string file_;
};

}  // namespace

Drawing parse_toml(std::string_view text, std::string_view file) {
  try {
    return TomlReader(file).read(toml::parse(text));
  } catch (const toml::parse_error& error) {
    refuse({std::string(file), error.source().begin.line}, fmt::format("no TOML: {}", error.description()),
           "see https://toml.io for the format");
  }
}

}  // namespace kappabench
