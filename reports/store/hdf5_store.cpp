#include "reports/store/hdf5_store.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "reports/atomic_file.hpp"
#include "reports/store/hdf5_tree.hpp"
#include "reports/store/schema.hpp"

namespace kappabench::store {
namespace {

constexpr const char* results_format = "kappabench-results";
constexpr const char* cell_format = "kappabench-cell";
constexpr const char* layout_text =
    "/experiments/<id>/cells/<number dataset "
    "scheme>/curves/<number>/{points,report,trace,counters,warnings,exact,samples,nodes,"
    "joints,metrics}, .../cells/*/{metrics,timings}, /experiments/<id>/tables/<id>/<column>, "
    "/experiments/<id>/figures, "
    "/experiments/<id>/claims. Words and single numbers are attributes; columns are datasets of one length a group; "
    "children are ordered by their attribute 'index'. curvature: positive turns left; s: arc length from the start.";

bool is_own_key(const std::string& key) { return key == "format" || key == "schema_version" || key == "layout"; }

/// A last line after the HDF5 data, which HDF5 itself does not look at. The library may crash on metadata that were
/// damaged, so nothing is parsed before this sum is right.
std::string checksum_line(std::string_view bytes) {
  boost::crc_32_type sum;
  sum.process_bytes(bytes.data(), bytes.size());
  return fmt::format("\nkappabench crc32 {:08x}\n", sum.checksum());
}

void check_sum(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  const std::string example = checksum_line({}), head = example.substr(0, example.rfind(' '));
  const std::size_t length = example.size();
  if (!stream || bytes.size() < length || bytes.compare(bytes.size() - length, head.size(), head) != 0) {
    throw StoreError(fmt::format(
        "is truncated ({} bytes), or an HDF5 file not written by kappabench: compute or copy it again", bytes.size()));
  }
  const std::size_t data = bytes.size() - length;
  if (checksum_line({bytes.data(), data}) != bytes.substr(data)) {
    throw StoreError("differs from its checksum, so it was damaged or edited: compute or copy it again");
  }
}

void write_file(const std::filesystem::path& file, const char* format, const std::function<void(TreeWriter&)>& fill) {
  std::string bytes;
  try {
    bytes = file_image([&](TreeWriter& root) {
      root.value("format", std::string(format));
      root.value("schema_version", schema_version);
      root.value("layout", std::string(layout_text));
      fill(root);
    });
  } catch (const H5::Exception& error) {
    throw StoreError(fmt::format("{}: HDF5 could not build the file: {}", file.string(), error.getDetailMsg()));
  }
  bytes += checksum_line(bytes);
  try {
    replace_file(file, bytes);
  } catch (const FileError& error) {
    throw StoreError(error.what());
  }
}

void check_identity(const H5::Group& root, const std::string& format) {
  const auto attributes = text_attributes(root);
  const auto found = attributes.find("format");
  if (found == attributes.end() || found->second != format) {
    throw StoreError(fmt::format("holds {}, not {}", found == attributes.end() ? "no format" : found->second, format));
  }
  int version = 0;
  TreeReader(root).value("schema_version", version);
  if (version != schema_version) {
    throw StoreError(fmt::format("has schema version {}, this program reads version {}: compute the results again",
                                 version, schema_version));
  }
}

/// Opens, checks and reads; every error names the file.
template <class Read>
auto read_file(const std::filesystem::path& file, const char* format, Read read) {
  H5::Exception::dontPrint();
  try {
    if (!std::filesystem::is_regular_file(file)) throw StoreError("no such file");
    if (!H5::H5File::isHdf5(file.c_str())) throw StoreError("is not an HDF5 file");
    check_sum(file);
    const H5::H5File hdf5(file.c_str(), H5F_ACC_RDONLY);
    const H5::Group root = hdf5.openGroup("/");
    check_identity(root, format);
    return read(root);
  } catch (const StoreError& error) {
    throw StoreError(fmt::format("{}: {}", file.string(), error.what()));
  } catch (const H5::Exception& error) {
    throw StoreError(fmt::format("{}: is damaged: {} ({})", file.string(), error.getDetailMsg(), error.getFuncName()));
  } catch (const std::filesystem::filesystem_error& error) {
    throw StoreError(fmt::format("{}: {}", file.string(), error.code().message()));
  }
}

}  // namespace

void write_results(const std::filesystem::path& file, const Results& results) {
  write_file(file, results_format, [&](TreeWriter& root) {
    for (const auto& [key, text] : results.provenance) {
      if (!is_own_key(key)) root.value(key, text);
    }
    root.list("experiments", results.experiments, by_id,
              [](TreeWriter& child, const ExperimentRecord& experiment) { describe_experiment(child, experiment); });
  });
}

Results read_results(const std::filesystem::path& file) {
  return read_file(file, results_format, [](const H5::Group& root) {
    Results results;
    for (const auto& [key, text] : text_attributes(root)) {
      if (!is_own_key(key)) results.provenance[key] = text;
    }
    TreeReader(root).list(
        "experiments", results.experiments, by_id,
        [](const TreeReader& child, ExperimentRecord& record) { describe_experiment(child, record); });
    return results;
  });
}

void write_cell(const std::filesystem::path& file, const CellRecord& cell) {
  write_file(file, cell_format,
             [&](TreeWriter& root) { root.group("cell", [&](TreeWriter& inside) { describe_cell(inside, cell); }); });
}

CellRecord read_cell(const std::filesystem::path& file) {
  return read_file(file, cell_format, [](const H5::Group& root) {
    CellRecord cell;
    TreeReader(root).group("cell", [&](const TreeReader& inside) { describe_cell(inside, cell); });
    return cell;
  });
}

std::string hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  H5::H5Library::getLibVersion(major, minor, release);
  return fmt::format("{}.{}.{}", major, minor, release);
}

}  // namespace kappabench::store
