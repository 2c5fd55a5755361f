// A MovingAI map: the `.map` files of the grid benchmarks.
//
// Four header lines (`type octile`, `height H`, `width W` in any order, then `map`) and H rows of W
// characters, the upper left cell first; blanks at a row's end are passed over. `.`, `G` and `S` are ground,
// `@`, `O` and `T` are always blocked, and `W` is water: free only for a query that starts and ends in water,
// so a map is two grids in one.
//
// N. Sturtevant, "Benchmarks for Grid-Based Pathfinding", IEEE Trans. Computational Intelligence and AI in
// Games 4(2), 2012; https://movingai.com/benchmarks/formats.html
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/cell.hpp"
#include "core/grid.hpp"

namespace pathrace::scenarios {

/// A parsed `.map` file; cheap to copy.
class MapFile {
 public:
  /// Throws InputError "FILE:LINE: the value, what was expected" when the file is not a map, is missing
  /// ("FILE: no such file"), or holds far more than its header accounts for (before reading the rest);
  /// EnvironmentError when the machine refuses to read it.
  static MapFile read(const std::filesystem::path& file);
  /// The same for a text at hand; `name` stands for the file in messages.
  static MapFile parse(std::string_view text, const std::string& name);

  int width() const { return ground_->width(); }
  int height() const { return ground_->height(); }
  /// Ground is free, water and everything else is blocked.
  std::shared_ptr<const OccupancyGrid> ground() const { return ground_; }
  /// Water is free, ground and everything else is blocked.
  std::shared_ptr<const OccupancyGrid> water() const { return water_; }
  /// False for a cell outside the map.
  bool is_water(Cell cell) const { return water_->is_free(cell); }
  /// The grid for a query: water when both ends are water, else ground.
  std::shared_ptr<const OccupancyGrid> grid_for(Cell start, Cell goal) const;

 private:
  MapFile(std::shared_ptr<const OccupancyGrid> ground, std::shared_ptr<const OccupancyGrid> water);

  std::shared_ptr<const OccupancyGrid> ground_;
  std::shared_ptr<const OccupancyGrid> water_;
};

}  // namespace pathrace::scenarios
