#include "schemes/curve/segment.hpp"

#include <cassert>

namespace kappabench {

void Segment::jets(std::span<const double> t, int order, std::span<Jet> out) const {
  assert(t.size() == out.size());
  for (std::size_t i = 0; i < t.size(); ++i) out[i] = jet(t[i], order);
}

}  // namespace kappabench
