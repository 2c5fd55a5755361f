// The yaml file beside a ROS map's picture.
//
// Keys in any order: image (a path, relative to the yaml; ~/ is the home folder), resolution, origin
// [x, y, yaw]; and, where they differ from map_server's usual values, negate (0 or 1, false or true),
// occupied_thresh, free_thresh, mode. Other keys are passed over. http://wiki.ros.org/map_server
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scenarios/ros/map_frame.hpp"
#include "scenarios/ros/occupancy_map.hpp"

namespace pathrace::scenarios {

struct MapYaml {
  std::filesystem::path image;
  int image_line = 0;     ///< of the yaml
  double resolution = 0;  ///< metres per cell edge, above 0
  WorldPoint origin;
  double yaw = 0;
  OccupancyRule rule;

  /// Throws InputError "FILE:LINE: the value, what was expected" for what is no map's yaml; EnvironmentError
  /// when the machine refuses to read it.
  static MapYaml read(const std::filesystem::path& file);
  /// The same for a text at hand; `file` stands for its place.
  static MapYaml parse(std::string_view text, const std::filesystem::path& file);
};

/// False for the yaml of something else: a sound one without `image`, or one larger than a map's.
bool may_be_ros_map(const std::filesystem::path& file);

/// The yaml and its picture. Throws as MapYaml::read and read_image do; a picture that is not there is named
/// with the yaml's line.
OccupancyMap read_ros_map(const std::filesystem::path& file);

}  // namespace pathrace::scenarios
