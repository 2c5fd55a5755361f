// One door for every kind of map file; the extension says which kind.
//
//   .map               MovingAI
//   .yaml .yml         ROS, with the picture that it names
//   .pgm .ppm .pbm .png .bmp  a picture alone: dark is blocked, by map_server's usual thresholds
//   .csv .txt          rows of 0 and 1
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "scenarios/ros/map_frame.hpp"
#include "scenarios/ros/occupancy_map.hpp"

namespace pathrace::scenarios {

struct MapOptions {
  UnknownPolicy unknown = UnknownPolicy::blocked;  ///< for yaml and pictures
  double radius = 0;                               ///< of the robot, metres, at least 0
  std::optional<double> resolution;  ///< metres per cell edge, for files that do not say; 1 when not given
};

struct GridMap {
  std::shared_ptr<const OccupancyGrid> grid;   ///< ground, of a .map; obstacles grown by the radius
  std::shared_ptr<const OccupancyGrid> water;  ///< of a .map only: water is free, all else blocked
  MapFrame frame;                              ///< origin 0,0 without yaw where the file does not say
  bool measured = false;  ///< a cell's metres are known: from the file or from a given resolution
  std::optional<std::int64_t> unknown_cells;   ///< of yaml and pictures
  std::shared_ptr<const OccupancyGrid> drawn;  ///< `grid` before obstacles grew

  /// Water when both ends lie in it, else the grid.
  std::shared_ptr<const OccupancyGrid> grid_for(Cell start, Cell goal) const;
};

/// Throws InputError for another extension (the message lists the known ones), for what the file's reader
/// refuses, for a resolution that is not above 0 or given beside a yaml, and for a radius below 0.
GridMap read_map(const std::filesystem::path& file, const MapOptions& options = {});

/// ".map", ".yaml", ...
const std::vector<std::string>& map_extensions();

}  // namespace pathrace::scenarios
