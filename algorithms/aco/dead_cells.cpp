#include "algorithms/aco/dead_cells.hpp"

namespace pathrace::algorithms {
namespace {

// The direction from one neighbour of a cell to another; -1 when they are not neighbours themselves.
int direction_between(int from, int to) {
  const Cell a = directions[static_cast<std::size_t>(from)];
  const Cell b = directions[static_cast<std::size_t>(to)];
  for (int d = 0; d < direction_count; ++d) {
    const Cell step = directions[static_cast<std::size_t>(d)];
    if (a.x + step.x == b.x && a.y + step.y == b.y) return d;
  }
  return -1;
}

using DirectionTable = std::array<std::array<int, direction_count>, direction_count>;

const DirectionTable& directions_between() {
  static const DirectionTable table = [] {
    DirectionTable result{};
    for (int a = 0; a < direction_count; ++a) {
      for (int b = 0; b < direction_count; ++b) {
        result[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] = direction_between(a, b);
      }
    }
    return result;
  }();
  return table;
}

}  // namespace

bool dominated(const LiveMoves& moves, std::size_t cell) {
  const DirectionTable& between = directions_between();
  const unsigned neighbours = moves[cell];
  for (int a = 0; a < direction_count; ++a) {
    if ((neighbours >> a & 1U) == 0) continue;
    const unsigned steps = moves[moves.step(cell, a)];
    for (int b = a + 1; b < direction_count; ++b) {
      if ((neighbours >> b & 1U) == 0) continue;
      const int direct = between[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
      if (direct < 0 || (steps >> direct & 1U) == 0) return false;
    }
  }
  return true;
}

DeadCells::DeadCells(LiveMoves& moves, DeadTable table, Layer layer, std::size_t start, std::size_t goal)
    : moves_(moves), table_(table), layer_(layer), start_(start), goal_(goal) {
  if (table == DeadTable::global_literal && layer == Layer::obstacle) seen_.assign(moves.size(), 0);
}

bool DeadCells::stepped_back_from(std::size_t cell) {
  if (cell == start_ || cell == goal_ || !moves_.alive(cell)) return false;
  bool marked = false;
  if (table_ == DeadTable::global_literal) {
    marked = mark_literally(cell);
  } else if (table_ == DeadTable::global_dominated && dominated(moves_, cell)) {
    moves_.lose(cell);
    marked = true;
  }
  marked_ += marked ? 1 : 0;
  return marked;
}

bool DeadCells::mark_literally(std::size_t cell) {
  if (layer_ == Layer::dead) {
    moves_.lose(cell);
    return true;
  }
  moves_.wall(cell);
  if (connected()) return true;
  moves_.unwall(cell);
  return false;
}

bool DeadCells::connected() {
  ++fills_;
  frontier_.assign(1, start_);
  seen_[start_] = fills_;
  while (!frontier_.empty()) {
    const std::size_t cell = frontier_.back();
    frontier_.pop_back();
    if (cell == goal_) return true;
    for (int d = 0; d < direction_count; ++d) {
      if ((moves_[cell] >> d & 1) == 0) continue;
      const std::size_t next = moves_.step(cell, d);
      if (seen_[next] == fills_) continue;
      seen_[next] = fills_;
      frontier_.push_back(next);
    }
  }
  return false;
}

}  // namespace pathrace::algorithms
