#include "reports/store/hdf5_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace kappabench::store {
namespace {

H5::StrType variable_text() {
  H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);
  type.setCset(H5T_CSET_UTF8);
  return type;
}

H5::StrType padded_text(std::size_t width) {
  H5::StrType type(H5::PredType::C_S1, std::max<std::size_t>(width, 1));
  type.setCset(H5T_CSET_UTF8);
  type.setStrpad(H5T_STR_NULLPAD);
  return type;
}

/// Creation properties without the time of creation, so that equal data are equal bytes.
H5::DSetCreatPropList timeless_dataset() {
  H5::DSetCreatPropList properties;
  H5Pset_obj_track_times(properties.getId(), false);
  return properties;
}

H5::Group create_timeless_group(H5::Group& parent, const std::string& name) {
  const H5::PropList properties(H5P_GROUP_CREATE);
  H5Pset_obj_track_times(properties.getId(), false);
  const hid_t id = H5Gcreate2(parent.getId(), name.c_str(), H5P_DEFAULT, properties.getId(), H5P_DEFAULT);
  if (id < 0) throw H5::GroupIException("H5Gcreate2", fmt::format("cannot create the group '{}'", name));
  H5::Group group(id);
  H5Gclose(id);  // `group` holds its own reference
  return group;
}

void refuse_second(const H5::Group& group, const std::string& link) {
  if (group.nameExists(link)) {
    throw std::invalid_argument(fmt::format("two entries are named '{}' in {}", link, group.getObjName()));
  }
}

void write_attribute(const H5::H5Object& object, const std::string& name, const std::string& text) {
  object.createAttribute(name, variable_text(), H5::DataSpace(H5S_SCALAR)).write(variable_text(), text);
}

template <class Number>
void write_attribute(const H5::H5Object& object, const std::string& name, const H5::PredType& stored,
                     const H5::PredType& native, Number number) {
  object.createAttribute(name, stored, H5::DataSpace(H5S_SCALAR)).write(native, &number);
}

H5::DataSet create_dataset(H5::Group& group, const std::string& name, const H5::DataType& type,
                           const H5::DataSpace& space) {
  refuse_second(group, name);
  return group.createDataSet(name, type, space, timeless_dataset());
}

H5::DataSpace line(std::size_t length) {
  const hsize_t extent = length;
  return H5::DataSpace(1, &extent);
}

H5::DataSet write_cells(H5::Group& group, const std::string& name, const std::vector<double>& cells) {
  auto dataset = create_dataset(group, name, H5::PredType::IEEE_F64LE, line(cells.size()));
  if (!cells.empty()) dataset.write(cells.data(), H5::PredType::NATIVE_DOUBLE);
  return dataset;
}

H5::DataSet write_cells(H5::Group& group, const std::string& name, const std::vector<int>& cells) {
  auto dataset = create_dataset(group, name, H5::PredType::STD_I32LE, line(cells.size()));
  if (!cells.empty()) dataset.write(cells.data(), H5::PredType::NATIVE_INT);
  return dataset;
}

H5::DataSet write_cells(H5::Group& group, const std::string& name, const std::vector<std::string>& cells) {
  std::size_t width = 1;
  for (const auto& cell : cells) width = std::max(width, cell.size());
  auto dataset = create_dataset(group, name, padded_text(width), line(cells.size()));
  std::string block(width * cells.size(), '\0');
  for (std::size_t i = 0; i < cells.size(); ++i)
    std::memcpy(block.data() + i * width, cells[i].data(), cells[i].size());
  if (!cells.empty()) dataset.write(block.data(), padded_text(width));
  return dataset;
}

std::size_t length_of(ColumnView cells) {
  return std::visit([](const auto* column) { return column->size(); }, cells);
}

std::string trimmed(const char* begin, std::size_t width) { return std::string(begin, strnlen(begin, width)); }

}  // namespace

std::string link_name(const std::string& name) {
  std::string link = name;
  std::replace(link.begin(), link.end(), '/', '_');
  return link.empty() || link == "." || link == ".." ? "_" + link : link;
}

// ---- writing

TreeWriter::TreeWriter(H5::Group group) : group_(std::move(group)) {}

void TreeWriter::value(const std::string& name, const std::string& text) { write_attribute(group_, name, text); }
void TreeWriter::value(const std::string& name, double number) {
  write_attribute(group_, name, H5::PredType::IEEE_F64LE, H5::PredType::NATIVE_DOUBLE, number);
}
void TreeWriter::value(const std::string& name, int number) {
  write_attribute(group_, name, H5::PredType::STD_I32LE, H5::PredType::NATIVE_INT, number);
}
void TreeWriter::value(const std::string& name, long number) {
  write_attribute(group_, name, H5::PredType::STD_I64LE, H5::PredType::NATIVE_LONG, number);
}
void TreeWriter::value(const std::string& name, bool flag) { value(name, flag ? 1 : 0); }

