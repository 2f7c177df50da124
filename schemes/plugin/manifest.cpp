#include "schemes/plugin/manifest.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>
#include <stdexcept>
#include <utility>

#include "schemes/plugin/digest.hpp"
#include "schemes/plugin/external_scheme.hpp"
#include "schemes/plugin/one_line.hpp"

namespace kappabench {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = std::size_t{1} << 20;
constexpr long most_count = 1'000'000;
constexpr std::size_t longest_name = 64;

constexpr std::string_view lower = "abcdefghijklmnopqrstuvwxyz";
constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr std::string_view digits = "0123456789";

bool is_name(std::string_view text, std::string_view first, std::string_view others) {
  return !text.empty() && text.size() <= longest_name && first.find(text.front()) != std::string_view::npos &&
         text.find_first_not_of(fmt::format("{}{}{}", first, digits, others)) == std::string_view::npos;
}

constexpr std::array<std::pair<std::string_view, bool SchemeTraits::*>, 8> trait_flags{
    {{"open", &SchemeTraits::open},
     {"closed", &SchemeTraits::closed},
     {"similarity_invariant", &SchemeTraits::similarity_invariant},
     {"reversal_invariant", &SchemeTraits::reversal_invariant},
     {"cyclic_shift_invariant", &SchemeTraits::cyclic_shift_invariant},
     {"repeats_allowed", &SchemeTraits::repeats_allowed},
     {"hermite", &SchemeTraits::hermite},
     {"refit_is_fit", &SchemeTraits::refit_is_fit}}};

struct TraitCount {
  std::string_view name;
  int SchemeTraits::*member;
  long least;
};
constexpr std::array<TraitCount, 3> trait_counts{{{"fewest_open_points", &SchemeTraits::fewest_open_points, 2},
                                                  {"fewest_closed_points", &SchemeTraits::fewest_closed_points, 2},
                                                  {"locality", &SchemeTraits::locality, -1}}};

constexpr std::array<Continuity, 6> continuities{Continuity::g0, Continuity::g1, Continuity::g1_equal_magnitude,
                                                 Continuity::g2, Continuity::c1, Continuity::c2};

/// Reads a parsed manifest; every complaint says where.
class Reader {
 public:
  explicit Reader(fs::path file) : file_(std::move(file)) {}

  [[noreturn]] void refuse(const toml::source_region& where, std::string_view what) const {
    throw std::runtime_error(one_line(fmt::format("{}:{}: {}", file_.string(), where.begin.line, what), 1000));
  }

  [[nodiscard]] Manifest manifest(const toml::table& root) const {
    only_keys(root,
              {"id", "title", "citation", "version", "command", "timeout", "files", "parameter", "mark", "traits"});
    Manifest manifest;
    manifest.info.id = text(root, "id");
    if (!is_name(manifest.info.id, lower, "-"))
      refuse(root["id"].node()->source(),
             fmt::format("id: '{}'; lower-case letters, digits and hyphens, a letter first, at most {}",
                         manifest.info.id, longest_name));
    manifest.info.title = text(root, "title");
    manifest.info.citation = text(root, "citation");
    if (root.contains("version")) manifest.info.version = static_cast<int>(count(root, "version", 1));
    if (root.contains("timeout")) manifest.timeout = timeout(root);
    for (const toml::table* parameter : tables(root, "parameter"))
      manifest.info.parameters.push_back(one_parameter(*parameter, manifest.info.parameters));
    for (const toml::table* mark : tables(root, "mark")) {
      only_keys(*mark, {"name", "help"});
      manifest.info.marks.push_back({name(*mark), text(*mark, "help")});
    }
    manifest.info.traits = traits(root);
    manifest.command = {texts(root, "command"), folder()};
    if (manifest.command.words.empty() || manifest.command.words.front().empty())
      refuse(root["command"].node()->source(), R"(command: names no program; write ["python3", "my_spline.py"])");
    manifest.info.plugin = file_.string();
    manifest.info.plugin_digest = digest(root, manifest.command);
    return manifest;
  }

 private:
  [[nodiscard]] fs::path folder() const { return fs::absolute(file_).parent_path(); }

  void only_keys(const toml::table& table, std::initializer_list<std::string_view> known) const {
    for (const auto& [key, node] : table)
      if (std::ranges::find(known, key.str()) == known.end())
        refuse(key.source(), fmt::format("unknown key '{}'; known are {}", key.str(), fmt::join(known, ", ")));
  }

  [[nodiscard]] const toml::node& need(const toml::table& table, std::string_view key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) refuse(table.source(), fmt::format("{} is missing; write {} = {}", key, key, example(key)));
    return *node;
  }

  static std::string_view example(std::string_view key) {
    if (key == "command") return R"(["python3", "my_spline.py"])";
    if (key == "continuity") return "\"G1\"";
    if (key == "default") return "0.5 (a boolean, an integer, a real number or text)";
    return "\"...\"";
  }

