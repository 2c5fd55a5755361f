#include "scenarios/map_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "scenarios/image/image_file.hpp"
#include "scenarios/inflate.hpp"
#include "scenarios/movingai/map_file.hpp"
#include "scenarios/ros/map_yaml.hpp"
#include "scenarios/text.hpp"
#include "scenarios/text_grid.hpp"

namespace pathrace::scenarios {
namespace {

namespace fs = std::filesystem;
using Grid = std::shared_ptr<const OccupancyGrid>;

Grid shared(OccupancyGrid grid) {
  return std::make_shared<const OccupancyGrid>(std::move(grid));
}

Grid grown(const Grid& grid, double cells) {
  return grid == nullptr || cells == 0 ? grid : shared(inflated(*grid, cells));
}

MapFrame plain_frame(int width, int height, const MapOptions& options) {
  return {width, height, options.resolution.value_or(1), {}, 0};
}

GridMap map_of(const OccupancyMap& map, const MapOptions& options) {
  GridMap result;
  result.grid = shared(map.grid(options.unknown));
  result.frame = map.frame();
  result.measured = options.resolution.has_value();
  result.unknown_cells = map.unknown_cells();
  return result;
}

GridMap map_of(Grid grid, Grid water, const MapOptions& options) {
  GridMap result;
  result.frame = plain_frame(grid->width(), grid->height(), options);
  result.grid = std::move(grid);
  result.water = std::move(water);
  result.measured = options.resolution.has_value();
  return result;
}

GridMap read_movingai(const fs::path& file, const MapOptions& options) {
  const MapFile map = MapFile::read(file);
  return map_of(map.ground(), map.water(), options);
}

GridMap read_yaml(const fs::path& file, const MapOptions& options) {
  if (options.resolution) {
    fail_in(file.string(),
            fmt::format("says its resolution itself; expected none beside it, got {}", *options.resolution));
  }
  GridMap map = map_of(read_ros_map(file), options);
  map.measured = true;
  return map;
}

GridMap read_picture(const fs::path& file, const MapOptions& options) {
  const GreyImage image = read_image(file);
  return map_of(OccupancyMap(image, {}, plain_frame(image.width, image.height, options)), options);
}

GridMap read_digits(const fs::path& file, const MapOptions& options) {
  return map_of(shared(read_text_grid(file)), nullptr, options);
}

struct Kind {
  std::string extension;
  GridMap (*read)(const fs::path&, const MapOptions&);
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {".map", read_movingai}, {".yaml", read_yaml},   {".yml", read_yaml},    {".pgm", read_picture},
      {".ppm", read_picture},  {".pbm", read_picture}, {".png", read_picture}, {".bmp", read_picture},
      {".csv", read_digits},   {".txt", read_digits},
  };
  return all;
}

void require_sound(const MapOptions& options) {
  if (options.resolution && !(*options.resolution > 0 && std::isfinite(*options.resolution))) {
    throw InputError(
        fmt::format("a resolution of {}; expected metres per cell, above 0", *options.resolution));
  }
  if (!(options.radius >= 0 && std::isfinite(options.radius))) {
    throw InputError(fmt::format("a radius of {}; expected metres, at least 0", options.radius));
  }
}

}  // namespace

Grid GridMap::grid_for(Cell start, Cell goal) const {
  return water != nullptr && water->is_free(start) && water->is_free(goal) ? water : grid;
}

GridMap read_map(const fs::path& file, const MapOptions& options) {
  require_sound(options);
  const std::string extension = file.extension().string();
  const auto kind = std::find_if(kinds().begin(), kinds().end(),
                                 [&](const Kind& known) { return known.extension == extension; });
  if (kind == kinds().end()) {
    fail_in(file.string(), fmt::format("the extension '{}' is of no map; expected one of {}",
                                       printable(extension), fmt::join(map_extensions(), " ")));
  }
  GridMap map = kind->read(file, options);
  const double cells = options.radius / map.frame.resolution;
  map.drawn = map.grid;
  map.grid = grown(map.grid, cells);
  map.water = grown(map.water, cells);
  return map;
}

const std::vector<std::string>& map_extensions() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> extensions;
    for (const Kind& kind : kinds()) extensions.push_back(kind.extension);
    return extensions;
  }();
  return all;
}

}  // namespace pathrace::scenarios
