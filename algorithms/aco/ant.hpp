// An ant: one walk from start to goal over a trail, with its own memory.
//
// The path is a stack of padded indices; `tabu_` marks every cell the ant has stood on. Marks are undone by
// walking over the list of marked cells, so a new walk costs what the old one touched, not the map.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/aco/trail.hpp"
#include "core/lattice_length.hpp"
#include "core/meter.hpp"
#include "core/names.hpp"
#include "core/stream.hpp"

namespace pathrace::algorithms {

/// What an ant does when every neighbour is on its tabu list.
enum class DeadEnd {
  die,        ///< it is discarded and deposits nothing
  backtrack,  ///< it steps back along its path until some neighbour is new; cells left that way stay tabu
  revisit_with_loop_erasure,  ///< it steps on any neighbour by eq. (1); a loop thus closed is cut off its
                              ///< path
};

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::DeadEnd> =
    std::to_array<std::pair<algorithms::DeadEnd, std::string_view>>({
        {algorithms::DeadEnd::die, "die"},
        {algorithms::DeadEnd::backtrack, "backtrack"},
        {algorithms::DeadEnd::revisit_with_loop_erasure, "revisit_with_loop_erasure"},
    });
}  // namespace pathrace

namespace pathrace::algorithms {

class Ant {
 public:
  /// What all ants of a colony share.
  struct Ground {
    const MoveTable& moves;
    const Trail& trail;
    std::size_t start;
    std::size_t goal;
    DeadEnd dead_end;
    std::uint64_t max_steps;  ///< a walk of more decisions is given up
  };

  explicit Ant(const Ground& ground);

  /// Walks until the goal, death or `step_limit` decisions. Draws one number per decision.
  void walk(Stream stream, std::uint64_t step_limit, const Meter& meter);

  bool arrived() const { return arrived_; }
  /// Decisions taken: one per step forwards, backwards or onto a visited cell.
  std::uint64_t steps() const { return steps_; }
  /// Padded indices from the start; the last is the goal when the ant arrived.
  const std::vector<std::uint32_t>& path() const { return path_; }
  LatticeLength length() const;
  /// Direction of the step that leaves the i-th cell of the path.
  int direction(std::size_t i) const;

 private:
  static constexpr std::uint64_t clock_interval = 1024;

  void begin();
  void enter(std::size_t cell);
  void back_up();
  void enter_or_erase(std::size_t cell);
  /// The roulette of eq. (1) over the neighbours that `open` admits; -1 when there are none.
  template <typename Open>
  int choose(std::size_t cell, Stream& stream, const Open& open) const;

  Ground ground_;
  std::vector<std::uint8_t> tabu_;
  std::vector<std::uint32_t> marked_;
  std::vector<std::uint32_t> path_;
  std::vector<std::uint32_t> place_;  // position on the path from 1, for loop erasure only
  std::uint64_t steps_ = 0;
  bool arrived_ = false;
};

}  // namespace pathrace::algorithms
