#include "algorithms/aco/dead_cells.hpp"

#include "core/checkpoint.hpp"
#include "core/lattice_length.hpp"

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

// How to get from one neighbour of a cell to another beside the cell, and no longer than through it: by the
// direct step, if there is one (two steps are at least 2 long, one at most sqrt 2), or over a third
// neighbour.
struct Detours {
  int direct = -1;
  struct Bend {
    int first = -1;
    int second = -1;
  };
  std::array<Bend, direction_count> bends;
  int bend_count = 0;
};

LatticeLength length_of_step(int direction) {
  return is_diagonal(direction) ? LatticeLength{0, 1} : LatticeLength{1, 0};
}

Detours detours_between(int a, int b) {
  Detours detours;
  detours.direct = direction_between(a, b);
  const LatticeLength through = length_of_step(a) + length_of_step(b);
  for (int over = 0; over < direction_count; ++over) {
    const int first = direction_between(a, over);
    const int second = direction_between(over, b);
    if (first < 0 || second < 0 || through < length_of_step(first) + length_of_step(second)) continue;
    detours.bends[static_cast<std::size_t>(detours.bend_count++)] = {first, second};
  }
  return detours;
}

using DetourTable = std::array<std::array<Detours, direction_count>, direction_count>;

const DetourTable& detours() {
  static const DetourTable table = [] {
    DetourTable result{};
    for (int a = 0; a < direction_count; ++a) {
      for (int b = 0; b < direction_count; ++b) {
        result[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] = detours_between(a, b);
      }
    }
    return result;
  }();
  return table;
}

bool legal(const LiveMoves& moves, std::size_t from, int direction) {
  return (moves[from] >> direction & 1) != 0;
}

bool any_open(const Detours& detours, const LiveMoves& moves, std::size_t from) {
  if (detours.direct >= 0 && legal(moves, from, detours.direct)) return true;
  for (int k = 0; k < detours.bend_count; ++k) {
    const Detours::Bend bend = detours.bends[static_cast<std::size_t>(k)];
    if (legal(moves, from, bend.first) && legal(moves, moves.step(from, bend.first), bend.second))
      return true;
  }
  return false;
}

}  // namespace

bool dominated(const LiveMoves& moves, std::size_t cell) {
  const DetourTable& table = detours();
  for (int a = 0; a < direction_count; ++a) {
    if (!legal(moves, cell, a)) continue;
    for (int b = a + 1; b < direction_count; ++b) {
      if (!legal(moves, cell, b)) continue;
      const Detours& beside = table[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
      if (!any_open(beside, moves, moves.step(cell, a))) return false;
    }
  }
  return true;
}

DeadCells::DeadCells(LiveMoves& moves, DeadTable table, Layer layer, std::size_t start, std::size_t goal)
    : moves_(moves), table_(table), layer_(layer), start_(start), goal_(goal) {
  if (table == DeadTable::global_literal && layer == Layer::obstacle) seen_.assign(moves.size(), 0);
  if (table == DeadTable::global_dominated) popped_.assign(moves.size(), 0);
}

const std::vector<std::size_t>& DeadCells::stepped_back_from(std::size_t cell) {
  lost_.clear();
  if (cell == start_ || cell == goal_ || !moves_.alive(cell)) return lost_;
  if (table_ == DeadTable::global_literal) mark_literally(cell);
  if (table_ == DeadTable::global_dominated) mark_dominated(cell);
  marked_ += lost_.size();
  return lost_;
}

void DeadCells::mark_literally(std::size_t cell) {
  if (layer_ == Layer::dead) {
    moves_.lose(cell);
    lost_.push_back(cell);
    return;
  }
  moves_.wall(cell);
  if (connected()) {
    lost_.push_back(cell);
  } else {
    moves_.unwall(cell);
  }
}

// The cell, then whichever of its neighbours its loss lets go, and so on.
void DeadCells::mark_dominated(std::size_t cell) {
  popped_[cell] = 1;
  frontier_.assign(1, cell);
  Pace pace;
  while (!frontier_.empty()) {
    pace.step();
    const std::size_t next = frontier_.back();
    frontier_.pop_back();
    if (!moves_.alive(next) || !dominated(moves_, next)) continue;
    for (int d = 0; d < direction_count; ++d) {
      if (legal(moves_, next, d) && popped_[moves_.step(next, d)] != 0)
        frontier_.push_back(moves_.step(next, d));
    }
    moves_.lose(next);
    lost_.push_back(next);
  }
}

bool DeadCells::connected() {
  ++fills_;
  frontier_.assign(1, start_);
  seen_[start_] = fills_;
  Pace pace;
  while (!frontier_.empty()) {
    pace.step();
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
