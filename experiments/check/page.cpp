#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "experiments/check/check.hpp"

namespace kappabench::check {

namespace {

std::string counts(const Finding& finding) {
  std::vector<std::string> words;
  for (const Count& count : finding.tried) words.push_back(fmt::format("{} {}", count.number, count.what));
  std::string text = fmt::format("{}", fmt::join(words, ", "));
  if (!finding.note.empty()) text += (text.empty() ? "" : "; ") + finding.note;
  return text;
}

std::string refutations(const Checked& checked) {
  std::string text;
  for (const auto& [claim, finding] : checked.claims) {
    if (finding.verdict != Verdict::refuted) continue;
    text += fmt::format("\n{}: {} is refuted {} time{} ({})\n", checked.scheme, claim.name, finding.refuted,
                        finding.refuted == 1 ? "" : "s", claim.meaning);
    for (const Refutation& refutation : finding.refutations)
      text += fmt::format("  {}\n    {}\n    $ {}\n", refutation.where, refutation.numbers, refutation.command);
  }
  return text;
}

std::vector<std::string> names_of(const Checked& checked, Verdict verdict) {
  std::vector<std::string> names;
  for (const auto& [claim, finding] : checked.claims)
    if (finding.verdict == verdict) names.push_back(claim.name);
  return names;
}

std::string line(const Checked& checked) {
  const std::vector<std::string> refuted = names_of(checked, Verdict::refuted);
  std::string text = fmt::format("{:<14} {:>2} held", checked.scheme, names_of(checked, Verdict::held).size());
  if (const auto n = names_of(checked, Verdict::not_claimed).size(); n > 0) text += fmt::format(", {} not claimed", n);
  if (const auto n = names_of(checked, Verdict::not_tried).size(); n > 0) text += fmt::format(", {} not tried", n);
  return text + (refuted.empty() ? "\n" : fmt::format("; refuted: {}\n", fmt::join(refuted, ", ")));
}

using nlohmann::ordered_json;

ordered_json json_of(const Finding& finding) {
  ordered_json tried = ordered_json::object(), places = ordered_json::array();
  for (const Count& count : finding.tried) tried[count.what] = count.number;
  for (const Refutation& refutation : finding.refutations)
    places.push_back({{"where", refutation.where}, {"numbers", refutation.numbers}, {"command", refutation.command}});
  return {{"verdict", name(finding.verdict)},
          {"tried", tried},
          {"note", finding.note},
          {"refuted", finding.refuted},
          {"refutations", places}};
}

}  // namespace

std::string page(const Checked& checked) {
  std::string text = fmt::format("{}: {}\n\n", checked.scheme, checked.title);
  for (const auto& [claim, finding] : checked.claims)
    text += fmt::format("{:<14} {:<12} {}\n", claim.name, name(finding.verdict),
                        finding.verdict == Verdict::not_claimed ? "" : counts(finding));
  return text + refutations(checked);
}

std::string overview(const std::vector<Checked>& all) {
  std::string text;
  for (const Checked& checked : all) text += line(checked);
  for (const Checked& checked : all) text += refutations(checked);
  return text;
}

std::string json(const std::vector<Checked>& all) {
  ordered_json list = ordered_json::array();
  for (const Checked& checked : all) {
    ordered_json claims = ordered_json::array();
    for (const auto& [claim, finding] : checked.claims) {
      ordered_json entry = json_of(finding);
      ordered_json named{{"claim", claim.name}, {"meaning", claim.meaning}};
      named.update(entry);
      claims.push_back(std::move(named));
    }
    list.push_back({{"scheme", checked.scheme}, {"sound", checked.sound()}, {"claims", claims}});
  }
  return list.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace kappabench::check
