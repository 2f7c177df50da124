#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/run/experiment.hpp"
#include "experiments/study/findings.hpp"

namespace kappabench::study {

/// What an experiment is, as its file says it last: the question, the cells, and what follows from them.
struct Study {
  std::string id, title, about;
  std::string paper{};                ///< name of a file in reports/paper/; empty for studies across papers
  std::vector<std::string> claims{};  ///< of that file, judged by `conclude`; an id that it lacks is a start error
  std::vector<CellJob> (*jobs)(const Context&);
  void (*conclude)(Findings&);
};

[[nodiscard]] Experiment experiment(Study study);

}  // namespace kappabench::study
