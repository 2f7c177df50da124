#include "schemes/plugin/external_scheme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "schemes/api/timed_outside.hpp"
#include "schemes/plugin/one_line.hpp"
#include "schemes/plugin/protocol.hpp"

namespace kappabench {

namespace {

/// Room for a thousand samples a point, and an end to endless output.
std::size_t most_bytes_for(int points) {
  constexpr std::size_t always = std::size_t{4} << 20, a_point = std::size_t{1} << 18, ever = std::size_t{1} << 28;
  return std::min(ever, always + a_point * static_cast<std::size_t>(points));
}

Report report_of(const Reply& reply, const Manifest& manifest, const Allowance& allowance) {
  std::string happened;
  Outcome outcome = Outcome::failed;
  switch (reply.end) {
    case Reply::End::timed_out:
      outcome = Outcome::timed_out;
      happened = fmt::format("no answer in {} s; is its output flushed after each line?", allowance.seconds);
      break;
    case Reply::End::ended:
      outcome = Outcome::crashed;
      happened = fmt::format("the program {} before it answered", reply.why);
      break;
    case Reply::End::overlong:
      happened = fmt::format("more than {} bytes without an end of line; an answer is one line", allowance.bytes);
      break;
    default:
      happened = fmt::format("cannot start '{}': {}", manifest.command.words.front(), reply.why);
  }
  if (!reply.stderr_.empty()) happened += fmt::format("; it said: {}", reply.stderr_);
  return {.outcome = outcome, .message = fmt::format("{}: {}", manifest.info.plugin, happened)};
}

}  // namespace

ExternalScheme::ExternalScheme(std::shared_ptr<External> external, Parameters parameters)
    : Scheme(external->manifest.info, std::move(parameters)), external_(std::move(external)) {}

Fit ExternalScheme::solve(const Input& input) const {
  const auto start = std::chrono::steady_clock::now();
  const Manifest& manifest = external_->manifest;
  const Allowance allowance{manifest.timeout, most_bytes_for(input.size())};
  const Reply reply = external_->process.ask(question_of(input, parameters()), allowance);
  const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - start;

  Fit fit{.input = input, .curve = std::nullopt, .report = {}};
  if (reply.end == Reply::End::answered) {
    try {
      fit = fit_of_answer(reply.line, input, manifest.info);
    } catch (const std::exception& error) {
      fit.report.message = one_line(error.what());
    }
  } else {
    fit.report = report_of(reply, manifest, allowance);
  }
  if (!(fit.report.seconds > 0.0)) fit.report.seconds = waited.count();
  fit.report.counters[std::string(timed_outside)] = 1;
  return fit;
}

}  // namespace kappabench
