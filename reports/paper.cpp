#include "reports/paper.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <initializer_list>
#include <iterator>
#include <set>
#include <span>
#include <string_view>
#include <utility>

namespace kappabench {

/// Name and text of each file of paper/; the build writes it (datasets/inside.cmake).
std::span<const std::pair<std::string_view, std::string_view>> papers_inside();

namespace {

using Keys = std::initializer_list<std::string_view>;

/// One file while it is read; knows how to complain.
class PaperFile {
 public:
  explicit PaperFile(std::string name) : name_(std::move(name)) {}

  [[noreturn]] void refuse(const toml::node& node, const std::string& what) const {
    throw PaperError(fmt::format("{}:{}: {}", name_, node.source().begin.line, what));
  }

  void only(const toml::table& table, Keys known) const {
    for (const auto& [key, node] : table) {
      if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
      refuse(node, fmt::format("unknown key '{}' (known: {})", key.str(), fmt::join(known, ", ")));
    }
  }

  [[nodiscard]] std::string word(const toml::table& table, std::string_view key, bool required = true) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
      if (required) refuse(table, fmt::format("'{}' is missing", key));
      return "";
    }
    const auto text = node->value_exact<std::string>();
    if (!text || (required && text->empty())) refuse(*node, fmt::format("'{}' must be a text", key));
    return *text;
  }

  [[nodiscard]] std::vector<std::string> words(const toml::node* node, const toml::table& parent,
                                               std::string_view key) const {
    const toml::array* array = node == nullptr ? nullptr : node->as_array();
    if (array == nullptr) refuse(node == nullptr ? parent : *node, fmt::format("'{}' must be a list of texts", key));
    std::vector<std::string> result;
    for (const auto& item : *array) {
      const auto text = item.value_exact<std::string>();
      if (!text) refuse(item, fmt::format("'{}' holds texts only, so that the printed digits stay: quote it", key));
      result.push_back(*text);
    }
    return result;
  }

  /// The tables under [[key]].
  [[nodiscard]] std::vector<const toml::table*> tables(const toml::table& root, std::string_view key) const {
    std::vector<const toml::table*> result;
    const toml::node* node = root.get(key);
    if (node == nullptr) return result;
    const toml::array* array = node->as_array();
    if (array == nullptr) refuse(*node, fmt::format("write [[{}]]", key));
    for (const auto& item : *array) {
      if (!item.is_table()) refuse(item, fmt::format("write [[{}]]", key));
      result.push_back(item.as_table());
    }
    return result;
  }

 private:
  std::string name_;
};

constexpr std::array<std::pair<StatementKind, std::string_view>, 6> kinds{{{StatementKind::always, "always"},
                                                                           {StatementKind::in_general, "in general"},
                                                                           {StatementKind::often, "often"},
                                                                           {StatementKind::may, "may"},
                                                                           {StatementKind::growth, "growth"},
                                                                           {StatementKind::number, "number"}}};

StatementKind read_kind(const PaperFile& file, const toml::table& entry) {
  const std::string word = file.word(entry, "kind");
  const auto found = std::ranges::find(kinds, word, &decltype(kinds)::value_type::second);
  if (found != kinds.end()) return found->first;
  std::vector<std::string_view> known;
  std::ranges::transform(kinds, std::back_inserter(known), &decltype(kinds)::value_type::second);
  file.refuse(entry, fmt::format("kind '{}' is none of {}", word, fmt::join(known, ", ")));
}

/// A bound of `at_least`, `at_most`; both are for kinds that have a number.
void read_bound(const PaperFile& file, const toml::table& entry, std::string_view key, StatementKind kind,
                double& bound) {
  const toml::node* node = entry.get(key);
  if (node == nullptr) return;
  if (kind != StatementKind::growth && kind != StatementKind::number)
    file.refuse(*node, fmt::format("'{}' is for the kinds growth and number", key));
  const auto value = node->value<double>();
  if (!value) file.refuse(*node, fmt::format("'{}' must be a number", key));
  bound = *value;
}

