// A grid as a ROS map: a yaml file and its picture.
#pragma once

#include <ostream>
#include <string>

#include "core/grid.hpp"
#include "scenarios/ros/map_frame.hpp"

namespace pathrace::scenarios {

/// A PGM, free cells 254 and blocked ones 0, as map_saver writes them. Throws EnvironmentError when the
/// stream fails.
void write_pgm(std::ostream& out, const OccupancyGrid& grid);

/// The yaml of a picture beside it, with map_server's usual thresholds. Throws EnvironmentError when the
/// stream fails.
void write_map_yaml(std::ostream& out, const std::string& picture, const MapFrame& frame);

}  // namespace pathrace::scenarios
