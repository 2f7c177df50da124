#include <fmt/format.h>

#include <algorithm>

#include "experiments/check/all_claims.hpp"

namespace kappabench::check {

namespace {

void look(const SchemeUnderTest& subject, const Trial& trial, Notes& notes) {
  const std::string command = fit_command(trial.shown, subject.text());
  const auto& nodes = trial.fit.curve->nodes();
  const auto& listed = subject.info().marks;
  for (const Node& node : nodes)
    for (const std::string& mark : node.marks) {
      notes.count("marks");
      if (std::ranges::find(listed, mark, &MarkSpec::name) == listed.end())
        notes.refute({fmt::format("{}, point {}", trial.shown.name, node.point),
                      fmt::format("has the mark '{}', which SchemeInfo::marks does not list", mark), command});
    }
  for (const MarkSpec& mark : listed) {
    const auto counter = trial.fit.report.counters.find(mark.name);
    if (counter == trial.fit.report.counters.end()) continue;
    notes.count("counters");
    const auto number = std::ranges::count_if(nodes, [&](const Node& node) { return node.has(mark.name); });
    if (number != counter->second)
      notes.refute({trial.shown.name,
                    fmt::format("the counter {} is {}; {} nodes have the mark", mark.name, counter->second, number),
                    command});
  }
}

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  for (const Trial* trial : subject.trials()) {
    if (!trial->fit.curve) continue;
    notes.count("curves");
    look(subject, *trial, notes);
  }
  return notes.finding();
}

}  // namespace

Claim marks_claim() {
  return {"marks", "nodes have marks that are listed; counters of that name count them", always, test};
}

}  // namespace kappabench::check
