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

struct Leg {
  Leg(Point start, Point end)
      : from(start), way{end.x - start.x, end.y - start.y}, length2(way.x * way.x + way.y * way.y) {}

  Point from;
  Point way;
  double length2;
};

// Where a leg's line comes nearest to a circle's centre, as seen from there.
struct Foot {
  double x;
  double y;
  double half2;  // half of the line's chord, squared
  bool crosses;  // and between the leg's ends
};

// A leg of no length crosses nothing.
Foot foot_of(const Leg& leg, double x, double y, double radius) {
  constexpr double tangent = 1e-12;  // of the squared radius: half chords below a millionth of it
  const Point at{leg.from.x - x, leg.from.y - y};
  const double towards = -(at.x * leg.way.x + at.y * leg.way.y);
  const double t = towards / leg.length2;
  const Point middle{at.x + t * leg.way.x, at.y + t * leg.way.y};
  const double half2 = radius * radius - (middle.x * middle.x + middle.y * middle.y);
  const bool crosses = (towards > 0) & (towards < leg.length2) & (half2 > tangent * radius * radius);
  return {middle.x, middle.y, half2, crosses};
}

// True wherever foot_of crosses, and hardly anywhere else; without branches and divisions, so that a loop
// over discs becomes vectors. The line's distance is the cross product over the leg's length. Rounding moves
// it, and foot_of's middle, by less than 1e-14 of the way from the leg's start to the centre: much less than
// the room that is given here, of 1e-5 of the squared radius and 1e-12 of that squared way.
inline bool may_cross(const Leg& leg, double x, double y, double radius) {
  const Point at{leg.from.x - x, leg.from.y - y};
  const double towards = -(at.x * leg.way.x + at.y * leg.way.y);
  const double across = at.x * leg.way.y - at.y * leg.way.x;
  const double room = 1.00001 * (radius * radius) + 1e-12 * (at.x * at.x + at.y * at.y);
  return (towards > 0) & (towards < leg.length2) & (across * across <= leg.length2 * room);
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
  const Leg leg(from, to);
  const Foot foot = foot_of(leg, centre.x, centre.y, radius);
  if (!foot.crosses) return std::nullopt;
  const Point middle{foot.x, foot.y};
  const double s = std::sqrt(foot.half2 / leg.length2);
  const Point half{s * leg.way.x, s * leg.way.y};
  return Chord{std::atan2(middle.y - half.y, middle.x - half.x),
               std::atan2(middle.y + half.y, middle.x + half.x)};
}

double depth_in(const Obstacle& obstacle, Point point) {
  constexpr double touch = 1e-11;  // well below 1e-9 units, from which on a referee calls it a collision
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

LegJudge::LegJudge(const Snapshot& snapshot, std::vector<Obstacle> obstacles, const Rules& rules)
    : snapshot_(snapshot), obstacles_(std::move(obstacles)), rules_(rules) {
  const std::size_t whole = (obstacles_.size() + block - 1) / block * block;
  x_.resize(whole);
  y_.resize(whole);
  radius_.resize(whole);
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    x_[i] = obstacles_[i].centre.x;
    y_[i] = obstacles_[i].centre.y;
    radius_[i] = obstacles_[i].radius;
  }
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
  if (step && rules_.step_across == StepAcross::barred) {
    sum += rules_.barrier;  // also out of this very disc by way of its middle
  } else if (step && depth_in(obstacle, snapshot_.robot) == 0) {
    sum += std::min(rules_.barrier, way_around(obstacle, *step));
  }
  const auto rest = chord(particle, snapshot_.goal, obstacle.centre, obstacle.radius);
  if (rest && depth_in(obstacle, snapshot_.goal) == 0) {
    sum += std::min(rules_.barrier, way_around(obstacle, *rest));
  }
  return sum;
}

// Which discs of the block may have a price; most have none. A particle deeper in a disc than rounding is
// nearer to its centre than its radius.
LegJudge::Marks LegJudge::met(std::size_t begin, Point particle) const {
  const Leg step(snapshot_.robot, particle);
  const Leg rest(particle, snapshot_.goal);
  const double* const x = x_.data() + begin;
  const double* const y = y_.data() + begin;
  const double* const radius = radius_.data() + begin;
  Marks marks;
  for (std::size_t k = 0; k < block; ++k) {
    const double dx = particle.x - x[k];
    const double dy = particle.y - y[k];
    const bool inside = dx * dx + dy * dy < radius[k] * radius[k];
    const bool on_step = may_cross(step, x[k], y[k], radius[k]);
    const bool on_rest = may_cross(rest, x[k], y[k], radius[k]);
    marks[k] = std::uint64_t{inside} | std::uint64_t{on_step} | std::uint64_t{on_rest};
  }
  return marks;
}

double LegJudge::penalty(Point particle) const {
  double sum = 0;
  for (std::size_t begin = 0; begin < radius_.size(); begin += block) {
    const Marks marks = met(begin, particle);
    std::uint64_t any = 0;
    for (const std::uint64_t mark : marks) any |= mark;
    if (any == 0) continue;
    for (std::size_t k = 0; k < std::min(block, obstacles_.size() - begin); ++k) {
      if (marks[k] != 0) sum += legs(obstacles_[begin + k], particle);
    }
  }
  const double beyond = outside(particle);
  return beyond > 0 ? sum + rules_.barrier + beyond : sum;
}

}  // namespace pathrace::algorithms
