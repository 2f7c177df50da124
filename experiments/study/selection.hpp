#pragma once

#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "experiments/run/experiment.hpp"

namespace kappabench::study {

/// What the context asks for, or an experiment's own choice: drawings, schemes, metrics.

/// The drawings that the context asks for; all built-in ones if it asks for none. Of two with one id the second one is
/// ID-2.
[[nodiscard]] std::vector<Drawing> drawings_of(const Context& context);

/// The drawings that the context asks for, otherwise the named ones.
[[nodiscard]] std::vector<Drawing> drawings_or(const Context& context, std::span<const std::string_view> names);
[[nodiscard]] std::vector<Drawing> drawings_or(const Context& context, std::initializer_list<std::string_view> names);

/// The schemes that the context asks for; one of each with its defaults if it asks for none.
[[nodiscard]] std::vector<SchemePtr> schemes_of(const Context& context);

/// The metrics that the context asks for; if it asks for none, all but those that fit again.
[[nodiscard]] std::vector<const Metric*> metrics_of(const Context& context);

/// The drawings without what they say about single points (a, type, ...).
[[nodiscard]] std::vector<Drawing> without_options(std::vector<Drawing> drawings);

/// The drawings without their curves of more than `most` points.
[[nodiscard]] std::vector<Drawing> without_long_curves(std::vector<Drawing> drawings, int most);

}  // namespace kappabench::study
