#include "core/reference/exact_search.hpp"

#include <cstdint>
#include <queue>
#include <vector>

namespace pathrace::reference {
namespace {

struct Count {
  std::int32_t straight = -1;  // -1: not reached
  std::int32_t diagonal = 0;
};

double value(Count count) {
  return LatticeLength{count.straight, count.diagonal}.value();
}

struct Open {
  double cost;
  std::size_t index;
  friend bool operator>(const Open& a, const Open& b) {
    return a.cost != b.cost ? a.cost > b.cost : a.index > b.index;
  }
};

class Search {
 public:
  explicit Search(const Terrain& terrain)
      : grid_(*terrain.grid), rule_(terrain.rule), best_(grid_.padded_size()) {}

  Optimum run(Cell start, Cell goal) {
    const std::size_t target = grid_.index(goal);
    reach(grid_.index(start), {0, 0});
    while (!open_.empty()) {
      const Open next = open_.top();
      open_.pop();
      const Count count = best_[next.index];
      if (next.cost > value(count)) continue;
      if (next.index == target) return {true, LatticeLength{count.straight, count.diagonal}};
      expand(next.index, count);
    }
    return {true, std::nullopt};
  }

 private:
  bool blocked(std::size_t index) const { return grid_.blocked_at(index); }

  void reach(std::size_t index, Count count) {
    Count& known = best_[index];
    if (known.straight >= 0 && value(known) <= value(count)) return;
    known = count;
    open_.push({value(count), index});
  }

  void expand(std::size_t index, Count count) {
    const std::size_t stride = grid_.stride();
    const std::size_t up = index - stride;
    const std::size_t down = index + stride;
    const std::size_t left = index - 1;
    const std::size_t right = index + 1;
    for (const std::size_t side : {up, down, left, right}) {
      if (!blocked(side)) reach(side, {count.straight + 1, count.diagonal});
    }
    if (rule_ == MoveRule::four) return;
    for (const std::size_t vertical : {up, down}) {
      for (const std::size_t horizontal : {left, right}) {
        const std::size_t corner = vertical + horizontal - index;
        const int free_sides = (blocked(vertical) ? 0 : 1) + (blocked(horizontal) ? 0 : 1);
        const int needed = rule_ == MoveRule::strict ? 2 : rule_ == MoveRule::squeeze ? 1 : 0;
        if (!blocked(corner) && free_sides >= needed) reach(corner, {count.straight, count.diagonal + 1});
      }
    }
  }

  const OccupancyGrid& grid_;
  MoveRule rule_;
  std::vector<Count> best_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

}  // namespace

Optimum optimum(const Terrain& terrain, Cell start, Cell goal) {
  return Search(terrain).run(start, goal);
}

}  // namespace pathrace::reference
