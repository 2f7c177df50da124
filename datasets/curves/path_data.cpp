#include "datasets/curves/path_data.hpp"

#include <fmt/format.h>

#include <cctype>
#include <string>

#include "datasets/curves/scanner.hpp"

namespace kappabench {

namespace {

constexpr std::string_view commands = "MmLlHhVvCcSsQqTtAaZz";

class PathReader {
 public:
  PathReader(std::string_view data, const Place& place, Pen& pen) : scanner_(data, place), pen_(&pen) {}

  void read() {
    while (!scanner_.done()) {
      const char command = next_command();
      relative_ = std::islower(static_cast<unsigned char>(command)) != 0;
      draw(static_cast<char>(std::toupper(static_cast<unsigned char>(command))));
      command_ = command;
    }
  }

 private:
  /// Numbers without a command repeat the one before; a move goes on as lines.
  char next_command() {
    if (scanner_.at_number() && command_ != '\0' && command_ != 'Z' && command_ != 'z')
      return command_ == 'M' ? 'L' : command_ == 'm' ? 'l' : command_;
    const char command = scanner_.peek();
    if (commands.find(command) == commands.npos)
      refuse(scanner_.place(), fmt::format("{} where a command is needed", scanner_.next()),
             "path data have M, L, H, V, C, S, Q, T, A, Z, or these in lower case");
    if (command_ == '\0' && command != 'M' && command != 'm')
      refuse(scanner_.place(), fmt::format("path data start with {}", scanner_.next()), "they start with M or m");
    (void)scanner_.take(command);
    (void)scanner_.done();
    return command;
  }

  [[nodiscard]] double number(std::string_view what) {
    const double value = scanner_.number(what);
    scanner_.skip_separator();
    return value;
  }
  [[nodiscard]] bool flag(std::string_view what) {
    const bool value = scanner_.flag(what);
    scanner_.skip_separator();
    return value;
  }
  [[nodiscard]] Vec2 origin() const { return relative_ ? pen_->at() : Vec2(Vec2::Zero()); }
  [[nodiscard]] double x() { return origin().x() + number("x"); }
  [[nodiscard]] double y() { return origin().y() + number("y"); }
  [[nodiscard]] Vec2 point() {
    const double first = x();
    return {first, y()};
  }
  [[nodiscard]] ArcArguments arc() {
    ArcArguments arc{};
    arc.radii.x() = number("a radius");
    arc.radii.y() = number("a radius");
    arc.rotation = number("a rotation");
    arc.large = flag("the flag of a large arc");
    arc.sweep = flag("the flag of a sweep");
    return arc;
  }

  /// The last control point of the command before, mirrored in the pen's place, if that command is one of these.
  [[nodiscard]] Vec2 mirrored(std::string_view after) const {
    const bool follows = after.find(command_) != after.npos && command_ != '\0';
    return follows ? Vec2(2.0 * pen_->at() - control_) : pen_->at();
  }
  void cubic_from(const Vec2& first) {
    control_ = point();
    pen_->cubic_to(first, control_, point());
  }
  void quadratic_from(const Vec2& control) {
    control_ = control;
    pen_->quadratic_to(control, point());
  }

  void draw(char command) {
    switch (command) {
      case 'M':
        return pen_->move_to(point());
      case 'L':
        return pen_->line_to(point());
      case 'H':
        return pen_->line_to({x(), pen_->at().y()});
      case 'V':
        return pen_->line_to({pen_->at().x(), y()});
      case 'C':
        return cubic_from(point());
      case 'S':
        return cubic_from(mirrored("CcSs"));
      case 'Q':
        return quadratic_from(point());
      case 'T':
        return quadratic_from(mirrored("QqTt"));
      case 'A': {
        const ArcArguments arguments = arc();
        return pen_->arc_to(arguments, point());
      }
      default:
        return pen_->close();
    }
  }

  Scanner scanner_;
  Pen* pen_;
  char command_ = '\0';
  bool relative_ = false;
  Vec2 control_ = Vec2::Zero();
};

}  // namespace

void draw_path(std::string_view data, const Place& place, Pen& pen) {
  if (trimmed(data) == "none") return;  // CSS's word for it
  PathReader(data, place, pen).read();
}

void draw_points(std::string_view points, const Place& place, Pen& pen) {
  Scanner scanner(points, place);
  for (bool first = true; !scanner.done(); first = false) {
    const double x = scanner.number("x");
    scanner.skip_separator();
    const Vec2 p(x, scanner.number("y"));
    scanner.skip_separator();
    first ? pen.move_to(p) : pen.line_to(p);
  }
}

}  // namespace kappabench
