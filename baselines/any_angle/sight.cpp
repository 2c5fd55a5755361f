#include "baselines/any_angle/sight.hpp"

#include <cstdint>
#include <cstdlib>

namespace pathrace::baselines {

bool in_sight(const OccupancyGrid& grid, Cell from, Cell to) {
  const std::int64_t width = std::abs(to.x - from.x);
  const std::int64_t height = std::abs(to.y - from.y);
  const auto stride = static_cast<std::ptrdiff_t>(grid.stride());
  const std::ptrdiff_t across = to.x >= from.x ? 1 : -1;
  const std::ptrdiff_t along = to.y >= from.y ? stride : -stride;
  auto index = static_cast<std::ptrdiff_t>(grid.index(from));
  const auto blocked = [&](std::ptrdiff_t at) { return grid.blocked_at(static_cast<std::size_t>(at)); };
  std::int64_t above = height - width;  // > 0: the segment passes on the far side in y of the corner ahead
  const auto target = static_cast<std::ptrdiff_t>(grid.index(to));
  while (index != target) {
    if (above == 0) {
      if (blocked(index + across) && blocked(index + along)) return false;
      index += across + along;
      above += 2 * (height - width);
    } else if (above > 0) {
      index += along;
      above -= 2 * width;
    } else {
      index += across;
      above += 2 * height;
    }
    if (blocked(index)) return false;
  }
  return true;
}

}  // namespace pathrace::baselines
