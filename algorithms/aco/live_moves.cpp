#include "algorithms/aco/live_moves.hpp"

#include <cassert>

#include "core/checkpoint.hpp"

namespace pathrace::algorithms {

LiveMoves::LiveMoves(const OccupancyGrid& grid, MoveRule rule)
    : rule_(rule), closed_(grid.padded_size()), obstacle_(grid.padded_size()) {
  const MoveTable moves(grid, rule);
  masks_.assign(moves.data(), moves.data() + moves.size());
  for (int d = 0; d < direction_count; ++d) offsets_[static_cast<std::size_t>(d)] = moves.offset(d);
  Pace pace;
  for (std::size_t i = 0; i < closed_.size(); ++i) {
    pace.step();
    closed_[i] = obstacle_[i] = static_cast<std::uint8_t>(grid.blocked_at(i));
  }
}

void LiveMoves::forbid(std::size_t from, int direction) {
  if ((masks_[from] >> direction & 1) == 0) return;
  const std::size_t to = step(from, direction);
  masks_[from] = static_cast<std::uint8_t>(masks_[from] & ~(1U << direction));
  masks_[to] = static_cast<std::uint8_t>(masks_[to] & ~(1U << opposite(direction)));
}

void LiveMoves::lose(std::size_t index) {
  assert(alive(index));
  closed_[index] = 1;
  for (int d = 0; d < direction_count; ++d) forbid(index, d);
}

// Past a wall go the four diagonals between its straight neighbours.
void LiveMoves::wall(std::size_t index) {
  before_wall_ = patch_around(index);
  lose(index);
  obstacle_[index] = 1;
  for (int corner = 1; corner < direction_count; corner += 2) {
    const bool other_side_blocked = obstacle_[step(index, corner)] != 0;
    const bool closes = rule_ == MoveRule::strict || (rule_ == MoveRule::squeeze && other_side_blocked);
    // From the neighbour before the corner to the one after it: E to S past SE is a step to SW.
    if (closes) forbid(step(index, corner - 1), (corner + 2) & 7);
  }
}

LiveMoves::Patch LiveMoves::patch_around(std::size_t index) const {
  Patch patch{};
  for (std::size_t d = 0; d < direction_count; ++d) patch.cells[d] = step(index, static_cast<int>(d));
  patch.cells[direction_count] = index;
  for (std::size_t i = 0; i < patch.cells.size(); ++i) patch.masks[i] = masks_[patch.cells[i]];
  return patch;
}

void LiveMoves::unwall(std::size_t index) {
  assert(before_wall_.cells[direction_count] == index);
  for (std::size_t i = 0; i < before_wall_.cells.size(); ++i)
    masks_[before_wall_.cells[i]] = before_wall_.masks[i];
  closed_[index] = obstacle_[index] = 0;
}

}  // namespace pathrace::algorithms
