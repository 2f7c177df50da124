#pragma once

#include <span>

#include "datasets/drawing.hpp"
#include "experiments/run/experiment.hpp"
#include "reports/paper.hpp"

namespace kappabench {

/// What the compiler cannot see of the lists that the house is made of. Throws std::logic_error, one line that says
/// what is wrong and where, for two experiments or two drawings with one id, a drawing that does not say where it comes
/// from, and a claim that an experiment declares and the paper's file lacks.
void check_house(std::span<const Experiment> experiments, std::span<const Paper> papers,
                 std::span<const Drawing> drawings);

/// `conclude` of the experiment. Throws std::logic_error for a verdict on a claim that the experiment does not declare;
/// one without a paper declares none.
void conclude(const Experiment& experiment, const Context& context, store::ExperimentRecord& record);

}  // namespace kappabench
