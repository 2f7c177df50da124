#include "datasets/curves/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <utility>

#include "datasets/curves/path_data.hpp"
#include "datasets/curves/shapes.hpp"

namespace kappabench {

namespace {

/// The text that was parsed: pugixml keeps names and values where they stood in it, which tells their lines.
class Source {
 public:
  Source(std::string_view text, std::string_view file) : file_(file), text_(text) {
    for (std::size_t end = text.find('\n'); end != text.npos; end = text.find('\n', end + 1)) line_ends_.push_back(end);
  }

  [[nodiscard]] pugi::xml_parse_result parse_into(pugi::xml_document& document) {
    // Line breaks in attributes stay: path data have many. Entities of a document's own are never replaced.
    constexpr unsigned options = pugi::parse_default & ~pugi::parse_wconv_attribute;
    return document.load_buffer_inplace(text_.data(), text_.size(), options, pugi::encoding_utf8);
  }
  [[nodiscard]] Place place_at(std::ptrdiff_t offset) const {
    const auto before =
        std::ranges::lower_bound(line_ends_, static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
    return {std::string(file_), 1 + static_cast<std::size_t>(before - line_ends_.begin())};
  }
  [[nodiscard]] Place place_of(const pugi::xml_node& node) const { return place_at(node.offset_debug()); }
  [[nodiscard]] Place place_of(const pugi::xml_attribute& attribute) const {
    return attribute ? place_at(attribute.value() - text_.data()) : Place{std::string(file_)};
  }

 private:
  std::string_view file_;
  std::string text_;  ///< as the parser leaves it
  std::vector<std::size_t> line_ends_{};
};

/// "path" of "path" and of "svg:path". Other prefixes are other languages' (sodipodi:namedview) and kept.
std::string_view kind_of(const pugi::xml_node& node) {
  std::string_view name = node.name();
  if (name.starts_with("svg:")) name.remove_prefix(4);
  return name;
}

bool is_hidden(const pugi::xml_node& node) {
  if (trimmed(node.attribute("display").value()) == "none") return true;
  for (const std::string_view declaration : split(node.attribute("style").value(), ';')) {
    const std::size_t colon = declaration.find(':');
    if (colon != declaration.npos && trimmed(declaration.substr(0, colon)) == "display" &&
        trimmed(declaration.substr(colon + 1)) == "none")
      return true;
  }
  return false;
}

struct Unit {
  std::string_view name;
  double pixels;
};
/// CSS: 96 px are an inch.
constexpr std::array<Unit, 7> units{{{"px", 1.0},
                                     {"in", 96.0},
                                     {"cm", 96.0 / 2.54},
                                     {"mm", 9.6 / 2.54},
                                     {"Q", 2.4 / 2.54},
                                     {"pt", 96.0 / 72.0},
                                     {"pc", 16.0}}};

/// Draws one document.
class Drawer {
 public:
  explicit Drawer(const Source& source) : source_(&source) {}

  void draw(const pugi::xml_node& root) {
    collect_ids(root);
    // y points down in SVG and up here.
    AffineMap mirrored = AffineMap::Identity();
    mirrored.linear()(1, 1) = -1.0;
    draw(root, mirrored, {});
  }
  [[nodiscard]] std::vector<Outline> outlines() && { return std::move(outlines_); }

 private:
  /// How deep in the document we are, and in how many uses of other parts of it.
  struct Depth {
    int elements = 0, uses = 0;
  };

  void collect_ids(const pugi::xml_node& root) {
    for (pugi::xml_node node = root; node;) {
      if (const pugi::xml_attribute id = node.attribute("id")) ids_.try_emplace(id.value(), node);
      if (node.first_child()) {
        node = node.first_child();
        continue;
      }
      while (node && node != root && !node.next_sibling()) node = node.parent();
      node = node == root ? pugi::xml_node() : node.next_sibling();
    }
  }

  void draw(const pugi::xml_node& node, const AffineMap& around, Depth depth) {
    constexpr int deepest = 256, most_elements = 1'000'000;
    if (node.type() != pugi::node_element || is_hidden(node)) return;
    if (++depth.elements > deepest)
      refuse(source_->place_of(node), fmt::format("elements more than {} deep", deepest), "ungroup the drawing");
    if (++elements_ > most_elements)
      refuse(source_->place_of(node), fmt::format("more than {} elements are drawn", most_elements),
             "measure a part of the drawing");
    const AffineMap map = around * transform_of(node);
    if (map.linear().determinant() == 0.0) return;  // the standard: it is not rendered
    const std::string_view kind = kind_of(node);
    if (kind == "svg" || kind == "g" || kind == "a" || kind == "switch") return draw_children(node, map, depth);
    if (kind == "use") return draw_use(node, map, depth);
    draw_shape(kind, node, map);
  }

  void draw_children(const pugi::xml_node& node, AffineMap map, Depth depth) {
    const bool inner = kind_of(node) == "symbol" || (kind_of(node) == "svg" && depth.elements > 1);
    if (inner && node.attribute("viewBox"))
      refuse(source_->place_of(node), fmt::format("a {} with a viewBox inside of the drawing", kind_of(node)),
             "it is not read; replace it by a group");
    if (inner) map.translate(point(node, "x", "y"));
    for (const pugi::xml_node& child : node.children()) draw(child, map, depth);
  }

