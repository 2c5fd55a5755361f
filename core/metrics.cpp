#include "core/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace pathrace {
namespace {

struct Segment {
  double dx;
  double dy;
  double length() const { return std::sqrt(dx * dx + dy * dy); }
};

// Segments between distinct neighbouring points; repeated points carry no direction.
std::vector<Segment> segments_of(const Path& path) {
  std::vector<Segment> segments;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const Segment segment{path.points[i].x - path.points[i - 1].x, path.points[i].y - path.points[i - 1].y};
    if (segment.dx != 0 || segment.dy != 0) segments.push_back(segment);
  }
  return segments;
}

// Lattice steps turn by multiples of 45 degrees: count eighths, so that the sum is exact.
int eighths_between(Segment a, Segment b) {
  const auto heading = [](Segment s) {
    static constexpr int by_step[3][3] = {{5, 6, 7}, {4, 0, 0}, {3, 2, 1}};  // [dy + 1][dx + 1]
    return by_step[static_cast<int>(s.dy) + 1][static_cast<int>(s.dx) + 1];
  };
  const int difference = (heading(a) - heading(b) + 8) % 8;
  return std::min(difference, 8 - difference);
}

void measure_lattice(const std::vector<Segment>& segments, PathMetrics& metrics) {
  LatticeLength length;
  int eighths = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const bool diagonal = segments[i].dx != 0 && segments[i].dy != 0;
    (diagonal ? length.diagonal : length.straight) += 1;
    if (i == 0) continue;
    const int turn = eighths_between(segments[i - 1], segments[i]);
    metrics.turns += turn != 0 ? 1 : 0;
    eighths += turn;
  }
  metrics.lattice = length;
  metrics.length = length.value();
  metrics.turn_angle = eighths * (std::numbers::pi / 4);
}

void measure_any_angle(const std::vector<Segment>& segments, PathMetrics& metrics) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    metrics.length += segments[i].length();
    if (i == 0) continue;
    const Segment a = segments[i - 1];
    const Segment b = segments[i];
    const double cross = a.dx * b.dy - a.dy * b.dx;
    const double dot = a.dx * b.dx + a.dy * b.dy;
    if (cross == 0 && dot > 0) continue;
    ++metrics.turns;
    metrics.turn_angle += std::fabs(std::atan2(cross, dot));
  }
}

Cell nearest_cell(Point point) {
  return {static_cast<int>(std::floor(point.x + 0.5)), static_cast<int>(std::floor(point.y + 0.5))};
}

// A point on the map's edge rounds to a cell outside; the cell beside it counts.
double clearance_at(const DistanceTransform& clearance, Cell cell) {
  return clearance.distance(
      {std::clamp(cell.x, 0, clearance.width() - 1), std::clamp(cell.y, 0, clearance.height() - 1)});
}

// The cells whose clearance counts: those of the path, and on longer segments one in every row or column
// that they cross, so that a long segment counts the cells that steps along it would.
std::vector<Cell> visited_cells(const Path& path) {
  std::vector<Cell> cells{nearest_cell(path.points.front())};
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const Point a = path.points[i - 1];
    const Point b = path.points[i];
    const int pieces =
        std::max(1, static_cast<int>(std::ceil(std::max(std::fabs(b.x - a.x), std::fabs(b.y - a.y)))));
    for (int k = 1; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      cells.push_back(k == pieces ? nearest_cell(b)
                                  : nearest_cell({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}));
    }
  }
  return cells;
}

}  // namespace

PathMetrics measure(const Path& path, const DistanceTransform& clearance) {
  PathMetrics metrics;
  const std::vector<Segment> segments = segments_of(path);
  if (path.track == Track::lattice) {
    measure_lattice(segments, metrics);
  } else {
    measure_any_angle(segments, metrics);
  }
  const std::vector<Cell> cells = visited_cells(path);
  double sum = 0;
  metrics.clearance_min = clearance_at(clearance, cells.front());
  for (const Cell cell : cells) {
    const double distance = clearance_at(clearance, cell);
    metrics.clearance_min = std::min(metrics.clearance_min, distance);
    sum += distance;
  }
  metrics.clearance_mean = sum / static_cast<double>(cells.size());
  return metrics;
}

}  // namespace pathrace
