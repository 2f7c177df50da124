#include "schemes/api/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "schemes/api/known_words.hpp"

namespace kappabench {

void Registry::add(SchemeInfo info, Factory factory) {
  if (std::ranges::any_of(entries_, [&](const Entry& entry) { return entry.info.id == info.id; }))
    throw std::invalid_argument(fmt::format("scheme '{}' is registered already", info.id));
  entries_.push_back({std::move(info), std::move(factory)});
}

std::vector<SchemeInfo> Registry::list() const {
  std::vector<SchemeInfo> infos;
  for (const Entry& entry : entries_) infos.push_back(entry.info);
  return infos;
}

const Registry::Entry& Registry::find(std::string_view id) const {
  const auto found = std::ranges::find_if(entries_, [id](const Entry& entry) { return entry.info.id == id; });
  if (found != entries_.end()) return *found;
  std::vector<std::string> ids;
  ids.reserve(entries_.size());
  for (const Entry& entry : entries_) ids.push_back(entry.info.id);
  throw std::invalid_argument(fmt::format("unknown scheme '{}'; {}", id, known_words(id, ids)));
}

SchemePtr Registry::create(std::string_view id, const std::map<std::string, ParameterValue>& parameters) const {
  const Entry& entry = find(id);
  return entry.factory(Parameters(entry.info.parameters, parameters));
}

SchemePtr Registry::parse(std::string_view text) const {
  const std::size_t colon = text.find(':');
  const Entry& entry = find(text.substr(0, colon));
  const std::string_view rest = colon == std::string_view::npos ? std::string_view{} : text.substr(colon + 1);
  try {
    return entry.factory(Parameters::parse(entry.info.parameters, rest));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("scheme '{}': {}", entry.info.id, error.what()));
  }
}

}  // namespace kappabench