  void draw_use(const pugi::xml_node& node, AffineMap map, Depth depth) {
    constexpr int deepest = 16;
    pugi::xml_attribute href = node.attribute("href");
    if (!href) href = node.attribute("xlink:href");
    const std::string_view target = href.value();
    const Place place = source_->place_of(node);
    if (!target.starts_with('#'))
      refuse(place, fmt::format("use of {}", in_quotes(target)), "a use names a part of the same file, href=\"#id\"");
    const auto found = ids_.find(target.substr(1));
    if (found == ids_.end())
      refuse(place, fmt::format("use of {}, which is not there", in_quotes(target)), "name an id of the file");
    if (++depth.uses > deepest)
      refuse(place, fmt::format("uses within uses more than {} deep", deepest),
             "a part of a drawing must not use itself");
    map.translate(point(node, "x", "y"));
    if (kind_of(found->second) != "symbol") return draw(found->second, map, depth);
    ++depth.elements;
    draw_children(found->second, map * transform_of(found->second), depth);
  }

  void draw_shape(std::string_view kind, const pugi::xml_node& node, const AffineMap& map) {
    Pen pen(map, source_->place_of(node));
    if (kind == "path") {
      const pugi::xml_attribute data = node.attribute("d");
      draw_path(data.value(), source_->place_of(data), pen);
    } else if (kind == "polyline" || kind == "polygon") {
      const pugi::xml_attribute points = node.attribute("points");
      draw_points(points.value(), source_->place_of(points), pen);
      if (kind == "polygon") pen.close();
    } else if (kind == "line") {
      pen.move_to(point(node, "x1", "y1"));
      pen.line_to(point(node, "x2", "y2"));
    } else if (kind == "circle") {
      const double r = length(node, "r");
      draw_ellipse(point(node, "cx", "cy"), {r, r}, pen);
    } else if (kind == "ellipse") {
      draw_ellipse(point(node, "cx", "cy"), radii_of(node), pen);
    } else if (kind == "rect") {
      draw_rectangle(point(node, "x", "y"), point(node, "width", "height"), radii_of(node), pen);
    }
    std::vector<Outline> drawn = std::move(pen).outlines();
    for (Outline& outline : drawn) {
      segments_ += outline.segments.size();
      outlines_.push_back(std::move(outline));
    }
    if (segments_ > most_segments)
      refuse(source_->place_of(node), fmt::format("more than {} segments", most_segments),
             "measure a part of the drawing");
  }

  [[nodiscard]] AffineMap transform_of(const pugi::xml_node& node) const {
    const pugi::xml_attribute transform = node.attribute("transform");
    return transform ? parse_transform(transform.value(), source_->place_of(transform)) : AffineMap::Identity();
  }

  [[nodiscard]] double length(const pugi::xml_node& node, const char* name) const {
    const pugi::xml_attribute attribute = node.attribute(name);
    const std::string_view text = trimmed(attribute.value());
    if (text.empty()) return 0.0;
    const Place place = source_->place_of(attribute);
    const auto unit = std::ranges::find_if(units, [text](const Unit& u) { return text.ends_with(u.name); });
    if (unit == units.end() && (text.back() < '0' || text.back() > '9') && text.back() != '.')
      refuse(place, fmt::format("{} = {}", name, in_quotes(text)),
             "give a number, or one with px, in, cm, mm, Q, pt or pc");
    if (unit == units.end()) return parse_number(text, name, place);
    return unit->pixels * parse_number(text.substr(0, text.size() - unit->name.size()), name, place);
  }
  [[nodiscard]] Vec2 point(const pugi::xml_node& node, const char* x, const char* y) const {
    return {length(node, x), length(node, y)};
  }
  /// What one of them says holds for the other one, if that says nothing.
  [[nodiscard]] Vec2 radii_of(const pugi::xml_node& node) const {
    const auto said = [&](const char* name) {
      const std::string_view text = trimmed(node.attribute(name).value());
      return !text.empty() && text != "auto";
    };
    if (!said("rx") && !said("ry")) return Vec2::Zero();
    return {length(node, said("rx") ? "rx" : "ry"), length(node, said("ry") ? "ry" : "rx")};
  }

  const Source* source_;
  std::map<std::string, pugi::xml_node, std::less<>> ids_{};
  std::vector<Outline> outlines_{};
  std::size_t segments_ = 0;
  int elements_ = 0;
};

}  // namespace

std::vector<Outline> read_svg(std::string_view text, std::string_view file) {
  Source source(text, file);
  pugi::xml_document document;
  if (const pugi::xml_parse_result parsed = source.parse_into(document); !parsed)
    refuse(source.place_at(parsed.offset), fmt::format("not XML: {}", parsed.description()),
           "SVG is well-formed XML in UTF-8");
  const pugi::xml_node root = document.document_element();
  if (kind_of(root) != "svg")
    refuse(source.place_of(root), fmt::format("the outermost element is {}", in_quotes(root.name())),
           "of an SVG document it is svg");
  Drawer drawer(source);
  drawer.draw(root);
  std::vector<Outline> outlines = std::move(drawer).outlines();
  if (outlines.empty())
    refuse({std::string(file)}, "nothing is drawn", "curves are path, line, polyline, polygon, rect, circle, ellipse");
  return outlines;
}

}  // namespace kappabench