void TreeWriter::text(const std::string& name, const std::string& long_text) {
  if (long_text.empty()) return;
  const auto type = padded_text(long_text.size());
  create_dataset(group_, name, type, H5::DataSpace(H5S_SCALAR)).write(long_text.data(), type);
}

void TreeWriter::write_column(const std::string& name, ColumnView cells) {
  std::visit([&](const auto* column) { write_cells(group_, name, *column); }, cells);
}

TreeWriter TreeWriter::child(const std::string& name) {
  const std::string link = link_name(name);
  refuse_second(group_, link);
  return TreeWriter(create_timeless_group(group_, link));
}

void TreeWriter::write_table(const std::string& name, const Columns& columns) {
  const std::size_t length = length_of(columns.front().second);
  for (const auto& [column, cells] : columns) {
    if (length_of(cells) == length) continue;
    throw std::invalid_argument(fmt::format("{}/{}: column '{}' has {} values, column '{}' has {}", group_.getObjName(),
                                            name, column, length_of(cells), columns.front().first, length));
  }
  if (length == 0) return;
  TreeWriter inside = child(name);
  for (const auto& [column, cells] : columns) inside.write_column(column, cells);
}

void TreeWriter::table_columns(const std::vector<TableColumn>& columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const TableColumn& column = columns[i];
    const auto dataset =
        std::visit([&](const auto& cells) { return write_cells(group_, link_name(column.name), cells); }, column.cells);
    write_attribute(dataset, "index", H5::PredType::STD_I32LE, H5::PredType::NATIVE_INT, static_cast<int>(i));
    write_attribute(dataset, "name", column.name);
    write_attribute(dataset, "unit", column.unit);
    write_attribute(dataset, "method", column.method);
    write_attribute(dataset, "whole_numbers", H5::PredType::STD_I32LE, H5::PredType::NATIVE_INT,
                    column.whole_numbers ? 1 : 0);
  }
}

void TreeWriter::numbers(const std::string& name, const std::map<std::string, long>& values) {
  if (values.empty()) return;
  TreeWriter inside = child(name);
  for (const auto& [key, number] : values) inside.value(key, number);
}

void TreeWriter::series(const std::string& name, const std::map<std::string, std::vector<double>>& values) {
  if (values.empty()) return;
  TreeWriter inside = child(name);
  for (const auto& [key, cells] : values) {
    write_attribute(write_cells(inside.group_, link_name(key), cells), "name", key);
  }
}

// ---- reading

TreeReader::TreeReader(H5::Group group) : group_(std::move(group)) {}

void TreeReader::damaged(const std::string& name, const std::string& what) const {
  throw StoreError(fmt::format("is damaged: '{}' of {} {}", name, group_.getObjName(), what));
}

namespace {

template <class Number>
Number read_number(const H5::H5Object& object, const std::string& name, const H5::PredType& native) {
  Number number{};
  object.openAttribute(name).read(native, &number);
  return number;
}

std::string read_text(const H5::H5Object& object, const std::string& name) {
  const H5::Attribute attribute = object.openAttribute(name);
  std::string text;
  attribute.read(attribute.getStrType(), text);
  return text;
}

std::size_t length_of(const H5::DataSet& dataset) {
  return static_cast<std::size_t>(dataset.getSpace().getSimpleExtentNpoints());
}

void read_cells(const H5::DataSet& dataset, std::vector<double>& cells) {
  cells.resize(length_of(dataset));
  if (!cells.empty()) dataset.read(cells.data(), H5::PredType::NATIVE_DOUBLE);
}

void read_cells(const H5::DataSet& dataset, std::vector<int>& cells) {
  cells.resize(length_of(dataset));
  if (!cells.empty()) dataset.read(cells.data(), H5::PredType::NATIVE_INT);
}

void read_cells(const H5::DataSet& dataset, std::vector<std::string>& cells) {
  const H5::StrType type = dataset.getStrType();
  const std::size_t width = type.getSize(), length = length_of(dataset);
  std::vector<char> block(width * length);
  if (!block.empty()) dataset.read(block.data(), type);
  cells.clear();
  for (std::size_t i = 0; i < length; ++i) cells.push_back(trimmed(block.data() + i * width, width));
}

}  // namespace

void TreeReader::value(const std::string& name, std::string& text) const {
  if (!group_.attrExists(name)) damaged(name, "is missing");
  text = read_text(group_, name);
}
void TreeReader::value(const std::string& name, double& number) const {
  if (!group_.attrExists(name)) damaged(name, "is missing");
  number = read_number<double>(group_, name, H5::PredType::NATIVE_DOUBLE);
}
void TreeReader::value(const std::string& name, long& number) const {
  if (!group_.attrExists(name)) damaged(name, "is missing");
  number = read_number<long>(group_, name, H5::PredType::NATIVE_LONG);
}
void TreeReader::value(const std::string& name, int& number) const {
  long wide = 0;
  value(name, wide);
  number = static_cast<int>(wide);
}
void TreeReader::value(const std::string& name, bool& flag) const {
  long wide = 0;
  value(name, wide);
  flag = wide != 0;
}

