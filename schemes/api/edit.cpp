#include "schemes/api/edit.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace kappabench {

namespace {

void require(bool valid) {
  if (!valid) throw std::out_of_range("edit: there is no such point");
}

/// Ids written out, so that they survive a change of positions.
Input with_explicit_ids(Input input) {
  if (input.ids.empty()) {
    input.ids.resize(input.points.size());
    std::iota(input.ids.begin(), input.ids.end(), 0);
  }
  return input;
}

int smallest_unused_id(std::vector<int> ids) {
  std::ranges::sort(ids);
  int candidate = 0;
  for (const int id : ids) {
    if (id == candidate) ++candidate;
  }
  return candidate;
}

struct Applied {
  const Input& input;

  Input operator()(const Move& move) const {
    require(move.point >= 0 && move.point < input.size());
    Input moved = input;
    moved.points[static_cast<std::size_t>(move.point)] = move.to;
    return moved;
  }
  Input operator()(const Insert& insert) const {
    require(insert.before >= 0 && insert.before <= input.size());
    Input longer = with_explicit_ids(input);
    longer.points.insert(longer.points.begin() + insert.before, insert.at);
    longer.ids.insert(longer.ids.begin() + insert.before, smallest_unused_id(longer.ids));
    if (longer.options.empty() && insert.options != PointOptions{}) longer.options.resize(input.points.size());
    if (!longer.options.empty()) longer.options.insert(longer.options.begin() + insert.before, insert.options);
    return longer;
  }
  Input operator()(const Erase& erase) const {
    require(erase.point >= 0 && erase.point < input.size());
    Input shorter = with_explicit_ids(input);
    shorter.points.erase(shorter.points.begin() + erase.point);
    shorter.ids.erase(shorter.ids.begin() + erase.point);
    if (!shorter.options.empty()) shorter.options.erase(shorter.options.begin() + erase.point);
    return shorter;
  }
};

}  // namespace

Input apply(const Input& input, const Edit& edit) { return std::visit(Applied{input}, edit); }

}  // namespace kappabench
