#include "experiments/run/house.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string_view>

#include "datasets/datasets.hpp"

namespace kappabench {
namespace {

void check_claims(const Experiment& experiment, std::span<const Paper> papers) {
  if (experiment.paper.empty()) {
    if (experiment.claims.empty()) return;
    throw std::logic_error(fmt::format("experiment {}: judges the claim '{}' of no paper; name the paper",
                                       experiment.id, experiment.claims.front()));
  }
  const auto paper = std::ranges::find(papers, experiment.paper, &Paper::id);
  if (paper == papers.end())
    throw std::logic_error(
        fmt::format("experiment {}: there is no reports/paper/{}.toml", experiment.id, experiment.paper));
  for (const std::string& claim : experiment.claims)
    if (std::ranges::find(paper->claims, claim, &PrintedClaim::id) == paper->claims.end())
      throw std::logic_error(fmt::format("experiment {}: reports/paper/{}.toml has no claim '{}'; add it there",
                                         experiment.id, experiment.paper, claim));
}

}  // namespace

void check_house(std::span<const Experiment> experiments, std::span<const Paper> papers,
                 std::span<const Drawing> drawings) {
  std::set<std::string_view> ids;
  for (const Experiment& experiment : experiments) {
    if (!ids.insert(experiment.id).second)
      throw std::logic_error(fmt::format("two experiments have the id '{}'", experiment.id));
    check_claims(experiment, papers);
  }
  if (const std::string fault = fault_of(drawings); !fault.empty()) throw std::logic_error(fault);
}

void conclude(const Experiment& experiment, const Context& context, store::ExperimentRecord& record) {
  experiment.conclude(context, record);
  for (const store::ClaimRecord& claim : record.claims)
    if (claim.paper != experiment.paper || std::ranges::find(experiment.claims, claim.claim) == experiment.claims.end())
      throw std::logic_error(
          fmt::format("experiment {}: judges the claim '{}' of {}, which it does not declare; add it "
                      "to its claims",
                      experiment.id, claim.claim, claim.paper));
}

}  // namespace kappabench
