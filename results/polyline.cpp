#include "results/polyline.hpp"

#include <cmath>

namespace pathrace::results {
namespace {

bool straight_on(Point a, Point b, Point c) {
  const double cross = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
  const double dot = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
  return cross == 0 && dot > 0;
}

}  // namespace

std::vector<Point> corners_of(const std::vector<Point>& points) {
  std::vector<Point> corners;
  for (const Point point : points) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
    const std::size_t n = corners.size();
    if (n >= 2 && straight_on(corners[n - 2], corners[n - 1], point)) corners.pop_back();
    corners.push_back(point);
  }
  return corners;
}

double polyline_length(const std::vector<Point>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
  }
  return length;
}

}  // namespace pathrace::results
