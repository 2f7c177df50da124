// What changes the key of a cell.
#include <set>
#include <string>

#include "experiments/run/uses.hpp"
#include "tests/catch.hpp"

using namespace kappabench;

TEST_CASE("every option of a point is part of a cell's key") {
  const auto key_with = [](const PointOptions& options) {
    const Drawing drawing{.id = "d", .curves = {{.points = {{0, 0}, {1, 0}}, .options = {options, {}}}}};
    return key_of({.work = "w", .drawings = {drawing}});
  };
  std::set<std::string> keys{key_with({}), key_with({.type = PointType::loop})};
  for (const PointNumber& number : point_numbers) {
    PointOptions one;
    one.*number.member = 0.5;
    keys.insert(key_with(one));
  }
  CHECK(keys.size() == point_numbers.size() + 2);
}
