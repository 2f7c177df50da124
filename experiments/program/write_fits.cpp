#include "experiments/program/write_fits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "experiments/program/curve_formats.hpp"
#include "experiments/program/write_file.hpp"

namespace kappabench {

namespace {

/// One line on the worst that happened, and the exit status it means.
ExitStatus judge(std::string_view input, const std::vector<Fit>& fits) {
  const auto with = [&fits](auto... outcomes) {
    return std::ranges::find_if(fits, [&](const Fit& fit) { return ((fit.report.outcome == outcomes) || ...); });
  };
  const auto complain = [&](const auto& found) {
    const std::string where =
        fits.size() == 1 ? std::string(input) : fmt::format("{}: curve {}", input, found - fits.begin());
    const std::string why =
        found->report.message.empty() ? fmt::format("residual {:.2g}", found->report.residual) : found->report.message;
    fmt::print(stderr, "kappabench: {}: {}: {}\n", where, name(found->report.outcome), why);
  };
  const auto wild = std::ranges::find_if(
      fits, [](const Fit& f) { return f.report.outcome == Outcome::converged && !f.report.warnings.empty(); });
  if (wild != fits.end())
    fmt::print(stderr, "kappabench: {}: warning {}: {}\n", input, wild->report.warnings.begin()->first,
               wild->report.message);
  if (const auto refused = with(Outcome::unsupported_input); refused != fits.end()) {
    complain(refused);
    return bad_usage;
  }
  if (const auto trouble = with(Outcome::failed, Outcome::not_converged); trouble != fits.end()) {
    complain(trouble);
    return ran_and_failed;
  }
  return success;
}

}  // namespace

ExitStatus write_fits(const std::filesystem::path& output, std::string_view format, const Scheme& scheme,
                      const std::vector<Fit>& fits, std::string_view input) {
  // Curves that could be fitted are not withheld because of others; where none could, nothing is overwritten.
  const std::string known_format = format_for(output, format);
  if (std::ranges::any_of(fits, [](const Fit& f) { return f.curve.has_value(); }))
    write_file(output, format_fits(known_format, scheme, fits));
  return judge(input, fits);
}

}  // namespace kappabench
