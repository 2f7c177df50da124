#include "datasets/curves/curve_file.hpp"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <string_view>
#include <utility>

#include "datasets/curves/svg.hpp"
#include "datasets/text.hpp"

namespace kappabench {

namespace {

std::vector<CurveRecord> curves_of_svg(std::string_view text, std::string_view name) {
  std::vector<CurveRecord> records;
  for (Outline& outline : read_svg(text, name)) {
    CurveRecord& record = records.emplace_back();
    record.segments = std::move(outline.segments);
    if (outline.closed) record.closed = true;
  }
  return records;
}

std::vector<CurveRecord> curves_of(std::string_view text, std::string_view name) {
  const std::string_view start = text.substr(text.find_first_not_of(" \t\r\n\v\f"), 1);
  if (start == "<") return curves_of_svg(text, name);
  if (start == "{" || start == "[") return read_curves(text, name);
  refuse({std::string(name), 1}, "neither curve JSON nor SVG", "these start with {, [ or <");
}

}  // namespace

CurveFile read_curve_file(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  const boost::uuids::name_generator_sha1 digest(boost::uuids::ns::oid());
  return {file, to_string(digest(text)), curves_of(text, name_for_messages(file))};
}

}  // namespace kappabench
