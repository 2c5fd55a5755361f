#include "algorithms/pso/heading.hpp"

#include <cmath>
#include <numbers>

namespace pathrace::algorithms {
namespace {

// Uniform on the unit circle: a point of the unit disc by rejection, without sine and cosine.
Point random_direction(Stream& stream) {
  while (true) {
    const double x = 2 * stream.uniform() - 1;
    const double y = 2 * stream.uniform() - 1;
    const double length2 = x * x + y * y;
    if (length2 > 1 || length2 == 0) continue;
    const double length = std::sqrt(length2);
    return {x / length, y / length};
  }
}

}  // namespace

SwarmBox Compass::box(double robot_step, double v_max) const {
  if (heading_ == Heading::angle) return {{0}, {2 * std::numbers::pi}, {v_max * std::numbers::pi}};
  const double speed = v_max * robot_step;
  return {{-robot_step, -robot_step}, {robot_step, robot_step}, {speed, speed}};
}

void Compass::place(std::span<double> position, std::span<double> velocity, const SwarmBox& box,
                    Stream stream) const {
  if (heading_ == Heading::angle) {
    position[0] = box.high[0] * stream.uniform();
    velocity[0] = box.max_speed[0] * (2 * stream.uniform() - 1);
    return;
  }
  const Point where = random_direction(stream);
  const Point whither = random_direction(stream);
  position[0] = radius_ * where.x;
  position[1] = radius_ * where.y;
  velocity[0] = box.max_speed[0] * whither.x;
  velocity[1] = box.max_speed[1] * whither.y;
}

void Compass::project(std::span<double> position, const Stream& stream) const {
  if (heading_ == Heading::angle) return;
  const double length = std::sqrt(position[0] * position[0] + position[1] * position[1]);
  Point direction{position[0] / length, position[1] / length};
  if (length == 0) {
    Stream redraw = stream.fork("redraw");
    direction = random_direction(redraw);
  }
  position[0] = radius_ * direction.x;
  position[1] = radius_ * direction.y;
}

Point Compass::step(std::span<const double> position) const {
  if (heading_ == Heading::angle) {
    return {radius_ * std::cos(position[0]), radius_ * std::sin(position[0])};
  }
  return {position[0], position[1]};
}

}  // namespace pathrace::algorithms