PrintedClaim read_claim(const PaperFile& file, const toml::table& entry) {
  file.only(entry, {"id", "place", "text", "printed", "kind", "at_least", "at_most"});
  PrintedClaim claim{file.word(entry, "id"), file.word(entry, "place"), file.word(entry, "text"),
                     file.word(entry, "printed", false), read_kind(file, entry)};
  read_bound(file, entry, "at_least", claim.kind, claim.at_least);
  read_bound(file, entry, "at_most", claim.kind, claim.at_most);
  return claim;
}

PrintedTable read_printed_table(const PaperFile& file, const toml::table& entry) {
  file.only(entry, {"id", "place", "title", "columns", "rows"});
  PrintedTable table{file.word(entry, "id"),
                     file.word(entry, "place"),
                     file.word(entry, "title"),
                     file.words(entry.get("columns"), entry, "columns"),
                     {}};
  const toml::node* rows = entry.get("rows");
  if (rows == nullptr || !rows->is_array()) file.refuse(entry, "'rows' must be a list of lists");
  for (const auto& row : *rows->as_array()) {
    table.rows.push_back(file.words(&row, entry, "rows"));
    if (table.rows.back().size() != table.columns.size()) {
      file.refuse(row, fmt::format("{} entries for {} columns", table.rows.back().size(), table.columns.size()));
    }
  }
  return table;
}

}  // namespace

std::string_view name(StatementKind kind) {
  const auto found = std::ranges::find(kinds, kind, &decltype(kinds)::value_type::first);
  if (found == kinds.end()) throw std::logic_error("name(StatementKind): not a value of the enumeration");
  return found->second;
}

Paper parse_paper(std::string_view text, const std::string& name) {
  toml::table root;
  try {
    root = toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    throw PaperError(fmt::format("{}:{}: {}", name, error.source().begin.line, error.description()));
  }
  const PaperFile file(name);
  file.only(root, {"paper", "claim", "table"});
  const toml::table* head = root["paper"].as_table();
  if (head == nullptr) file.refuse(root, "[paper] is missing");
  file.only(*head, {"title", "citation"});
  Paper paper{
      std::filesystem::path(name).stem().string(), file.word(*head, "title"), file.word(*head, "citation"), {}, {}};
  std::set<std::string> ids;
  for (const auto* entry : file.tables(root, "claim")) {
    paper.claims.push_back(read_claim(file, *entry));
    if (!ids.insert(paper.claims.back().id).second) file.refuse(*entry, "id used twice: " + paper.claims.back().id);
  }
  for (const auto* entry : file.tables(root, "table")) {
    paper.tables.push_back(read_printed_table(file, *entry));
    if (!ids.insert(paper.tables.back().id).second) file.refuse(*entry, "id used twice: " + paper.tables.back().id);
  }
  return paper;
}

const std::vector<Paper>& printed_papers() {
  static const std::vector<Paper> papers = [] {
    std::vector<Paper> all;
    for (const auto& [file, text] : papers_inside()) all.push_back(parse_paper(text, std::string(file)));
    std::ranges::sort(all, {}, &Paper::id);
    return all;
  }();
  return papers;
}

const Paper& printed_paper(std::string_view id) {
  const std::vector<Paper>& papers = printed_papers();
  const auto found = std::ranges::find(papers, id, &Paper::id);
  if (found == papers.end()) throw PaperError(fmt::format("reports/paper/{}.toml: there is no such file", id));
  return *found;
}

const PrintedClaim& printed_claim(std::string_view paper, std::string_view id) {
  const std::vector<PrintedClaim>& claims = printed_paper(paper).claims;
  const auto found = std::ranges::find(claims, id, &PrintedClaim::id);
  if (found == claims.end()) throw PaperError(fmt::format("reports/paper/{}.toml has no claim '{}'", paper, id));
  return *found;
}

}  // namespace kappabench
