#include "algorithms/aco/tan/enclosing_circle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace pathrace::algorithms {
namespace {

double cross(Point o, Point a, Point b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

double squared_distance(Point a, Point b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

// A circle under construction keeps its squared radius; a point within rounding of the border is inside.
struct Disc {
  Point centre;
  double squared_radius;

  bool holds(Point p) const {
    constexpr double slack = 1 + 1e-12;
    return squared_distance(centre, p) <= squared_radius * slack;
  }
};

Disc around(Point a, Point b) {
  const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
  return {middle, std::max(squared_distance(middle, a), squared_distance(middle, b))};
}

// The circle through three points; on a line, the circle around the two that are farthest apart.
Disc through(Point a, Point b, Point c) {
  const double bx = b.x - a.x;
  const double by = b.y - a.y;
  const double cx = c.x - a.x;
  const double cy = c.y - a.y;
  const double twice_area = 2 * (bx * cy - by * cx);
  if (twice_area == 0) {
    const Disc discs[] = {around(a, b), around(a, c), around(b, c)};
    return *std::max_element(std::begin(discs), std::end(discs), [](const Disc& p, const Disc& q) {
      return p.squared_radius < q.squared_radius;
    });
  }
  const double b2 = bx * bx + by * by;
  const double c2 = cx * cx + cy * cy;
  const Point centre{a.x + (cy * b2 - by * c2) / twice_area, a.y + (bx * c2 - cx * b2) / twice_area};
  return {centre,
          std::max({squared_distance(centre, a), squared_distance(centre, b), squared_distance(centre, c)})};
}

// The smallest disc of the points with p and q on its border.
Disc with_two(std::span<const Point> points, Point p, Point q) {
  Disc disc = around(p, q);
  for (const Point point : points) {
    if (!disc.holds(point)) disc = through(p, q, point);
  }
  return disc;
}

Disc with_one(std::span<const Point> points, Point p) {
  Disc disc{p, 0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!disc.holds(points[i])) disc = with_two(points.first(i), p, points[i]);
  }
  return disc;
}

}  // namespace

std::vector<Point> convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point> hull;
  const auto add_chain = [&hull](auto begin, auto end) {
    const std::size_t base = hull.size();
    for (auto point = begin; point != end; ++point) {
      while (hull.size() >= base + 2 && cross(hull[hull.size() - 2], hull.back(), *point) <= 0)
        hull.pop_back();
      hull.push_back(*point);
    }
    hull.pop_back();  // the first of the other chain
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

Circle smallest_enclosing_circle(std::vector<Point> points, Stream order) {
  points = convex_hull(std::move(points));
  order.shuffle(points);
  Disc disc{points.front(), 0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!disc.holds(points[i])) disc = with_one(std::span(points).first(i), points[i]);
  }
  double farthest = 0;
  for (const Point point : points) farthest = std::max(farthest, squared_distance(disc.centre, point));
  return {disc.centre, std::sqrt(farthest)};
}

}  // namespace pathrace::algorithms
