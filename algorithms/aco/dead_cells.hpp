// Cells that ants must not enter again, because one of them got stuck there.
//
// An ant is stuck when all neighbours are on its own list of visited cells, which says little about the map:
// forbidding the cell to everybody, as published, can cut the best way and even the goal off (algorithms.md
// 2.6). The safe variant forbids a cell v only when it is *dominated*: between any two living neighbours a
// and b of v there is a way beside v, of one step or of two, that is no longer than a-v-b. So the lengths of
// all shortest ways between other cells stay. Once a cell is lost, its neighbours have fewer pairs to serve,
// so those that ants have stepped back from are looked at again: a pocket fills from its corners, row by row.
//
// Tan et al., 3.3.3 ("dead-lock tabu table"); Pu et al., 1.2.2 (the cell becomes an obstacle of the map).
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/aco/live_moves.hpp"
#include "core/names.hpp"

namespace pathrace::algorithms {

enum class DeadTable {
  none,            ///< no table
  per_ant,         ///< each ant keeps its own, for one walk: what stepping back along the path does by itself
  global_literal,  ///< as published: every cell stepped back from is lost to all ants
  global_dominated,  ///< only if it is dominated: no optimum is ever lost
};

/// May the cell be lost without making any way between two others longer? Expects a living cell.
bool dominated(const LiveMoves& moves, std::size_t cell);

/// What is marked and where; start and goal never are.
class DeadCells {
 public:
  enum class Layer { dead, obstacle };

  /// `moves` outlives this, in its place. Under global_literal in the obstacle layer a cell whose loss would
  /// cut the goal off from the start is refused, by a flood fill per mark; the dead layer marks without that
  /// guard, as Tan does.
  DeadCells(LiveMoves& moves, DeadTable table, Layer layer, std::size_t start, std::size_t goal);

  /// An ant has stepped back from this cell. Returns the cells that are lost by this, in the order in which
  /// they were marked; valid until the next call.
  const std::vector<std::size_t>& stepped_back_from(std::size_t cell);

  std::size_t marked() const { return marked_; }

 private:
  void mark_literally(std::size_t cell);
  void mark_dominated(std::size_t cell);
  bool connected();

  LiveMoves& moves_;
  DeadTable table_;
  Layer layer_;
  std::size_t start_;
  std::size_t goal_;
  std::size_t marked_ = 0;
  std::vector<std::size_t> lost_;     // by the last call
  std::vector<std::uint8_t> popped_;  // cells that some ant has stepped back from; global_dominated only
  std::vector<std::uint32_t> seen_;   // number of the fill that saw the cell
  std::vector<std::size_t> frontier_;
  std::uint32_t fills_ = 0;
};

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::DeadTable> =
    std::to_array<std::pair<algorithms::DeadTable, std::string_view>>({
        {algorithms::DeadTable::none, "none"},
        {algorithms::DeadTable::per_ant, "per_ant"},
        {algorithms::DeadTable::global_literal, "global_literal"},
        {algorithms::DeadTable::global_dominated, "global_dominated"},
    });
}  // namespace pathrace
