#include "baselines/navigators/disc_map.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/world.hpp"

namespace pathrace::baselines {
namespace {

int cells_across(double length, double resolution) {
  return std::max(1, static_cast<int>(std::ceil(length / resolution)));
}

// Cells whose centres lie in first..last along one axis.
std::pair<int, int> span(double first, double last, double resolution, int cells) {
  const int from = static_cast<int>(std::floor(first / resolution - 0.5));
  const int to = static_cast<int>(std::ceil(last / resolution - 0.5));
  return {std::max(from, 0), std::min(to, cells - 1)};
}

}  // namespace

DiscMap::DiscMap(const Snapshot& snapshot, double resolution, double margin)
    : resolution_(resolution),
      width_(cells_across(snapshot.width, resolution)),
      height_(cells_across(snapshot.height, resolution)) {
  OccupancyGrid grid(width_, height_);
  const auto block_if = [&](Cell cell, const auto& is_barred) {
    if (is_barred(place_of(centre(cell)))) grid.block(cell);
  };
  const double radius = snapshot.robot_radius;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      block_if({x, y}, [&](Point p) {
        return p.x < radius || p.y < radius || p.x > snapshot.width - radius ||
               p.y > snapshot.height - radius;
      });
    }
  }
  for (const Disc& disc : snapshot.discs) {
    const double reach = disc.radius + radius + margin * resolution;
    const auto [left, right] = span(disc.centre.x - reach, disc.centre.x + reach, resolution, grid.width());
    const auto [top, bottom] = span(disc.centre.y - reach, disc.centre.y + reach, resolution, grid.height());
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        block_if({x, y}, [&](Point p) { return straight_line(p, disc.centre) < reach; });
      }
    }
  }
  grid.clear(cell_of(snapshot.robot));
  grid.clear(cell_of(snapshot.goal));
  terrain_ = {std::make_shared<const OccupancyGrid>(std::move(grid)), MoveRule::strict};
}

Cell DiscMap::cell_of(Point point) const {
  const auto index = [this](double at, int cells) {
    return std::clamp(static_cast<int>(std::floor(at / resolution_)), 0, cells - 1);
  };
  return {index(point.x, width_), index(point.y, height_)};
}

Point DiscMap::place_of(Point cells) const {
  return {(cells.x + 0.5) * resolution_, (cells.y + 0.5) * resolution_};
}

}  // namespace pathrace::baselines
