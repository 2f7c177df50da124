#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/program/errors.hpp"
#include "schemes/api/scheme.hpp"

namespace kappabench {

/// What verbs that fit do with their fits: writes them (`format` as in format_for; to standard output if `output` is
/// empty), and says in one line on stderr what went wrong first, if anything did; `input` names what was fitted.
/// Without any curve nothing is written. Returns bad_usage if a fit was refused as unsupported, else ran_and_failed if
/// one failed or did not converge, else success. Throws as format_fits and write_file do.
[[nodiscard]] ExitStatus write_fits(const std::filesystem::path& output, std::string_view format, const Scheme& scheme,
                                    const std::vector<Fit>& fits, std::string_view input);

}  // namespace kappabench
