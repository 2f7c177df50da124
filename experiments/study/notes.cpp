#include "experiments/study/notes.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

namespace kappabench::study {

namespace {

store::TableColumn key_column(const KeyIs& key) {
  store::TableColumn column{.name = key.name, .unit = "", .cells = {}};
  if (std::holds_alternative<std::string>(key.value)) column.cells = std::vector<std::string>{};
  return column;
}

bool same_column(const store::TableColumn& a, const store::TableColumn& b) {
  return a.name == b.name && a.unit == b.unit && a.method == b.method && a.cells.index() == b.cells.index();
}

void append(store::TableColumn& column, const KeyValue& value) {
  std::visit([&](const auto& v) { std::get<std::vector<std::decay_t<decltype(v)>>>(column.cells).push_back(v); },
             value);
}

}  // namespace

void Notes::row(const std::vector<KeyIs>& keys, const std::vector<Reading>& readings) {
  store::TableRecord empty;
  for (const KeyIs& key : keys) empty.columns.push_back(key_column(key));
  for (const Reading& r : readings)
    empty.columns.push_back({.name = r.name, .unit = r.unit, .method = std::string(name(r.method)), .cells = {}});
  const auto fits = [&](const store::TableRecord& table) {
    return std::ranges::equal(table.columns, empty.columns, same_column);
  };
  auto table = std::ranges::find_if(cell_->rows, fits);
  if (table == cell_->rows.end()) table = cell_->rows.insert(cell_->rows.end(), std::move(empty));
  auto column = table->columns.begin();
  for (const KeyIs& key : keys) append(*column++, key.value);
  for (const Reading& r : readings) append(*column++, r.value);
}

}  // namespace kappabench::study
