#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <span>
#include <utility>

#include "experiments/program/errors.hpp"
#include "experiments/program/verbs.hpp"
#include "experiments/program/write_file.hpp"

namespace kappabench {

/// Name and text of each file of templates/; the build writes it (datasets/inside.cmake).
std::span<const std::pair<std::string_view, std::string_view>> templates_inside();

namespace {

namespace fs = std::filesystem;

/// A language that a scheme may be written in: which folders of templates/ make its skeleton, and what to type next.
struct Kind {
  std::string_view option;
  std::vector<std::string_view> folders;
  std::string_view registration;  ///< how C++ tells of its scheme
  std::string_view next;
};

const std::array<Kind, 4>& kinds() {
  static const std::array<Kind, 4> all{
      Kind{"in-tree",
           {"cpp", "in-tree"},
           "\nvoid register_@IDENT@(Registry& registry);\nvoid register_@IDENT@(Registry& registry) { "
           "registry.add<@CLASS@>(); }\n\n}  // namespace kappabench",
           "add this line to schemes/CMakeLists.txt, after the others like it:\n"
           "  kappabench_schemes_in(@FOLDER@ @IDENT@)\n"
           "  cmake --preset release && cmake --build --preset release --target kappabench\n"
           "  build/release/experiments/kappabench check @NAME@\n"},
      Kind{"plugin",
           {"cpp", "plugin"},
           "}  // namespace kappabench\n\nvoid register_schemes(kappabench::Registry& registry) { "
           "registry.add<kappabench::@CLASS@>(); }",
           "  cmake -S @DIR@ -B @DIR@/build -DCMAKE_PREFIX_PATH=<where kappabench is installed>\n"
           "  cmake --build @DIR@/build\n"
           "  kappabench check @NAME@ --plugin @DIR@/build/@IDENT@.so\n"},
      Kind{"python",
           {"python"},
           "",
           "  kappabench fit bird --plugin @DIR@/@NAME@.toml --scheme @NAME@ -o bird.svg\n"
           "  kappabench check @NAME@ --plugin @DIR@/@NAME@.toml\n"},
      Kind{"matlab",
           {"matlab"},
           "",
           "  kappabench fit bird --plugin @DIR@/@NAME@.toml --scheme @NAME@ -o bird.svg\n"
           "  kappabench check @NAME@ --plugin @DIR@/@NAME@.toml\n"}};
  return all;
}

/// "my-spline" as other texts need it: my_spline, MySpline, "My spline".
std::map<std::string, std::string> words_for(const std::string& name, const fs::path& folder) {
  std::string ident = name, type, title = name;
  std::ranges::replace(ident, '-', '_');
  std::ranges::replace(title, '-', ' ');
  const auto upper = [](char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); };
  title[0] = upper(title[0]);
  bool first = true;
  for (const char c : name) {
    if (c != '-') type += first ? upper(c) : c;
    first = c == '-';
  }
  const fs::path plain = folder.lexically_normal();
  return {{"@NAME@", name},
          {"@IDENT@", ident},
          {"@CLASS@", type},
          {"@TITLE@", title},
          {"@DIR@", folder.string()},
          {"@FOLDER@", (plain.has_filename() ? plain : plain.parent_path()).filename().string()}};
}

std::string filled(std::string text, const std::map<std::string, std::string>& words) {
  for (const auto& [placeholder, word] : words)
    for (std::size_t at = text.find(placeholder); at != std::string::npos;
         at = text.find(placeholder, at + word.size()))
      text.replace(at, placeholder.size(), word);
  return text;
}

/// The files of a kind: path below the folder, and text.
std::map<std::string, std::string> skeleton(const Kind& kind, std::map<std::string, std::string> words) {
  words["@REGISTRATION@"] = filled(std::string(kind.registration), words);
  std::map<std::string, std::string> files;
  for (const auto& [name, text] : templates_inside())
    for (const std::string_view folder : kind.folders) {
      const std::string prefix = fmt::format("experiments/program/templates/{}/", folder);
      if (name.starts_with(prefix))
        files[filled(std::string(name.substr(prefix.size())), words)] = filled(std::string(text), words);
    }
  return files;
}

void check_name(const std::string& name, const Registry& registry) {
  const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  constexpr std::size_t longest = 64;
  const bool good = !name.empty() && name.size() <= longest && name[0] >= 'a' && name[0] <= 'z' && name.back() != '-' &&
                    std::ranges::all_of(name, allowed) && name.find("--") == std::string::npos;
  if (!good)
    throw UsageError(
        fmt::format("'{}' is no id of a scheme; write lower-case letters, digits and single hyphens, a "
                    "letter first, such as my-spline",
                    name));
  const std::vector<SchemeInfo> known = registry.list();
  if (std::ranges::find(known, name, &SchemeInfo::id) != known.end())
    throw UsageError(fmt::format("there is a scheme '{}' already; choose another name", name));
}

void make_empty_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error) && !(fs::is_directory(folder, error) && fs::is_empty(folder, error)))
    throw UsageError(fmt::format("{}: is there already and not empty; name a new folder", folder.string()));
  fs::create_directories(folder, error);
  if (error) throw UsageError(fmt::format("{}: cannot be made ({})", folder.string(), error.message()));
}

}  // namespace

int new_scheme(const Registry& registry, const NewSchemeArguments& arguments) {
  check_name(arguments.name, registry);
  const auto kind = std::ranges::find(kinds(), arguments.kind, &Kind::option);
  if (kind == kinds().end()) throw UsageError(fmt::format("unknown kind '{}'", arguments.kind));
  make_empty_folder(arguments.folder);
  const auto words = words_for(arguments.name, arguments.folder);
  for (const auto& [name, text] : skeleton(*kind, words)) {
    write_file(arguments.folder / name, text);
    fmt::print("{}\n", (arguments.folder / name).string());
  }
  fmt::print("next:\n{}", filled(std::string(kind->next), words));
  return success;
}

}  // namespace kappabench
