#include <fmt/format.h>

#include <utility>

#include "datasets/fields.hpp"
#include "datasets/readers.hpp"

namespace kappabench {
namespace {

constexpr std::string_view point_form = "a point is a line \"x y [key=value ...]\"";

void read_point(Input& curve, std::string_view line, const Place& place) {
  const std::vector<std::string_view> words = words_of(line);
  const double x = parse_number(words[0], "x", place);
  if (words.size() < 2) refuse(place, "y is missing", point_form);
  const double y = parse_number(words[1], "y", place);
  PointOptions options;
  for (std::size_t i = 2; i < words.size(); ++i) {
    const std::size_t equals = words[i].find('=');
    if (equals == words[i].npos) {
      refuse(place, fmt::format("{} after the coordinates", in_quotes(words[i])), point_form);
    }
    set_option(options, words[i].substr(0, equals), words[i].substr(equals + 1), place);
  }
  curve.points.emplace_back(x, y);
  curve.options.push_back(options);
}

/// Collects curves line by line.
class PlainReader {
 public:
  explicit PlainReader(std::string_view file) : place_{std::string(file), 0} {}

  void read(const Line& line) {
    place_.line = line.number;
    const std::string_view whole = trimmed(line.text);
    const std::string_view content = trimmed(whole.substr(0, whole.find('#')));
    if (whole.empty()) {
      end_curve();
    } else if (content.empty()) {
      if (!begun_) read_metadata_comment(drawing_, whole, place_);
    } else if (content == "open" || content == "closed") {
      begin_curve(content);
    } else {
      begun_ = true;
      read_point(curve_, content, place_);
    }
  }

  [[nodiscard]] Drawing finish() && {
    end_curve();
    place_.line = 0;
    if (drawing_.curves.empty()) refuse(place_, "no points", point_form);
    return std::move(drawing_);
  }

 private:
  void begin_curve(std::string_view word) {
    if (said_ || !curve_.points.empty()) {
      refuse(place_, fmt::format("{} inside a curve", in_quotes(word)),
             "it is the first line of a curve, after a blank one");
    }
    begun_ = said_ = true;
    curve_.closed = word == "closed";
  }

  void end_curve() {
    if (curve_.points.empty()) {
      if (said_) refuse(place_, "a curve without points", point_form);
      return;
    }
    drop_unsaid_options(curve_);
    drawing_.curves.push_back(std::exchange(curve_, Input{}));
    said_ = false;
  }

  Place place_;
  Drawing drawing_;
  Input curve_;
  bool said_ = false;   ///< `open` or `closed` was read for the present curve
  bool begun_ = false;  ///< past the leading comments
};

}  // namespace

Drawing parse_plain(std::string_view text, std::string_view file) {
  PlainReader reader(file);
  for (const Line& line : lines_of(text)) reader.read(line);
  return std::move(reader).finish();
}

}  // namespace kappabench
