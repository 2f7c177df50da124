#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "reports/store/model.hpp"

namespace kappabench::store {

/// Version of the layout in reports/README.md. A file of another version is refused.
inline constexpr int schema_version = 4;

/// A file that cannot be written or read; what() is one line: which file, what is wrong, what would be right.
class StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes the whole tree to an HDF5 file. It is built in memory (about the size of the file), written under a
/// temporary name in the same folder, flushed and renamed: a killed run leaves the earlier file or none.
/// Guarantee: equal results give equal bytes; no time and no name of a machine gets in but through the provenance.
/// The provenance keys "format", "schema_version" and "layout" are the store's own and are ignored.
/// Throws StoreError for a full disk or an unwritable folder, and std::invalid_argument when the tree contradicts
/// itself (columns of unequal length, an id used twice).
void write_results(const std::filesystem::path& file, const Results& results);

/// Reads what write_results wrote: read_results(f) equals what was written. Throws StoreError for a missing,
/// truncated or foreign file or another schema version.
[[nodiscard]] Results read_results(const std::filesystem::path& file);

/// The same for a single cell, as a process of the runner hands it to its parent.
void write_cell(const std::filesystem::path& file, const CellRecord& cell);
[[nodiscard]] CellRecord read_cell(const std::filesystem::path& file);

/// Of the library that reads and writes them.
[[nodiscard]] std::string hdf5_version();

}  // namespace kappabench::store
