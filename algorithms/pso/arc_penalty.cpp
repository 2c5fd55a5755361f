#include "algorithms/pso/arc_penalty.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pathrace::algorithms {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double full_turn = 2 * std::numbers::pi;

// Into [0, 2 pi), for differences of angles from [-pi, pi].
double wrapped(double angle) {
  return angle < 0 ? angle + full_turn : angle;
}

// Counter-clockwise from `begin` over `span`.
struct Arc {
  double begin;
  double span;

  bool contains(double angle) const { return wrapped(angle - begin) <= span; }
};

// The circumferences of the groups that have a neighbour on this arc, each once, in the order of the
// neighbours.
double circumferences_on(const Obstacle& obstacle, const Arc& arc, bool inside) {
  const auto& neighbours = obstacle.neighbours;
  double sum = 0;
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    if (arc.contains(neighbours[k].angle) != inside) continue;
    const bool counted =
        std::any_of(neighbours.begin(), neighbours.begin() + static_cast<std::ptrdiff_t>(k),
                    [&](const DiscNeighbour& other) {
                      return other.group == neighbours[k].group && arc.contains(other.angle) == inside;
                    });
    if (!counted) sum += obstacle.circumferences[neighbours[k].group];
  }
  return sum;
}

bool meets_border(const Obstacle& obstacle, const Arc& arc, bool inside) {
  return std::any_of(obstacle.border_angles.begin(), obstacle.border_angles.end(),
                     [&](double angle) { return arc.contains(angle) == inside; });
}

}  // namespace

std::optional<Chord> chord(Point from, Point to, Point centre, double radius) {
  constexpr double tangent = 1e-12;  // of the squared radius: half chords below a millionth of it
  const Point way{to.x - from.x, to.y - from.y};
  const Point at{from.x - centre.x, from.y - centre.y};
  const double length2 = way.x * way.x + way.y * way.y;
  const double towards = -(at.x * way.x + at.y * way.y);
  if (!(towards > 0 && towards < length2)) return std::nullopt;
  const double t = towards / length2;
  const Point middle{at.x + t * way.x, at.y + t * way.y};
  const double half2 = radius * radius - (middle.x * middle.x + middle.y * middle.y);
  if (half2 <= tangent * radius * radius) return std::nullopt;
  const double s = std::sqrt(half2 / length2);
  const Point half{s * way.x, s * way.y};
  return Chord{std::atan2(middle.y - half.y, middle.x - half.x),
               std::atan2(middle.y + half.y, middle.x + half.x)};
}

double depth_in(const Obstacle& obstacle, Point point) {
  constexpr double touch = 1e-9;
  const double dx = point.x - obstacle.centre.x;
  const double dy = point.y - obstacle.centre.y;
  const double depth = obstacle.radius - std::sqrt(dx * dx + dy * dy);
  return depth > touch * obstacle.radius ? depth : 0;
}

double way_around(const Obstacle& obstacle, const Chord& chord) {
  const Arc arc{chord.entry, wrapped(chord.exit - chord.entry)};
  double least = infinite;
  for (const bool inside : {true, false}) {
    if (meets_border(obstacle, arc, inside)) continue;
    const double span = inside ? arc.span : full_turn - arc.span;
    least = std::min(least, obstacle.radius * span + circumferences_on(obstacle, arc, inside));
  }
  return least;
}

// How far the robot's centre is beyond where the robot still fits into the workspace.
double LegJudge::outside(Point particle) const {
  const double r = snapshot_.robot_radius;
  const double x = std::max({r - particle.x, particle.x - (snapshot_.width - r), 0.0});
  const double y = std::max({r - particle.y, particle.y - (snapshot_.height - r), 0.0});
  return x + y;
}

double LegJudge::legs(const Obstacle& obstacle, Point particle) const {
  const double depth = depth_in(obstacle, particle);
  if (depth > 0) return rules_.barrier + depth;
  double sum = 0;
  const auto step = chord(snapshot_.robot, particle, obstacle.centre, obstacle.radius);
  if (step && depth_in(obstacle, snapshot_.robot) == 0) {
    const bool barred = rules_.step_across == StepAcross::barred;
    sum += barred ? rules_.barrier : std::min(rules_.barrier, way_around(obstacle, *step));
  }
  const auto rest = chord(particle, snapshot_.goal, obstacle.centre, obstacle.radius);
  if (rest && depth_in(obstacle, snapshot_.goal) == 0) {
    sum += std::min(rules_.barrier, way_around(obstacle, *rest));
  }
  return sum;
}

double LegJudge::penalty(Point particle) const {
  double sum = 0;
  for (const Obstacle& obstacle : obstacles_) sum += legs(obstacle, particle);
  const double beyond = outside(particle);
  return beyond > 0 ? sum + rules_.barrier + beyond : sum;
}

}  // namespace pathrace::algorithms
