#include "baselines/ompl/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pathrace::baselines {
namespace {

constexpr double margin = FreeSpace::margin;

// The padded column or row that a coordinate lies in; coordinates are above -1.5, where the cut is the floor.
int padded(double coordinate) {
  return static_cast<int>(coordinate + 1.5);
}

double centre_of(int padded_coordinate) {
  return padded_coordinate - 1;
}

// A segment seen along its longer axis. `ahead` is that axis, `aside` the other one.
struct Course {
  double ahead;
  double ahead_end;
  double aside;
  double slope;  // aside per ahead, in -1..1
  std::size_t ahead_stride;
  std::size_t aside_stride;

  double aside_at(double place) const { return aside + slope * (place - ahead); }
  double direction() const { return ahead_end < ahead ? -1 : 1; }
};

Course course(Point from, Point to, std::size_t stride) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  if (std::fabs(dx) >= std::fabs(dy)) return {from.x, to.x, from.y, dx == 0 ? 0 : dy / dx, 1, stride};
  return {from.y, to.y, from.x, dx / dy, stride, 1};
}

// Calls visit(ahead, aside) for each padded cell whose grown square the segment may meet, in the order of the
// journey, until it returns false.
template <typename Visit>
void travel(const Course& c, const Visit& visit) {
  const bool forward = c.ahead_end >= c.ahead;
  const double low = std::min(c.ahead, c.ahead_end);
  const double high = std::max(c.ahead, c.ahead_end);
  const double sign = forward ? margin : -margin;
  const int step = forward ? 1 : -1;
  const int last = padded(c.ahead_end + sign);
  for (int column = padded(c.ahead - sign);; column += step) {
    const double left = std::max(low, centre_of(column) - 0.5 - margin);
    const double right = std::min(high, centre_of(column) + 0.5 + margin);
    const double in = c.aside_at(forward ? left : right);
    const double out = c.aside_at(forward ? right : left);
    const int row_step = out >= in ? 1 : -1;
    const double row_sign = row_step * margin;
    const int last_row = padded(out + row_sign);
    for (int row = padded(in - row_sign);; row += row_step) {
      if (!visit(column, row)) return;
      if (row == last_row) break;
    }
    if (column == last) return;
  }
}

// Where a segment, from 0 to 1, comes near the square of a cell grown by twice the margin.
double entry(const Course& c, int column, int row) {
  const double half = 0.5 + 2 * margin;
  const auto enters = [half](double begin, double way, double centre) {
    if (way == 0) return 0.0;
    return (centre - (way > 0 ? half : -half) - begin) / way;
  };
  const double way = c.ahead_end - c.ahead;
  return std::max(enters(c.ahead, way, centre_of(column)), enters(c.aside, way * c.slope, centre_of(row)));
}

Point between(Point from, Point to, double fraction) {
  return {from.x + (to.x - from.x) * fraction, from.y + (to.y - from.y) * fraction};
}

}  // namespace

FreeSpace::FreeSpace(const OccupancyGrid& grid) : grid_(grid) {}

FreeSpace::Look FreeSpace::at(Point point, std::uint64_t limit) const {
  Look look;
  if (!inside(point)) return look;
  const int right = padded(point.x + margin);
  const int bottom = padded(point.y + margin);
  for (int row = padded(point.y - margin); row <= bottom; ++row) {
    for (int column = padded(point.x - margin); column <= right; ++column) {
      if (look.cells == limit) return look;
      ++look.cells;
      const std::size_t index =
          static_cast<std::size_t>(row) * grid_.stride() + static_cast<std::size_t>(column);
      if (grid_.blocked_at(index)) return look;
    }
  }
  look.free = true;
  return look;
}

FreeSpace::Look FreeSpace::along(Point from, Point to, std::uint64_t limit) const {
  Look look;
  if (!inside(from) || !inside(to)) return look;
  const Course c = course(from, to, grid_.stride());
  bool free = true;
  travel(c, [&](int ahead, int aside) {
    if (look.cells == limit) return free = false;
    ++look.cells;
    const std::size_t index =
        static_cast<std::size_t>(ahead) * c.ahead_stride + static_cast<std::size_t>(aside) * c.aside_stride;
    return free = !grid_.blocked_at(index);
  });
  look.free = free;
  return look;
}

double FreeSpace::reach(Point from, Point to) const {
  if (!inside(from) || !inside(to)) return 0;
  const Course c = course(from, to, grid_.stride());
  double fraction = 1;
  travel(c, [&](int ahead, int aside) {
    const std::size_t index =
        static_cast<std::size_t>(ahead) * c.ahead_stride + static_cast<std::size_t>(aside) * c.aside_stride;
    if (!grid_.blocked_at(index)) return true;
    fraction = entry(c, ahead, aside);
    return false;
  });
  // Near a corner another square may come first by a hair; a step back settles it.
  const double step = 1e-6 / std::fabs(c.ahead_end - c.ahead);
  constexpr auto unlimited = std::numeric_limits<std::uint64_t>::max();
  for (const double candidate : {fraction, fraction - step}) {
    if (candidate > 0 && candidate < 1 && along(from, between(from, to, candidate), unlimited).free) {
      return candidate;
    }
  }
  return 0;
}

}  // namespace pathrace::baselines
