#include "datasets/glyph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

#include "datasets/font_files.hpp"
#include "datasets/freetype.hpp"

namespace kappabench {
namespace {

struct GlyphName {
  std::string_view font;
  char32_t character;
};

char32_t parse_character(std::string_view text, const Place& place) {
  constexpr std::string_view instead = "give one UTF-8 character or U+XXXX";
  std::uint32_t code = 0;
  if (text.starts_with("U+") && text.size() > 2) {
    const auto [end, error] = std::from_chars(text.data() + 2, text.data() + text.size(), code, 16);
    if (error == std::errc{} && end == text.data() + text.size() && code > 0 && code <= 0x10FFFF) return code;
    refuse(place, fmt::format("{} is no character", in_quotes(text)), instead);
  }
  std::string_view rest = text;
  const auto character = take_utf8(rest);
  if (!character || !rest.empty()) refuse(place, fmt::format("{} is no single character", in_quotes(text)), instead);
  return *character;
}

/// The character stands after the last colon, unless it is a colon itself.
GlyphName parse_name(std::string_view name, const Place& place) {
  constexpr std::string_view prefix = "glyph:";
  const std::string_view rest = name.substr(std::min(prefix.size(), name.size()));
  const std::size_t colon = rest.ends_with("::") ? rest.size() - 2 : rest.rfind(':');
  if (!name.starts_with(prefix) || colon == rest.npos || colon == 0 || colon + 1 == rest.size()) {
    refuse(place, "this names no glyph", "write glyph:FONT:CHAR");
  }
  return {rest.substr(0, colon), parse_character(rest.substr(colon + 1), place)};
}

/// Parameters in (0, 1) where a + b t + c t^2 = 0, ascending.
std::vector<double> roots(double a, double b, double c) {
  std::vector<double> all;
  if (const double discriminant = b * b - 4.0 * a * c; c == 0.0) {
    if (b != 0.0) all = {-a / b};
  } else if (discriminant > 0.0) {
    // Vieta for the smaller root: no cancellation when c is small against b.
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    all = {q / c};
    if (q != 0.0) all.push_back(a / q);
  }
  std::erase_if(all, [](double t) { return !(t > 0.0 && t < 1.0); });
  std::ranges::sort(all);
  return all;
}

/// Parameters of the inner points of a Bezier curve of degree 1 to 3 that are extreme in x or y.
std::vector<double> extrema(std::span<const Vec2> control) {
  std::vector<double> all;
  for (const int axis : {0, 1}) {
    const auto leg = [&](std::size_t i) { return control[i + 1][axis] - control[i][axis]; };
    std::vector<double> found;
    if (control.size() == 3) found = roots(leg(0), leg(1) - leg(0), 0.0);
    if (control.size() == 4) found = roots(leg(0), 2.0 * (leg(1) - leg(0)), leg(2) - 2.0 * leg(1) + leg(0));
    all.insert(all.end(), found.begin(), found.end());
  }
  std::ranges::sort(all);
  return all;
}

/// De Casteljau.
Vec2 point_at(std::span<const Vec2> control, double t) {
  std::vector<Vec2> points(control.begin(), control.end());
  for (std::size_t left = points.size() - 1; left > 0; --left) {
    for (std::size_t i = 0; i < left; ++i) points[i] = (1.0 - t) * points[i] + t * points[i + 1];
  }
  return points[0];
}

/// Turns the outline, which FreeType walks, into closed curves.
class OutlineWalk {
 public:
  [[nodiscard]] std::vector<Input> walk(FT_Outline& outline) {
    const FT_Outline_Funcs calls{
        .move_to =
            [](const FT_Vector* to, void* self) {
              static_cast<OutlineWalk*>(self)->begin_contour(vec(to));
              return 0;
            },
        .line_to = [](const FT_Vector* to, void* self) { return static_cast<OutlineWalk*>(self)->add({vec(to)}); },
        .conic_to =
            [](const FT_Vector* c, const FT_Vector* to, void* self) {
              return static_cast<OutlineWalk*>(self)->add({vec(c), vec(to)});
            },
        .cubic_to =
            [](const FT_Vector* c, const FT_Vector* d, const FT_Vector* to, void* self) {
              return static_cast<OutlineWalk*>(self)->add({vec(c), vec(d), vec(to)});
            },
        .shift = 0,
        .delta = 0};
    FT_Outline_Decompose(&outline, &calls, this);
    end_contour();
    return std::move(contours_);
  }

 private:
  static constexpr double least_distance = 0.5;

  static Vec2 vec(const FT_Vector* v) { return {static_cast<double>(v->x), static_cast<double>(v->y)}; }

  void begin_contour(const Vec2& at) {
    end_contour();
    contour_.points = {at};
    at_ = at;
  }

  int add(std::vector<Vec2> control) {
    control.insert(control.begin(), at_);
    for (const double t : extrema(control)) add_point(point_at(control, t));
    add_point(control.back());
    at_ = control.back();
    return 0;
  }

  void add_point(const Vec2& point) {
    if ((point - contour_.points.back()).norm() >= least_distance) contour_.points.push_back(point);
  }

  void end_contour() {
    std::vector<Vec2>& points = contour_.points;
    while (points.size() > 1 && (points.back() - points.front()).norm() < least_distance) points.pop_back();
    contour_.closed = true;
    if (points.size() >= 3) contours_.push_back(contour_);
    contour_ = Input{};
  }

  std::vector<Input> contours_;
  Input contour_;
  Vec2 at_ = Vec2::Zero();
};

std::string font_title(const FontFace& face) {
  const auto text = [](const char* t) { return t != nullptr ? t : "?"; };
  return fmt::format("{} {}", text(face->family_name), text(face->style_name));
}

}  // namespace

Drawing glyph_drawing(std::string_view name) {
  const Place place{std::string(name), 0};
  const GlyphName wanted = parse_name(name, place);
  const std::filesystem::path file = find_font(wanted.font, place);
  const FontLibrary library = open_font_library();
  const FontFace face = library ? open_font(library, file) : nullptr;
  if (!face) refuse(place, fmt::format("{} is no font that FreeType reads", file.string()), "name a font file");
  if (!FT_IS_SCALABLE(face)) refuse(place, "a bitmap font", "name a font with outlines");

  const std::string code = fmt::format("U+{:04X}", static_cast<std::uint32_t>(wanted.character));
  const FT_UInt index = FT_Get_Char_Index(face.get(), wanted.character);
  if (index == 0) refuse(place, fmt::format("{} has no {}", font_title(face), code), "name a character of the font");
  if (FT_Load_Glyph(face.get(), index, FT_LOAD_NO_SCALE) != 0 || face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) {
    refuse(place, fmt::format("{} of {} has no outline", code, font_title(face)), "name another character");
  }
  Drawing drawing{.id = std::string(name),
                  .title = fmt::format("{} of {}", code, font_title(face)),
                  .source = fmt::format("outline in {}", file.filename().string()),
                  .licence = "that of the font",
                  .units = fmt::format("font units, {} per em", face->units_per_EM),
                  .curves = OutlineWalk().walk(face->glyph->outline)};
  if (drawing.curves.empty()) {
    refuse(place, fmt::format("{} of {} is empty", code, font_title(face)), "name a character with an outline");
  }
  return drawing;
}

std::string freetype_version() {
  const FontLibrary library = open_font_library();
  if (!library) return "unknown";
  FT_Int major = 0, minor = 0, patch = 0;
  FT_Library_Version(library.get(), &major, &minor, &patch);
  return fmt::format("{}.{}.{}", major, minor, patch);
}

}  // namespace kappabench
