#include "experiments/study/rows.hpp"

#include <algorithm>
#include <variant>

#include "metrics/statistics.hpp"

namespace kappabench::study {

namespace {

std::size_t length_of(const store::TableRecord& table) {
  return table.columns.empty() ? 0 : std::visit([](const auto& cells) { return cells.size(); }, table.columns[0].cells);
}

Row row_of(const store::CellRecord& cell, const store::TableRecord& table, std::size_t i) {
  Row row{{{key::dataset.name, cell.dataset}, {key::label.name, cell.label}}, {}};
  for (const store::TableColumn& column : table.columns) {
    if (const auto* words = std::get_if<std::vector<std::string>>(&column.cells))
      row.keys.insert_or_assign(column.name, (*words)[i]);
    else if (const double number = std::get<std::vector<double>>(column.cells)[i]; column.method.empty())
      row.keys.insert_or_assign(column.name, number);
    else
      row.numbers.emplace(column.name, number);
  }
  return row;
}

}  // namespace

bool Row::has(const KeyIs& key) const {
  const auto found = keys.find(key.name);
  return found != keys.end() && found->second == key.value;
}

Rows::Rows(const std::vector<store::CellRecord>& cells) {
  auto all = std::make_shared<std::vector<Row>>();
  for (const store::CellRecord& cell : cells)
    for (const store::TableRecord& table : cell.rows)
      for (std::size_t i = 0; i < length_of(table); ++i) all->push_back(row_of(cell, table, i));
  for (const Row& row : *all) rows_.push_back(&row);
  all_ = std::move(all);
}

Rows Rows::where(const std::vector<KeyIs>& keys) const {
  return where_row(
      [&](const Row& row) { return std::ranges::all_of(keys, [&](const KeyIs& k) { return row.has(k); }); });
}

std::vector<std::pair<KeyValue, Rows>> Rows::by(const Key& key) const {
  std::vector<std::pair<KeyValue, Rows>> groups;
  std::map<KeyValue, std::size_t> place;
  for (const Row* row : rows_) {
    const auto value = row->keys.find(key.name);
    if (value == row->keys.end()) continue;
    const auto [known, is_new] = place.emplace(value->second, groups.size());
    if (is_new) groups.emplace_back(value->second, Rows(*this, {}));
    groups[known->second].second.rows_.push_back(row);
  }
  return groups;
}

std::vector<std::string> Rows::words_of(const Key& key) const {
  std::vector<std::string> words;
  for (const auto& [value, rows] : by(key)) words.push_back(std::get<std::string>(value));
  return words;
}

std::vector<double> Rows::values(const Quantity& what) const {
  std::vector<double> found;
  for (const Row* row : rows_)
    if (const auto number = row->numbers.find(what.name); number != row->numbers.end()) found.push_back(number->second);
  return found;
}

double Rows::total(const Quantity& what) const {
  double sum = 0.0;
  for (const double value : values(what)) sum += value;
  return sum;
}
double Rows::median(const Quantity& what) const { return kappabench::median(values(what)); }
double Rows::mean(const Quantity& what) const { return kappabench::mean(values(what)); }
double Rows::largest(const Quantity& what) const { return kappabench::largest(values(what)); }

std::vector<Pair> Rows::pairs(const Quantity& what, const KeyIs& first, const KeyIs& second) const {
  const auto other_keys = [&](const Row& row) {
    auto keys = row.keys;
    keys.erase(first.name);
    keys.erase(key::label.name);
    return keys;
  };
  std::map<std::map<std::string, KeyValue>, double> partner;
  for (const Row* row : rows_)
    if (row->has(second) && row->has(what)) partner.emplace(other_keys(*row), (*row)[what]);
  std::vector<Pair> found;
  for (const Row* row : rows_) {
    if (!row->has(first) || !row->has(what)) continue;
    const auto other = partner.find(other_keys(*row));
    if (other != partner.end()) found.emplace_back((*row)[what], other->second);
  }
  return found;
}

}  // namespace kappabench::study
