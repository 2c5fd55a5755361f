#include "algorithms/pso/disc_world.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace pathrace::algorithms {
namespace {

using Adjacency = std::vector<std::vector<std::size_t>>;

Adjacency adjacency_of(const std::vector<Obstacle>& obstacles, double tolerance) {
  Adjacency adjacency(obstacles.size());
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    for (std::size_t j = 0; j < obstacles.size(); ++j) {
      const double reach = obstacles[i].radius + obstacles[j].radius + tolerance;
      if (i != j && separation(obstacles[i].centre, obstacles[j].centre) <= reach) adjacency[i].push_back(j);
    }
  }
  return adjacency;
}

// Visits all discs that hang together with `first` and are not yet in a group; returns their circumference.
double walk_group(const std::vector<Obstacle>& obstacles, const Adjacency& adjacency, std::size_t first,
                  std::size_t group, std::vector<std::size_t>& group_of) {
  std::vector<std::size_t> waiting{first};
  group_of[first] = group;
  double sum = 0;
  while (!waiting.empty()) {
    const std::size_t disc = waiting.back();
    waiting.pop_back();
    sum += 2 * std::numbers::pi * obstacles[disc].radius;
    for (const std::size_t next : adjacency[disc]) {
      if (group_of[next] != std::numeric_limits<std::size_t>::max()) continue;
      group_of[next] = group;
      waiting.push_back(next);
    }
  }
  return sum;
}

void find_neighbours(std::vector<Obstacle>& obstacles, const Adjacency& adjacency, std::size_t centre) {
  Obstacle& obstacle = obstacles[centre];
  std::vector<std::size_t> group_of(obstacles.size(), std::numeric_limits<std::size_t>::max());
  group_of[centre] = obstacles.size();  // taken out
  for (const std::size_t j : adjacency[centre]) {
    if (group_of[j] == std::numeric_limits<std::size_t>::max()) {
      const std::size_t group = obstacle.circumferences.size();
      obstacle.circumferences.push_back(walk_group(obstacles, adjacency, j, group, group_of));
    }
    const double dx = obstacles[j].centre.x - obstacle.centre.x;
    const double dy = obstacles[j].centre.y - obstacle.centre.y;
    obstacle.neighbours.push_back({std::atan2(dy, dx), group_of[j]});
  }
}

void find_borders(Obstacle& obstacle, double robot_radius, const Workspace& workspace, double tolerance) {
  const Point c = obstacle.centre;
  const double reach = obstacle.radius + robot_radius + tolerance;
  if (c.x + reach >= workspace.width) obstacle.border_angles.push_back(0);
  if (c.y + reach >= workspace.height) obstacle.border_angles.push_back(std::numbers::pi / 2);
  if (c.x - reach <= 0) obstacle.border_angles.push_back(std::numbers::pi);
  if (c.y - reach <= 0) obstacle.border_angles.push_back(-std::numbers::pi / 2);
}

}  // namespace

double separation(Point a, Point b) {
  const double dx = a.x - b.x;
  const double dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

double Workspace::diagonal() const {
  return std::sqrt(width * width + height * height);
}

std::vector<Obstacle> grow(std::span<const Disc> discs, double robot_radius, const Workspace& workspace,
                           double tolerance) {
  std::vector<Obstacle> obstacles;
  obstacles.reserve(discs.size());
  for (const Disc& disc : discs) {
    Obstacle obstacle;
    obstacle.centre = disc.centre;
    obstacle.radius = disc.radius + robot_radius;
    find_borders(obstacle, robot_radius, workspace, tolerance);
    obstacles.push_back(std::move(obstacle));
  }
  const Adjacency adjacency = adjacency_of(obstacles, tolerance);
  for (std::size_t i = 0; i < obstacles.size(); ++i) find_neighbours(obstacles, adjacency, i);
  return obstacles;
}

}  // namespace pathrace::algorithms
