#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/study/quantity.hpp"
#include "reports/store/model.hpp"

namespace kappabench::study {

/// Keys that every row has: the drawing (or other data set) and the label of its cell.
namespace key {
inline const Key dataset{"dataset"}, label{"label"};
}

/// One row of a finished cell.
struct Row {
  std::map<std::string, KeyValue> keys;
  std::map<std::string, double> numbers;

  [[nodiscard]] bool has(const KeyIs& key) const;
  [[nodiscard]] bool has(const Quantity& what) const { return numbers.contains(what.name); }
  /// Both throw std::out_of_range where the row has no such column.
  [[nodiscard]] double operator[](const Quantity& what) const { return numbers.at(what.name); }
  [[nodiscard]] const KeyValue& operator[](const Key& key) const { return keys.at(key.name); }
};

class Rows;

/// Two numbers of the same quantity whose rows differ in one key alone.
using Pair = std::pair<double, double>;

/// Rows of finished cells, in the order in which they were put. A value: selecting copies no numbers.
class Rows {
 public:
  Rows() = default;
  /// All rows of the cells.
  explicit Rows(const std::vector<store::CellRecord>& cells);

  /// The rows in which all these keys have these values.
  [[nodiscard]] Rows where(const std::vector<KeyIs>& keys) const;
  template <class Predicate>
  [[nodiscard]] Rows where_row(Predicate holds) const {
    Rows kept(*this, {});
    for (const Row* row : rows_)
      if (holds(*row)) kept.rows_.push_back(row);
    return kept;
  }
  /// The rows with each value of the key, in the order of first appearance; rows without it are left out.
  [[nodiscard]] std::vector<std::pair<KeyValue, Rows>> by(const Key& key) const;
  /// The words of a key, each once, in the order of first appearance.
  [[nodiscard]] std::vector<std::string> words_of(const Key& key) const;

  /// Every number of a quantity, and what is usually asked of them; NaN for none. NaNs among the numbers are left out
  /// of median, mean and largest.
  [[nodiscard]] std::vector<double> values(const Quantity& what) const;
  [[nodiscard]] double total(const Quantity& what) const;
  [[nodiscard]] double median(const Quantity& what) const;
  [[nodiscard]] double mean(const Quantity& what) const;
  [[nodiscard]] double largest(const Quantity& what) const;

  /// The quantity where `key` has one value and where it has another, for rows that agree in all other keys (the
  /// label of the cell aside).
  /// Rows without a partner are left out; of equal rows the first counts.
  [[nodiscard]] std::vector<Pair> pairs(const Quantity& what, const KeyIs& first, const KeyIs& second) const;

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] auto begin() const { return rows_.begin(); }  ///< of const Row*
  [[nodiscard]] auto end() const { return rows_.end(); }

 private:
  Rows(const Rows& all, std::vector<const Row*> rows) : all_(all.all_), rows_(std::move(rows)) {}

  std::shared_ptr<const std::vector<Row>> all_;
  std::vector<const Row*> rows_;
};

}  // namespace kappabench::study
