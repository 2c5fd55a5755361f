#include "scenarios/families/spanning.hpp"

#include <array>

#include "core/cell.hpp"

namespace pathrace::scenarios {

SpanningTree::SpanningTree(int columns, int rows, Stream& stream)
    : columns_(columns), doors_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0) {
  static constexpr std::array<Cell, 4> sides = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  std::vector<std::uint8_t> seen(doors_.size(), 0);
  const Cell first{stream.between(0, columns - 1), stream.between(0, rows - 1)};
  std::vector<Cell> trail{first};
  seen[node(first.x, first.y)] = 1;
  while (!trail.empty()) {
    const Cell here = trail.back();
    std::array<Cell, 4> open{};
    std::size_t count = 0;
    for (const Cell side : sides) {
      const Cell next{here.x + side.x, here.y + side.y};
      const bool inside = next.x >= 0 && next.y >= 0 && next.x < columns && next.y < rows;
      if (inside && seen[node(next.x, next.y)] == 0) open[count++] = next;
    }
    if (count == 0) {
      trail.pop_back();
      continue;
    }
    const Cell next = open[count == 1 ? 0 : stream.below(count)];
    if (next.y == here.y) doors_[node(next.x > here.x ? here.x : next.x, here.y)] |= 1U;
    if (next.x == here.x) doors_[node(here.x, next.y > here.y ? here.y : next.y)] |= 2U;
    seen[node(next.x, next.y)] = 1;
    trail.push_back(next);
  }
}

}  // namespace pathrace::scenarios
