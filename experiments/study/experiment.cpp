#include "experiments/study/experiment.hpp"

namespace kappabench::study {

Experiment experiment(Study study) {
  return {.id = std::move(study.id),
          .title = std::move(study.title),
          .about = std::move(study.about),
          .paper = study.paper,
          .claims = std::move(study.claims),
          .jobs = study.jobs,
          .conclude = [paper = study.paper, conclude = study.conclude](const Context& context,
                                                                       store::ExperimentRecord& record) {
            Findings findings(context, paper, record);
            conclude(findings);
          }};
}

}  // namespace kappabench::study
