// Questions on a map file of one's own: between two places given in cells or in metres, or drawn from a seed.
//
// Ids: `map/<name>/<start>/<goal>` in cells, such as map/office,radius=0.2/3,4/20,7. The name is the file's
// without extension, followed by what was said about the map beyond the defaults: radius, resolution,
// unknown. It is read as the file is now; the content hash of a trial's key holds the map itself.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/scenario.hpp"
#include "scenarios/map_reader.hpp"

namespace pathrace::scenarios {

/// A place on the map as it was asked for, and the cell that holds it.
struct MapPlace {
  std::string asked;  ///< "3,4" or "20 m, 20 m (cell 200,325)"
  Cell cell;
  Point point;  ///< in cell edges
};

class MapQuestions {
 public:
  /// Reads the map; throws as read_map does. `name` stands for the file's in ids.
  MapQuestions(std::filesystem::path file, const MapOptions& options, std::string_view name = "");

  const GridMap& map() const { return map_; }
  const MapFrame& frame() const { return map_.frame; }

  MapPlace at(Cell cell) const;
  /// Throws InputError for a place off the map.
  MapPlace at(WorldPoint place) const;

  /// A question under the rule `strict`, valid. Throws InvalidScenario that names the place and the free cell
  /// nearest to it when an end is blocked, by the map or by the robot's radius, or lies off the map.
  Scenario between(const MapPlace& start, const MapPlace& goal) const;

  /// Up to `count` different questions with a proven optimum. Start: uniform in the largest region. Goal:
  /// uniform among the cells at half the greatest distance from there or more. Fewer only on maps that hardly
  /// have as many. Throws InvalidScenario when the largest region has fewer than two cells.
  std::vector<Scenario> draw(std::uint64_t count, std::uint64_t seed, MoveRule rule) const;

 private:
  void require_free(std::string_view what, const MapPlace& place, const OccupancyGrid& grid) const;

  std::filesystem::path file_;
  GridMap map_;
  std::string prefix_;  // of ids
};

}  // namespace pathrace::scenarios
