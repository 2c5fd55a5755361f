#include "algorithms/aco/tan/preplanned_path.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/checkpoint.hpp"

namespace pathrace::algorithms {
namespace {

constexpr double on_the_line = 1e-9;

// The segment from the newest start to the goal, with s as origin.
class Reference {
 public:
  Reference(Point s, Point goal) : s_(s), dx_(goal.x - s.x), dy_(goal.y - s.y) {}

  // |s - goal| times the signed distance from the line: its sign is the side.
  double side(Point p) const { return dx_ * (p.y - s_.y) - dy_ * (p.x - s_.x); }
  // |s - goal| times the way along the line.
  double along(Point p) const { return dx_ * (p.x - s_.x) + dy_ * (p.y - s_.y); }
  double squared_length() const { return dx_ * dx_ + dy_ * dy_; }
  bool between(Point p) const { return along(p) > 0 && along(p) < squared_length(); }
  // Grows with the angle between the directions to p and to the goal, for p in front of s.
  double bend(Point p) const { return std::fabs(side(p)) / along(p); }
  double squared_distance_from_start(Point p) const {
    return (p.x - s_.x) * (p.x - s_.x) + (p.y - s_.y) * (p.y - s_.y);
  }
  bool within(Point p, double radius) const { return side(p) * side(p) < radius * radius * squared_length(); }
  bool passes_through(Point p) const {
    return std::fabs(side(p)) <= on_the_line * std::sqrt(squared_length());
  }

 private:
  Point s_;
  double dx_;
  double dy_;
};

bool meets(const CircleSet& set, const Reference& line) {
  bool left = false;
  bool right = false;
  for (const Circle& circle : set) {
    if (!line.between(circle.centre)) continue;
    if (line.passes_through(circle.centre) || line.within(circle.centre, circle.radius)) return true;
    (line.side(circle.centre) > 0 ? left : right) = true;
  }
  return left && right;
}

double nearness(const CircleSet& set, const Reference& line) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Circle& circle : set) {
    if (!line.between(circle.centre)) continue;
    nearest = std::min(nearest, line.squared_distance_from_start(circle.centre));
  }
  return nearest;
}

Point straightest_centre(const CircleSet& set, const Reference& line) {
  Point best{};
  double least = std::numeric_limits<double>::infinity();
  for (const Circle& circle : set) {
    if (!line.between(circle.centre) || line.bend(circle.centre) >= least) continue;
    least = line.bend(circle.centre);
    best = circle.centre;
  }
  return best;
}

std::optional<std::size_t> nearest_in_the_way(const std::vector<CircleSet>& sets,
                                              const std::vector<std::uint8_t>& used, const Reference& line) {
  std::optional<std::size_t> found;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (used[i] != 0 || !meets(sets[i], line)) continue;
    const double distance = nearness(sets[i], line);
    if (distance >= nearest) continue;
    nearest = distance;
    found = i;
  }
  return found;
}

}  // namespace

std::vector<Point> preplanned_path(Point start, Point goal, const std::vector<CircleSet>& sets) {
  std::vector<Point> path{start};
  std::vector<std::uint8_t> used(sets.size(), 0);
  while (true) {
    const Reference line(path.back(), goal);
    const std::optional<std::size_t> next = nearest_in_the_way(sets, used, line);
    if (!next) break;
    checkpoint();
    used[*next] = 1;
    path.push_back(straightest_centre(sets[*next], line));
  }
  path.push_back(goal);
  return path;
}

}  // namespace pathrace::algorithms
