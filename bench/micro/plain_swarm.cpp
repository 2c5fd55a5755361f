#include "bench/micro/plain_swarm.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pathrace::bench::micro {
namespace {

int walls_on(const OccupancyGrid& grid, Point from, Point to) {
  int x = static_cast<int>(std::floor(from.x + 0.5));
  int y = static_cast<int>(std::floor(from.y + 0.5));
  const int last_x = static_cast<int>(std::floor(to.x + 0.5));
  const int last_y = static_cast<int>(std::floor(to.y + 0.5));
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const int step_x = dx > 0 ? 1 : -1;
  const int step_y = dy > 0 ? 1 : -1;
  double next_x = (x + 0.5 * step_x - from.x) / dx;
  double next_y = (y + 0.5 * step_y - from.y) / dy;
  int walls = grid.is_free({x, y}) ? 0 : 1;
  const int steps = std::abs(last_x - x) + std::abs(last_y - y);
  for (int k = 0; k < steps; ++k) {
    const bool along_x = y == last_y || (x != last_x && next_x < next_y);
    if (along_x) {
      x += step_x;
      next_x += step_x / dx;
    } else {
      y += step_y;
      next_y += step_y / dy;
    }
    walls += grid.is_free({x, y}) ? 0 : 1;
  }
  return walls;
}

}  // namespace

PlainVerdict plain_judge(const OccupancyGrid& grid, const std::vector<Point>& polyline) {
  PlainVerdict verdict;
  for (std::size_t k = 1; k < polyline.size(); ++k) {
    verdict.length += std::hypot(polyline[k].x - polyline[k - 1].x, polyline[k].y - polyline[k - 1].y);
    verdict.walls += walls_on(grid, polyline[k - 1], polyline[k]);
  }
  return verdict;
}

PlainSwarm::PlainSwarm(const Problem& problem, std::size_t particles, std::size_t waypoints, Stream stream)
    : problem_(problem), penalty_(problem.grid.width() + problem.grid.height()), particles_(particles) {
  const double right = problem.grid.width() - 1;
  const double bottom = problem.grid.height() - 1;
  for (Particle& particle : particles_) {
    particle.position.push_back(centre(problem.start));
    for (std::size_t k = 0; k < waypoints; ++k) {
      particle.position.push_back({right * stream.uniform(), bottom * stream.uniform()});
    }
    particle.position.push_back(centre(problem.goal));
    particle.velocity.resize(waypoints + 2);
    particle.best_cost = std::numeric_limits<double>::infinity();
    judge(particle);
  }
}

void PlainSwarm::judge(Particle& particle) const {
  const PlainVerdict verdict = plain_judge(problem_.grid, particle.position);
  const double cost = verdict.length + penalty_ * verdict.walls;
  if (cost >= particle.best_cost) return;
  particle.best_cost = cost;
  particle.best = particle.position;
}

const PlainSwarm::Particle& PlainSwarm::guide_of(std::size_t i) const {
  const std::size_t count = particles_.size();
  const Particle* guide = &particles_[i];
  for (const std::size_t other : {(i + count - 1) % count, (i + 1) % count}) {
    if (particles_[other].best_cost < guide->best_cost) guide = &particles_[other];
  }
  return *guide;
}

void PlainSwarm::iterate(Stream stream) {
  constexpr double chi = 0.7298;
  constexpr double c = 2.05;
  const double right = problem_.grid.width() - 1;
  const double bottom = problem_.grid.height() - 1;
  const auto pull = [&](double v, double x, double own, double guide, double high) {
    v = chi * (v + c * stream.uniform() * (own - x) + c * stream.uniform() * (guide - x));
    return std::clamp(v, -high / 2, high / 2);
  };
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    Particle& p = particles_[i];
    const Particle& guide = guide_of(i);
    for (std::size_t k = 1; k + 1 < p.position.size(); ++k) {
      p.velocity[k].x = pull(p.velocity[k].x, p.position[k].x, p.best[k].x, guide.best[k].x, right);
      p.velocity[k].y = pull(p.velocity[k].y, p.position[k].y, p.best[k].y, guide.best[k].y, bottom);
      p.position[k].x = std::clamp(p.position[k].x + p.velocity[k].x, 0.0, right);
      p.position[k].y = std::clamp(p.position[k].y + p.velocity[k].y, 0.0, bottom);
    }
  }
  for (Particle& particle : particles_) judge(particle);
}

double PlainSwarm::best_cost() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Particle& particle : particles_) least = std::min(least, particle.best_cost);
  return least;
}

}  // namespace pathrace::bench::micro
