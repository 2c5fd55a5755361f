// What a folder of maps offers to race on, within limits.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/grid.hpp"
#include "scenarios/left_out.hpp"

namespace pathrace::scenarios {

struct OfferLimits {
  std::size_t queries_per_map = 2;  ///< of each scen file, and of each map without one
  int max_side = 512;               ///< in cells; larger maps are left out
};

struct Offer {
  std::vector<std::string> ids;              ///< movingai/... and ros/...
  std::vector<std::filesystem::path> files;  ///< maps without queries of their own, to draw questions on
  std::vector<LeftOut> left_out;
};

/// Whether a map is larger than the limits; adds it to `left_out` if so.
bool is_too_large(const std::filesystem::path& file, const OccupancyGrid& grid, const OfferLimits& limits,
                  std::vector<LeftOut>& left_out);

/// Adds the maps below the folder that are neither ROS yaml files nor in `known`: .map files, pictures that
/// no yaml names, text grids. Files of one folder that differ in the extension alone are one map; the first
/// in the order of map_extensions() counts. Throws EnvironmentError when the folder cannot be listed.
void offer_map_files(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& known,
                     const OfferLimits& limits, Offer& offer);

}  // namespace pathrace::scenarios
