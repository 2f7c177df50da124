#include "experiments/program/open_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace kappabench {

namespace {

std::string id_for(const std::string& file) {
  std::string id = file == "-" ? "standard-input" : std::filesystem::path(file).filename().string();
  std::ranges::replace_if(
      id, [](char c) { return c == ':' || c == ',' || c == '=' || (c >= 0 && c <= ' '); }, '_');
  return id;
}

}  // namespace

std::vector<std::shared_ptr<const GivenCurves>> open_curves(const std::vector<std::string>& files,
                                                            const Registry& taken) {
  std::set<std::string> ids;
  for (const SchemeInfo& info : taken.list()) ids.insert(info.id);
  std::vector<std::shared_ptr<const GivenCurves>> opened;
  opened.reserve(files.size());
  for (const std::string& file : files) {
    const std::string name = id_for(file);
    std::string id = name;
    for (int i = 2; !ids.insert(id).second; ++i) id = fmt::format("{}-{}", name, i);
    opened.push_back(std::make_shared<const GivenCurves>(id, read_curve_file(file)));
  }
  return opened;
}

}  // namespace kappabench
