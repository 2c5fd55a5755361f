// Maps for tests: drawn by hand, drawn at random, and small classics whose optima are known.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/cell.hpp"
#include "core/grid.hpp"
#include "core/lattice_length.hpp"
#include "core/move_rule.hpp"
#include "core/scenario.hpp"
#include "core/stream.hpp"

namespace pathrace::testing {

inline constexpr MoveRule all_rules[] = {MoveRule::four, MoveRule::strict, MoveRule::squeeze, MoveRule::free};

/// A grid from its rows: '#' and '1' are blocked, '.' and '0' are free. Throws std::invalid_argument on
/// anything else and on rows of different lengths.
OccupancyGrid grid_of(const std::vector<std::string>& rows);

Terrain terrain_of(const OccupancyGrid& grid, MoveRule rule = MoveRule::strict);

/// Each cell is blocked with this probability.
OccupancyGrid random_grid(Stream stream, int width, int height, double density);

std::vector<Cell> free_cells_of(const OccupancyGrid& grid);

/// A question on a map.
struct Question {
  OccupancyGrid grid;
  Cell start;
  Cell goal;
};

/// A random map of 1 to `max_side` cells a side, with up to `max_density` blocked, and two of its free cells.
Question random_question(Stream stream, int max_side, double max_density = 0.5);

Cell mirrored(const OccupancyGrid& grid, Cell cell);  ///< left and right swapped
Cell transposed(Cell cell);                           ///< rows and columns swapped
Question mirrored(const Question& question);
Question transposed(const Question& question);

/// A map of the library with the optimum that its source states for each rule.
struct ReferenceMap {
  std::string name;  ///< its id
  Cell start;
  Cell goal;
  LatticeLength free;
  LatticeLength squeeze;
  LatticeLength strict;
  LatticeLength four;
  std::vector<std::string> rows;

  LatticeLength optimum(MoveRule rule) const;
};

/// The three 5x5 maps of the AS-R robot's paper and nine traps.
const std::vector<ReferenceMap>& reference_maps();

}  // namespace pathrace::testing
