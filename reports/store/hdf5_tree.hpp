#pragma once

#include <H5Cpp.h>

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "reports/store/hdf5_store.hpp"

/// Two views of one HDF5 group with the same member functions, so that schema.hpp states the layout once for writing
/// and reading: numbers and words are attributes, columns are one-dimensional datasets. No type but 64-bit floats,
/// 32- and 64-bit integers and UTF-8 strings (variable length in attributes, null-padded in datasets) is used, and
/// nothing records a time.
namespace kappabench::store {

using ColumnView = std::variant<const std::vector<double>*, const std::vector<int>*, const std::vector<std::string>*>;

/// A link may not hold '/': "a/b" becomes "a_b". The exact name is kept in the attribute "name".
[[nodiscard]] std::string link_name(const std::string& name);

class TreeWriter {
 public:
  explicit TreeWriter(H5::Group group);

  void value(const std::string& name, const std::string& text);
  void value(const std::string& name, double number);
  void value(const std::string& name, int number);
  void value(const std::string& name, long number);
  void value(const std::string& name, bool flag);
  void text(const std::string& name, const std::string& long_text);  ///< a dataset; absent when empty
  template <class Cell>
  void column(const std::string& name, const std::vector<Cell>& cells) {
    write_column(name, &cells);
  }

  /// A group of columns of one length; absent when that length is 0.
  template <class Describe>
  void table(const std::string& name, Describe describe) {
    Columns columns;
    describe(columns);
    write_table(name, columns);
  }
  template <class Describe>
  void group(const std::string& name, Describe describe) {
    TreeWriter inside = child(name);
    describe(inside);
  }
  /// Children in order, each a group named by `name_of(index, item)` with its place in the attribute "index".
  template <class Item, class NameOf, class Describe>
  void list(const std::string& name, const std::vector<Item>& items, NameOf name_of, Describe describe) {
    TreeWriter parent = child(name);
    for (std::size_t i = 0; i < items.size(); ++i) {
      TreeWriter inside = parent.child(name_of(i, items[i]));
      inside.value("index", static_cast<int>(i));
      describe(inside, items[i]);
    }
  }
  void table_columns(const std::vector<TableColumn>& columns);
  void numbers(const std::string& name, const std::map<std::string, long>& values);
  void series(const std::string& name, const std::map<std::string, std::vector<double>>& values);

 private:
  struct Columns : std::vector<std::pair<std::string, ColumnView>> {
    template <class Cell>
    void operator()(const std::string& name, const std::vector<Cell>& cells) {
      emplace_back(name, &cells);
    }
  };
  TreeWriter child(const std::string& name);
  void write_column(const std::string& name, ColumnView cells);
  void write_table(const std::string& name, const Columns& columns);

  H5::Group group_;
};

class TreeReader {
 public:
  explicit TreeReader(H5::Group group);

  void value(const std::string& name, std::string& text) const;
  void value(const std::string& name, double& number) const;
  void value(const std::string& name, int& number) const;
  void value(const std::string& name, long& number) const;
  void value(const std::string& name, bool& flag) const;
  void text(const std::string& name, std::string& long_text) const;
  void column(const std::string& name, std::vector<double>& cells) const;
  void column(const std::string& name, std::vector<int>& cells) const;
  void column(const std::string& name, std::vector<std::string>& cells) const;

  template <class Describe>
  void table(const std::string& name, Describe describe) const {
    const auto inside = child(name);
    if (!inside) return;
    std::optional<std::size_t> length;
    auto read = [&](const std::string& column_name, auto& cells) {
      inside->column(column_name, cells);
      if (length.value_or(cells.size()) != cells.size())
        inside->damaged(column_name, "has another length than its table");
      length = cells.size();
    };
    describe(read);
  }
  template <class Describe>
  void group(const std::string& name, Describe describe) const {
    const TreeReader inside = required_child(name);
    describe(inside);
  }
  template <class Item, class NameOf, class Describe>
  void list(const std::string& name, std::vector<Item>& items, NameOf, Describe describe) const {
    for (const TreeReader& inside : required_child(name).children_in_order()) describe(inside, items.emplace_back());
  }
  void table_columns(std::vector<TableColumn>& columns) const;
  void numbers(const std::string& name, std::map<std::string, long>& values) const;
  void series(const std::string& name, std::map<std::string, std::vector<double>>& values) const;

 private:
  [[nodiscard]] std::optional<TreeReader> child(const std::string& name) const;
  [[nodiscard]] TreeReader required_child(const std::string& name) const;
  [[nodiscard]] std::vector<TreeReader> children_in_order() const;
  [[nodiscard]] std::vector<std::string> link_names() const;
  [[nodiscard]] H5::DataSet dataset(const std::string& name) const;
  [[noreturn]] void damaged(const std::string& name, const std::string& what) const;

  H5::Group group_;
};

/// All attributes that are words.
[[nodiscard]] std::map<std::string, std::string> text_attributes(const H5::H5Object& object);

/// The bytes of a new HDF5 file that `fill` writes.
[[nodiscard]] std::string file_image(const std::function<void(TreeWriter&)>& fill);

}  // namespace kappabench::store
