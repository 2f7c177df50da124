// Keys of cells: a change of anything that a result depends on changes the keys of those results and of no others.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/run/experiment.hpp"
#include "experiments/run/uses.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

/// A scheme as it will be when its results have changed. Nobody fits with it.
class NextVersion : public Scheme {
 public:
  NextVersion(SchemeInfo info, Parameters parameters) : Scheme(std::move(info), std::move(parameters)) {}

 private:
  [[nodiscard]] Fit solve(const Input&) const override { throw std::logic_error("only its key is asked for"); }
};

/// Every scheme of this build, with the version of one of them raised.
Registry with_next_version_of(std::string_view id) {
  Registry registry;
  for (SchemeInfo info : all_schemes().list()) {
    if (info.id != id) {
      registry.add(info, [id_of = info.id](const Parameters& p) { return all_schemes().create(id_of, p.values()); });
      continue;
    }
    ++info.version;
    registry.add(info, [info](const Parameters& p) { return std::make_shared<const NextVersion>(info, p); });
  }
  return registry;
}

std::vector<CellJob> every_job(const Registry& registry) {
  std::vector<CellJob> jobs;
  for (const Experiment& experiment : all_experiments())
    std::ranges::move(experiment.jobs({.registry = registry}), std::back_inserter(jobs));
  return jobs;
}

bool uses_scheme(const CellJob& job, std::string_view id) {
  return std::ranges::any_of(job.uses.schemes, [id](const SchemePtr& scheme) { return scheme->info().id == id; });
}

/// A cell of two schemes, a drawing with options and a metric.
Uses sample_uses() {
  Drawing drawing{.id = "two", .curves = {{.points = {{0, 0}, {1, 0}, {2, 1}}, .closed = false}}};
  drawing.curves.front().options.resize(3);
  return {.work = "sample",
          .schemes = {scheme("kappa"), scheme("ekappa:a=0.8")},
          .drawings = {drawing},
          .metrics = {&find_metric("continuity")},
          .seed = 1,
          .numbers = {{"inputs", 10}},
          .words = {{"kind", "walk"}}};
}

}  // namespace

TEST_CASE("raising the version of a scheme changes the keys of the cells that use it, and no others") {
  const std::vector<CellJob> jobs = every_job(all_schemes());
  for (const SchemeInfo& info : all_schemes().list()) {
    INFO(info.id);
    const Registry raised = with_next_version_of(info.id);
    const std::vector<CellJob> next = every_job(raised);
    REQUIRE(next.size() == jobs.size());
    long changed = 0;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      INFO(jobs[i].uses.work << ", " << jobs[i].dataset << ", " << jobs[i].label);
      const bool differs = jobs[i].key() != next[i].key();
      CHECK(differs == uses_scheme(jobs[i], info.id));
      changed += differs;
    }
    CHECK(changed > 0);
  }
}

TEST_CASE("raising the version of a metric changes the keys of the cells that use it, and no others") {
  const std::vector<CellJob> jobs = every_job(all_schemes());
  for (const Metric& metric : all_metrics()) {
    INFO(metric.id);
    Metric next = metric;
    ++next.version;
    long changed = 0;
    for (CellJob job : jobs) {
      const std::string key = job.key();
      const auto used = std::ranges::count(job.uses.metrics, &metric);
      std::ranges::replace(job.uses.metrics, &metric, static_cast<const Metric*>(&next));
      CHECK((job.key() != key) == (used > 0));
      changed += used > 0;
    }
    if (!metric.refits) CHECK(changed > 0);
  }
}

TEST_CASE("every part of what a cell uses is in its key") {
  const std::string key = key_of(sample_uses());
  const auto changed_by = [&key](auto change) {
    Uses uses = sample_uses();
    change(uses);
    return key_of(uses) != key;
  };
  CHECK(key_of(sample_uses()) == key);
  CHECK(changed_by([](Uses& u) { u.work = "other"; }));
  CHECK(changed_by([](Uses& u) { ++u.version; }));
  CHECK(changed_by([](Uses& u) { ++u.seed; }));
  CHECK(changed_by([](Uses& u) { u.numbers["inputs"] = 11; }));
  CHECK(changed_by([](Uses& u) { u.words["kind"] = "star"; }));
  CHECK(changed_by([](Uses& u) { std::swap(u.schemes[0], u.schemes[1]); }));
  CHECK(changed_by([](Uses& u) { u.schemes[1] = scheme("ekappa:a=0.81"); }));
  CHECK(changed_by([](Uses& u) { u.metrics.clear(); }));
  CHECK(changed_by([](Uses& u) { u.drawings.push_back(u.drawings.front()); }));
  const auto changed_by_curve = [&](auto change) {
    return changed_by([&](Uses& u) { change(u.drawings[0].curves[0]); });
  };
  CHECK(changed_by_curve([](Input& in) { in.closed = true; }));
  CHECK(changed_by_curve([](Input& in) { in.points[1].y() = 1e-300; }));
  CHECK(changed_by_curve([](Input& in) { std::swap(in.points[0], in.points[1]); }));
  CHECK(changed_by_curve([](Input& in) { in.options[1].type = PointType::cusp; }));
  for (const PointNumber& number : point_numbers) {
    CHECK(changed_by_curve([&](Input& in) { in.options[1].*number.member = 0.5; }));
    CHECK(changed_by_curve([&](Input& in) { in.options[2].*number.member = 0.5; }));
  }
  // A title is not what a result depends on.
  CHECK_FALSE(changed_by([](Uses& u) { u.drawings[0].title = "Two"; }));
}

TEST_CASE("cells with one key compute the same thing, and an experiment's cells are told apart") {
  std::map<std::string, void (*)(const Uses&, store::CellRecord&)> computes;
  for (const Experiment& experiment : all_experiments()) {
    std::set<std::pair<std::string, std::string>> names;
    std::set<std::string> keys_without_drawings;
    for (const CellJob& job : experiment.jobs({.registry = all_schemes()})) {
      INFO(experiment.id << ": " << job.dataset << ", " << job.label);
      REQUIRE(job.compute != nullptr);
      CHECK(computes.emplace(job.key(), job.compute).first->second == job.compute);
      // Equal drawings under two names are one cell; anything else that differs must be in the key.
      if (job.uses.drawings.empty()) CHECK(keys_without_drawings.insert(job.key()).second);
      CHECK(names.emplace(job.dataset, job.label).second);
    }
  }
}
