#include <fmt/format.h>

#include "datasets/fields.hpp"
#include "datasets/readers.hpp"

namespace kappabench {
namespace {

constexpr long most_curves = 1'000'000;
constexpr long most_points = 1'000'000'000;

/// The lines that are not blank, one after the other.
class PtsLines {
 public:
  PtsLines(std::string_view text, std::string_view file) : lines_(lines_of(text)), place_{std::string(file), 0} {}

  /// The next line as words, `expected` of them, for `what`.
  std::vector<std::string_view> next(std::size_t expected, std::string_view what) {
    skip_blank();
    if (at_ == lines_.size()) {
      place_.line = lines_.size();
      refuse(place_, fmt::format("the file ends before {}", what), "the file may be cut off");
    }
    place_.line = lines_[at_].number;
    std::vector<std::string_view> words = words_of(lines_[at_].text);
    if (words.size() != expected) {
      refuse(place_, fmt::format("{} where {} is due", in_quotes(lines_[at_].text), what),
             expected == 1 ? "give one integer" : "give two numbers \"x y\"");
    }
    ++at_;
    return words;
  }

  void expect_end() {
    skip_blank();
    if (at_ == lines_.size()) return;
    place_.line = lines_[at_].number;
    refuse(place_, fmt::format("{} after the last open curve", in_quotes(lines_[at_].text)),
           "the counts say that the file ends here");
  }

  [[nodiscard]] const Place& place() const { return place_; }

 private:
  void skip_blank() {
    while (at_ < lines_.size() && trimmed(lines_[at_].text).empty()) ++at_;
  }

  std::vector<Line> lines_;
  std::size_t at_ = 0;
  Place place_;
};

Input read_curve(PtsLines& lines, bool closed) {
  constexpr std::string_view count_name = "the number of points of a curve";
  const long count = parse_integer(lines.next(1, count_name)[0], count_name, 1, most_points, lines.place());
  Input curve;
  curve.closed = closed;
  for (long i = 0; i < count; ++i) {
    const auto words = lines.next(2, fmt::format("point {} of {}", i + 1, count));
    const double x = parse_number(words[0], "x", lines.place());
    curve.points.emplace_back(x, parse_number(words[1], "y", lines.place()));
  }
  return curve;
}

}  // namespace

Drawing parse_pts(std::string_view text, std::string_view file) {
  PtsLines lines(text, file);
  Drawing drawing;
  for (const bool closed : {true, false}) {
    const std::string_view count_name = closed ? "the number of closed curves" : "the number of open curves";
    const long count = parse_integer(lines.next(1, count_name)[0], count_name, 0, most_curves, lines.place());
    for (long i = 0; i < count; ++i) drawing.curves.push_back(read_curve(lines, closed));
  }
  lines.expect_end();
  if (drawing.curves.empty()) refuse({std::string(file), 0}, "no curves", "at least one curve is needed");
  return drawing;
}

}  // namespace kappabench