  [[nodiscard]] std::string line(const toml::node& node, std::string_view key) const {
    const auto* value = node.as_string();
    if (value == nullptr) refuse(node.source(), fmt::format("{}: not a text; put it in quotation marks", key));
    const std::string& said = value->get();
    if (one_line(said, said.size()) != said)
      refuse(node.source(), fmt::format("{}: one line, without blanks around it and control characters", key));
    return said;
  }

  [[nodiscard]] std::string text(const toml::table& table, std::string_view key) const {
    const toml::node& node = need(table, key);
    std::string said = line(node, key);
    if (said.empty()) refuse(node.source(), fmt::format("{}: empty; say it in a few words", key));
    return said;
  }

  [[nodiscard]] std::vector<std::string> texts(const toml::table& table, std::string_view key) const {
    const toml::node& node = need(table, key);
    if (!node.is_array()) refuse(node.source(), fmt::format("{}: not a list of texts", key));
    std::vector<std::string> result;
    for (const toml::node& item : *node.as_array()) result.push_back(line(item, key));
    return result;
  }

  [[nodiscard]] bool flag(const toml::table& table, std::string_view key) const {
    const toml::node& node = need(table, key);
    if (!node.is_boolean()) refuse(node.source(), fmt::format("{}: neither true nor false", key));
    return node.as_boolean()->get();
  }

  [[nodiscard]] double number(const toml::table& table, std::string_view key) const {
    const toml::node& node = need(table, key);
    const auto value = node.is_boolean() ? std::nullopt : node.value<double>();
    if (!value || !std::isfinite(*value)) refuse(node.source(), fmt::format("{}: not a finite number", key));
    return *value;
  }

  [[nodiscard]] long count(const toml::table& table, std::string_view key, long least) const {
    const toml::node& node = need(table, key);
    if (!node.is_integer() || node.as_integer()->get() < least || node.as_integer()->get() > most_count)
      refuse(node.source(), fmt::format("{}: not an integer from {} to {}", key, least, most_count));
    return node.as_integer()->get();
  }

  /// The tables of [[key]].
  [[nodiscard]] std::vector<const toml::table*> tables(const toml::table& root, std::string_view key) const {
    const toml::node* node = root.get(key);
    if (node == nullptr) return {};
    if (!node->is_array()) refuse(node->source(), fmt::format("{}: not a list; write [[{}]] before each", key, key));
    std::vector<const toml::table*> result;
    for (const toml::node& item : *node->as_array()) {
      if (!item.is_table()) refuse(item.source(), fmt::format("{}: not a table; write [[{}]] before each", key, key));
      result.push_back(item.as_table());
    }
    return result;
  }

  [[nodiscard]] double timeout(const toml::table& root) const {
    const double seconds = number(root, "timeout");
    if (!(seconds > 0.0 && seconds <= 1e6))
      refuse(root["timeout"].node()->source(),
             fmt::format("timeout: {}; a number of seconds above 0, at most 1e6", seconds));
    return seconds;
  }

  [[nodiscard]] std::string name(const toml::table& table) const {
    std::string said = text(table, "name");
    if (!is_name(said, letters, "_"))
      refuse(
          table["name"].node()->source(),
          fmt::format("name: '{}'; letters, digits and underscores, a letter first, at most {}", said, longest_name));
    return said;
  }

  [[nodiscard]] ParameterSpec one_parameter(const toml::table& table, const std::vector<ParameterSpec>& before) const {
    only_keys(table, {"name", "default", "help", "least", "most", "least_included", "most_included", "choices"});
    ParameterSpec spec{.name = name(table), .default_value = default_value(table), .help = text(table, "help")};
    if (std::ranges::find(before, spec.name, &ParameterSpec::name) != before.end())
      refuse(table["name"].node()->source(), fmt::format("name: a second parameter '{}'", spec.name));
    const bool is_text = std::holds_alternative<std::string>(spec.default_value);
    const bool is_number = !is_text && !std::holds_alternative<bool>(spec.default_value);
    for (const auto& [key, node] : table) {
      if ((key.str().starts_with("least") || key.str().starts_with("most")) && !is_number)
        refuse(key.source(), fmt::format("{}: '{}' is no number; leave it out", key.str(), spec.name));
      if (key.str() == "choices" && !is_text)
        refuse(key.source(), fmt::format("choices: '{}' is no text; numbers have least and most", spec.name));
    }
    if (table.contains("least")) spec.least = number(table, "least");
    if (table.contains("most")) spec.most = number(table, "most");
    if (table.contains("least_included")) spec.least_included = flag(table, "least_included");
    if (table.contains("most_included")) spec.most_included = flag(table, "most_included");
    if (table.contains("choices")) spec.choices = choices(table);
    try {
      validate(spec, spec.default_value);
    } catch (const std::invalid_argument& error) {
      refuse(table["default"].node()->source(), fmt::format("default: {}", error.what()));
    }
    return spec;
  }

  [[nodiscard]] ParameterValue default_value(const toml::table& table) const {
    const toml::node& node = need(table, "default");
    if (node.is_boolean()) return node.as_boolean()->get();
    if (node.is_integer()) return static_cast<long>(node.as_integer()->get());
    if (node.is_floating_point()) return number(table, "default");
    if (node.is_string()) return word(node, "default");
    refuse(node.source(), "default: not a boolean, an integer, a real number or text");
  }

