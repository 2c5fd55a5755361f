#include "scenarios/ros/writer.hpp"

#include <fmt/format.h>

#include <string_view>

#include "core/error.hpp"
#include "scenarios/ros/occupancy_map.hpp"

namespace pathrace::scenarios {
namespace {

// In single quotes, where a quote is written twice.
std::string quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

void require_written(const std::ostream& out, std::string_view what) {
  if (!out) throw EnvironmentError(fmt::format("the {} could not be written", what));
}

}  // namespace

void write_pgm(std::ostream& out, const OccupancyGrid& grid) {
  out << fmt::format("P5\n{} {}\n255\n", grid.width(), grid.height());
  std::string row(static_cast<std::size_t>(grid.width()), '\0');
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      row[static_cast<std::size_t>(x)] = grid.is_free({x, y}) ? static_cast<char>(254) : '\0';
    }
    out << row;
  }
  require_written(out, "picture");
}

void write_map_yaml(std::ostream& out, const std::string& picture, const MapFrame& frame) {
  const OccupancyRule rule;
  out << fmt::format(
      "image: {}\nresolution: {}\norigin: [{}, {}, {}]\nnegate: 0\noccupied_thresh: {}\nfree_thresh: {}\n",
      quoted(picture), frame.resolution, frame.origin.x, frame.origin.y, frame.yaw, rule.occupied_thresh,
      rule.free_thresh);
  require_written(out, "yaml");
}

}  // namespace pathrace::scenarios