H5::DataSet TreeReader::dataset(const std::string& name) const {
  if (!group_.nameExists(name)) damaged(name, "is missing");
  return group_.openDataSet(name);
}

void TreeReader::text(const std::string& name, std::string& long_text) const {
  long_text.clear();
  if (!group_.nameExists(name)) return;
  std::vector<std::string> cells;
  read_cells(dataset(name), cells);
  if (cells.size() != 1) damaged(name, "is not a single text");
  long_text = std::move(cells.front());
}

void TreeReader::column(const std::string& name, std::vector<double>& cells) const { read_cells(dataset(name), cells); }
void TreeReader::column(const std::string& name, std::vector<int>& cells) const { read_cells(dataset(name), cells); }
void TreeReader::column(const std::string& name, std::vector<std::string>& cells) const {
  read_cells(dataset(name), cells);
}

std::optional<TreeReader> TreeReader::child(const std::string& name) const {
  if (!group_.nameExists(name)) return std::nullopt;
  return TreeReader(group_.openGroup(name));
}

TreeReader TreeReader::required_child(const std::string& name) const {
  if (!group_.nameExists(name)) damaged(name, "is missing");
  return TreeReader(group_.openGroup(name));
}

std::vector<TreeReader> TreeReader::children_in_order() const {
  std::vector<std::pair<int, std::string>> links;
  for (const auto& link : link_names()) {
    links.emplace_back(0, link);
    required_child(link).value("index", links.back().first);
  }
  std::sort(links.begin(), links.end());
  std::vector<TreeReader> ordered;
  for (const auto& [index, link] : links) ordered.push_back(required_child(link));
  return ordered;
}

std::vector<std::string> TreeReader::link_names() const {
  std::vector<std::string> names;
  for (hsize_t i = 0; i < group_.getNumObjs(); ++i) names.push_back(group_.getObjnameByIdx(i));
  return names;
}

void TreeReader::table_columns(std::vector<TableColumn>& columns) const {
  std::vector<std::pair<int, TableColumn>> found;
  for (const auto& link : link_names()) {
    const H5::DataSet cells = dataset(link);
    TableColumn column{
        .name = read_text(cells, "name"), .unit = read_text(cells, "unit"), .method = read_text(cells, "method")};
    column.whole_numbers = read_number<int>(cells, "whole_numbers", H5::PredType::NATIVE_INT) != 0;
    if (cells.getTypeClass() == H5T_STRING) column.cells = std::vector<std::string>();
    std::visit([&](auto& values) { read_cells(cells, values); }, column.cells);
    found.emplace_back(read_number<int>(cells, "index", H5::PredType::NATIVE_INT), std::move(column));
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [index, column] : found) columns.push_back(std::move(column));
}

void TreeReader::numbers(const std::string& name, std::map<std::string, long>& values) const {
  const auto inside = child(name);
  if (!inside) return;
  for (int i = 0; i < inside->group_.getNumAttrs(); ++i) {
    const std::string key = inside->group_.openAttribute(static_cast<unsigned>(i)).getName();
    inside->value(key, values[key]);
  }
}

void TreeReader::series(const std::string& name, std::map<std::string, std::vector<double>>& values) const {
  const auto inside = child(name);
  if (!inside) return;
  for (const auto& link : inside->link_names()) {
    const H5::DataSet cells = inside->dataset(link);
    read_cells(cells, values[read_text(cells, "name")]);
  }
}

// ---- files

std::map<std::string, std::string> text_attributes(const H5::H5Object& object) {
  std::map<std::string, std::string> texts;
  for (int i = 0; i < object.getNumAttrs(); ++i) {
    const H5::Attribute attribute = object.openAttribute(static_cast<unsigned>(i));
    if (attribute.getTypeClass() == H5T_STRING) texts[attribute.getName()] = read_text(object, attribute.getName());
  }
  return texts;
}

std::string file_image(const std::function<void(TreeWriter&)>& fill) {
  H5::Exception::dontPrint();
  // In memory, so that a full disk is met by one plain write and never half-way inside the library.
  H5::FileAccPropList in_memory;
  in_memory.setCore(std::size_t{1} << 20, false);
  H5::H5File file("image", H5F_ACC_TRUNC, H5::FileCreatPropList::DEFAULT, in_memory);
  TreeWriter root(file.openGroup("/"));
  fill(root);
  file.flush(H5F_SCOPE_GLOBAL);
  const ssize_t size = H5Fget_file_image(file.getId(), nullptr, 0);
  if (size < 0) throw H5::FileIException("H5Fget_file_image", "the size of the image is unknown");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file.getId(), bytes.data(), bytes.size()) != size) {
    throw H5::FileIException("H5Fget_file_image", "the image cannot be copied");
  }
  return bytes;
}

}  // namespace kappabench::store
