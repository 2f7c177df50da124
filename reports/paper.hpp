#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace kappabench {

/// A statement of a paper that can be tested.
struct PrintedClaim {
  std::string id;       ///< short and stable: "extremum-at-points"
  std::string place;    ///< "Sect. 3, property 2"
  std::string text;     ///< the statement in our words
  std::string printed;  ///< the printed number or words; may be empty
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

/// Reads one paper. Unknown keys, missing ones and ids used twice throw PaperError.
[[nodiscard]] Paper read_paper(const std::filesystem::path& file);

/// All papers of a folder, in the order of their names.
[[nodiscard]] std::vector<Paper> read_papers(const std::filesystem::path& folder);

/// Where this build keeps its papers.
[[nodiscard]] std::filesystem::path papers_folder();

}  // namespace kappabench
