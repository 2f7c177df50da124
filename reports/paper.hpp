#pragma once

#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace kappabench {

/// What a statement says of its cases. It follows from the paper's words, before anything is measured, and decides by
/// which rule (experiments/study/verdicts.hpp) counts or numbers become a verdict.
enum class StatementKind {
  always,      ///< "is", "every", "guaranteed", "only": of all cases
  in_general,  ///< "generally", "usually", a statement without a quantifier about what users draw
  often,       ///< "often", "tends to"
  may,         ///< "can", "may", "there are": of some case
  growth,      ///< how fast something grows: an exponent, a ratio, a share by size
  number       ///< a printed number
};

/// "always", "in general", "often", "may", "growth", "number".
[[nodiscard]] std::string_view name(StatementKind kind);

/// A statement of a paper that can be tested.
struct PrintedClaim {
  std::string id;       ///< short and stable: "extremum-at-points"
  std::string place;    ///< "Sect. 3, property 2"
  std::string text;     ///< the statement in our words
  std::string printed;  ///< the printed number or words; may be empty
  StatementKind kind = StatementKind::always;
  /// Of growth and number: what is measured agrees with the paper from `at_least` to `at_most`.
  double at_least = -std::numeric_limits<double>::infinity(), at_most = std::numeric_limits<double>::infinity();
};

/// A table of a paper, as words so that the printed digits stay.
struct PrintedTable {
  std::string id, place, title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// reports/paper/<id>.toml; the format is in reports/README.md.
struct Paper {
  std::string id;  ///< name of the file: "ekappa-2022-miura"
  std::string title;
  std::string citation;  ///< authors, journal, year
  std::vector<PrintedClaim> claims;
  std::vector<PrintedTable> tables;
};

/// A file of claims that cannot be used; what() is one line "file:line: what is wrong".
class PaperError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads the text of one paper; `file` is what messages call it, and its name without folder and ending is the id.
/// Unknown keys, missing ones and ids used twice throw PaperError.
[[nodiscard]] Paper parse_paper(std::string_view text, const std::string& file);

/// Every paper of reports/paper/, sorted by id.
[[nodiscard]] const std::vector<Paper>& printed_papers();

/// One of them. Throws PaperError naming the file that is missing.
[[nodiscard]] const Paper& printed_paper(std::string_view id);
/// A claim of one of them. Throws PaperError naming the claim that is missing.
[[nodiscard]] const PrintedClaim& printed_claim(std::string_view paper, std::string_view id);

}  // namespace kappabench
