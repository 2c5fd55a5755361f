#include "algorithms/aco/tan/gaussian_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/checkpoint.hpp"

namespace pathrace::algorithms {
namespace {

double squared_distance(Point p, Point a, Point b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared_length = dx * dx + dy * dy;
  double t = 0;
  if (squared_length > 0) t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared_length, 0.0, 1.0);
  const double ex = p.x - (a.x + t * dx);
  const double ey = p.y - (a.y + t * dy);
  return ex * ex + ey * ey;
}

// Lowers the squared distances of the cells that the ridge along one segment can reach.
void approach(const OccupancyGrid& grid, Point a, Point b, double reach, std::vector<double>& squared) {
  const auto first = [reach](double p, double q) {
    return std::max(0, static_cast<int>(std::floor(std::min(p, q) - reach)));
  };
  const auto last = [reach](double p, double q, int side) {
    return std::min(side - 1, static_cast<int>(std::ceil(std::max(p, q) + reach)));
  };
  for (int y = first(a.y, b.y); y <= last(a.y, b.y, grid.height()); ++y) {
    checkpoint();
    for (int x = first(a.x, b.x); x <= last(a.x, b.x, grid.width()); ++x) {
      double& least = squared[grid.index({x, y})];
      least = std::min(least, squared_distance(centre({x, y}), a, b));
    }
  }
}

}  // namespace

std::vector<double> gaussian_field(const OccupancyGrid& grid, const std::vector<Point>& polyline,
                                   const GaussianField& field) {
  constexpr double cut = 3;
  const double reach = cut * field.sigma;
  auto squared =
      filled_gradually<std::vector<double>>(grid.padded_size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < polyline.size(); ++i) {
    approach(grid, polyline[i == 0 ? 0 : i - 1], polyline[i], reach, squared);
  }
  auto values = filled_gradually<std::vector<double>>(grid.padded_size(), field.base);
  Pace pace;
  for (std::size_t index = 0; index < values.size(); ++index) {
    pace.step();
    if (grid.blocked_at(index) || squared[index] > reach * reach) continue;
    values[index] += field.amplitude * std::exp(-squared[index] / (2 * field.sigma * field.sigma));
  }
  return values;
}

}  // namespace pathrace::algorithms
