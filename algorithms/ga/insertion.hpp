// The insertion operator: gaps between genes are filled with free cells, one step at a time.
//
// At each step there are three directions, and a middle one of them. When all three are legal, the middle one
// is taken; when none is, the insertion has failed and the individual is deleted; of one or two, the one that
// ends nearest to the next gene, ties at random [I]. The three directions are
//   faithful  right, lower right and down, as published, but never past the row or column of the next gene
//             [I]; a gene that lies up or to the left, or that these steps cannot reach, is dropped [I]
//   blind     right, lower right and down wherever the next gene is; a gene that is passed is dropped [I]
//   general   the one towards the next gene and those on either side of it
// Neighbours whose step is legal are no gap. Loops are cut as they appear (see loop_free_path.hpp), which
// gives the same path as cutting them afterwards.
//
// With `general`, a detour can lead out where all three directions are blocked; a gene that it does not get
// nearer to is dropped. Every way ends: each step comes nearer to the gene (straight distance), each detour
// too.
//
// Xie, Yu, 2010, section 2.4. Tags as in algorithms.md: [I] is a reconstruction.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

#include "algorithms/ga/detour.hpp"
#include "algorithms/ga/gene_map.hpp"
#include "algorithms/ga/loop_free_path.hpp"
#include "core/meter.hpp"
#include "core/names.hpp"
#include "core/stream.hpp"

namespace pathrace::algorithms {

enum class Insertion { faithful, blind, general };
enum class GapRepair { none, local_search };

/// Three directions, or fewer; none when the rule cannot get to the gene.
struct Fan {
  unsigned directions = 0;  ///< bit d stands for direction d
  int middle = -1;

  friend bool operator==(const Fan&, const Fan&) = default;
};

/// For a step from `from` towards another cell.
Fan fan_towards(Insertion rule, Cell from, Cell to);

/// Not for use by two threads at once.
class Inserter {
 public:
  /// `reach`: most cells that a detour expands.
  Inserter(const GeneMap& map, Insertion rule, GapRepair repair, std::size_t reach);

  enum class Outcome {
    filled,   ///< the path runs from the first gene to the last without a gap
    deleted,  ///< no way on
    cut,      ///< the limit on checks, or on time, was met
  };

  /// Writes the genes with their gaps filled into an opened, empty path. One check per step and per cell that
  /// a detour expands, at most `limit`; the clock is looked at now and then.
  Outcome fill(std::span<const Gene> genes, std::uint64_t limit, const Meter& clock, Stream& stream,
               LoopFreePath& path);
  /// Of the last fill.
  std::uint64_t checks() const { return checks_; }
  std::uint64_t detours() const { return detours_; }

 private:
  enum class Way { arrived, out_of_reach, failed, cut };

  static constexpr std::uint64_t clock_interval = 4096;  // checks

  Way walk(Gene target, Stream& stream, LoopFreePath& path);
  Way blocked(Gene from, Gene target, Stream& stream, LoopFreePath& path);

  const GeneMap& map_;
  Insertion rule_;
  GapRepair repair_;
  Detour detour_;
  std::uint64_t limit_ = 0;
  std::uint64_t checks_ = 0;
  std::uint64_t detours_ = 0;
};

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::Insertion> =
    std::to_array<std::pair<algorithms::Insertion, std::string_view>>({
        {algorithms::Insertion::faithful, "faithful"},
        {algorithms::Insertion::blind, "blind"},
        {algorithms::Insertion::general, "general"},
    });
template <>
inline constexpr auto names_of<algorithms::GapRepair> =
    std::to_array<std::pair<algorithms::GapRepair, std::string_view>>({
        {algorithms::GapRepair::none, "none"},
        {algorithms::GapRepair::local_search, "local_search"},
    });
}  // namespace pathrace