  /// Text that can be said on the command line, in ID:key=value,key=value and in lists of these.
  [[nodiscard]] std::string word(const toml::node& node, std::string_view key) const {
    std::string said = line(node, key);
    if (said.find_first_of(",;") != std::string::npos)
      refuse(node.source(), fmt::format("{}: '{}'; commas and semicolons separate parameters", key, said));
    return said;
  }

  [[nodiscard]] std::vector<std::string> choices(const toml::table& table) const {
    const toml::node& node = need(table, "choices");
    if (!node.is_array() || node.as_array()->empty())
      refuse(node.source(), R"(choices: not a list of texts; write ["chord", "centripetal"])");
    std::vector<std::string> words;
    for (const toml::node& item : *node.as_array()) words.push_back(word(item, "choices"));
    return words;
  }

  [[nodiscard]] SchemeTraits traits(const toml::table& root) const {
    const toml::node* node = root.get("traits");
    if (node == nullptr || !node->is_table())
      refuse(node == nullptr ? root.source() : node->source(),
             "traits are missing; write a line [traits] and below it continuity = \"G1\", and what else is claimed");
    const toml::table& table = *node->as_table();
    SchemeTraits traits;
    std::vector<std::string_view> known{"continuity", "continuity_exceptions"};
    for (const auto& [key, member] : trait_flags) {
      known.push_back(key);
      if (table.contains(key)) traits.*member = flag(table, key);
    }
    for (const TraitCount& trait : trait_counts) {
      known.push_back(trait.name);
      if (table.contains(trait.name)) traits.*trait.member = static_cast<int>(count(table, trait.name, trait.least));
    }
    for (const auto& [key, value] : table)
      if (std::ranges::find(known, key.str()) == known.end())
        refuse(key.source(), fmt::format("unknown trait '{}'; known are {}", key.str(), fmt::join(known, ", ")));
    traits.continuity = continuity(table);
    if (table.contains("continuity_exceptions")) traits.continuity_exceptions = text(table, "continuity_exceptions");
    if (!traits.open && !traits.closed)
      refuse(table.source(), "neither open nor closed; a scheme fits open curves, closed ones or both");
    return traits;
  }

  [[nodiscard]] Continuity continuity(const toml::table& table) const {
    const std::string said = text(table, "continuity");
    std::vector<std::string_view> names;
    for (const Continuity one : continuities) {
      if (said == kappabench::name(one)) return one;
      names.push_back(kappabench::name(one));
    }
    refuse(table["continuity"].node()->source(),
           fmt::format("continuity: '{}'; known are {}", said, fmt::join(names, ", ")));
  }

  /// Of the manifest, of those files beside it that the command names, and of `files`.
  [[nodiscard]] std::string digest(const toml::table& root, const Command& command) const {
    std::vector<fs::path> parts{file_};
    for (const std::string& word : command.words) {
      std::error_code ignored;
      if (fs::path(word).is_relative() && fs::is_regular_file(command.folder / word, ignored))
        parts.push_back(command.folder / word);
    }
    if (root.contains("files"))
      for (const std::string& word : texts(root, "files")) {
        std::error_code ignored;
        if (!fs::is_regular_file(command.folder / word, ignored))
          refuse(root["files"].node()->source(),
                 fmt::format("files: no file '{}'; files that the program reads, relative to the manifest", word));
        parts.push_back(command.folder / word);
      }
    return digest_of_files(parts);
  }

  fs::path file_;
};

/// Not more than a manifest may have: a stranger's file may be anything.
std::string text_of(const fs::path& file) {
  std::error_code ignored;
  std::ifstream stream;
  if (fs::is_regular_file(file, ignored)) stream.open(file, std::ios::binary);
  if (!stream.is_open())
    throw std::runtime_error(fmt::format("{}: cannot be read; a manifest is a TOML file", file.string()));
  std::string text(most_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > most_bytes)
    throw std::runtime_error(
        fmt::format("{}:1: more than {} bytes; a manifest is a page of TOML", file.string(), most_bytes));
  return text;
}

}  // namespace

Manifest read_manifest(const fs::path& file) {
  const Reader reader(file);
  try {
    return reader.manifest(toml::parse(text_of(file)));
  } catch (const toml::parse_error& error) {
    reader.refuse(error.source(), fmt::format("no TOML: {}; see https://toml.io for the format", error.description()));
  }
}

void load_manifest(const fs::path& file, Registry& registry) {
  Manifest manifest = read_manifest(file);
  SchemeInfo info = manifest.info;
  // One program for all instances of the scheme, whatever their parameters.
  const auto external = std::make_shared<External>(std::move(manifest));
  try {
    registry.add(std::move(info), [external](const Parameters& given) {
      return std::make_shared<const ExternalScheme>(external, given);
    });
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}; choose another id", file.string(), error.what()));
  }
}

}  // namespace kappabench
