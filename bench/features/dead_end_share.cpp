// Dead ends: free cells that no path from start to goal needs, because they lead nowhere.
//
// A free cell with at most one legal step is removed, and its step with it; this repeats until no such cell
// is left. Start and goal stay. A removed cell does not become an obstacle: diagonal steps beside it stay
// legal. What is left does not depend on the order of removal. So blind corridors one cell wide vanish; wider
// pockets, whose cells have two ways out, are what trap_depth is for.
#include <bit>
#include <vector>

#include "bench/features/feature.hpp"
#include "core/checkpoint.hpp"

namespace pathrace::bench {
namespace {

class Pruning {
 public:
  explicit Pruning(FeatureContext& context)
      : grid_(context.scenario().grid()),
        moves_(context.moves()),
        start_(grid_.index(context.scenario().start)),
        goal_(grid_.index(context.scenario().goal)),
        open_(moves_.data(), moves_.data() + moves_.size()),
        removed_(moves_.size(), 0) {}

  std::int64_t removed_cells() {
    for (int y = 0; y < grid_.height(); ++y) {
      checkpoint();
      for (int x = 0; x < grid_.width(); ++x) {
        const std::size_t cell = grid_.index({x, y});
        if (!grid_.blocked_at(cell)) remove_chain(cell);
      }
    }
    return count_;
  }

 private:
  bool leads_nowhere(std::size_t cell) const {
    return removed_[cell] == 0 && std::popcount(open_[cell]) <= 1 && cell != start_ && cell != goal_;
  }

  // The only neighbour of a removed cell may be the next to go.
  void remove_chain(std::size_t cell) {
    while (leads_nowhere(cell)) {
      removed_[cell] = 1;
      ++count_;
      if (open_[cell] == 0) return;
      const int direction = std::countr_zero(open_[cell]);
      cell = moves_.step(cell, direction);
      open_[cell] = static_cast<std::uint8_t>(open_[cell] & ~(1U << opposite(direction)));
    }
  }

  const OccupancyGrid& grid_;
  const MoveTable& moves_;
  std::size_t start_;
  std::size_t goal_;
  std::vector<std::uint8_t> open_;  // legal steps to cells that are still there
  std::vector<std::uint8_t> removed_;
  std::int64_t count_ = 0;
};

std::optional<double> dead_end_share(FeatureContext& context) {
  const std::int64_t removed = Pruning(context).removed_cells();
  return static_cast<double>(removed) / static_cast<double>(context.scenario().grid().free_cells());
}

}  // namespace

Feature dead_end_share_feature() {
  return {"dead_end_share", "share",
          "free cells in blind alleys: removed by repeated removal of cells with at most one legal step",
          FeatureType::real, dead_end_share};
}

}  // namespace pathrace::bench
