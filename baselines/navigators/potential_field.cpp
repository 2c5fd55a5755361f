// Artificial potential field: the goal attracts, discs within reach repel.
//
// The attraction has length 1 everywhere; disc i at the gap d_i < reach adds, away from its centre,
// gain (1/d_i - 1/reach) / d_i^2, gaps counted in V_robot so that no unit matters. The robot steps by V_robot
// along the sum. Where that step would drive into a disc it is halved, again and again, and at last given up.
//
// O. Khatib, "Real-Time Obstacle Avoidance for Manipulators and Mobile Robots", IJRR 5(1), 1986. The constant
// attraction is the usual conic well; the halving is ours: a discrete step has no dynamics that would brake.
// One step is one evaluation, one disc looked at is one check.
#include <algorithm>

#include "baselines/navigators/room.hpp"
#include "core/catalogue.hpp"
#include "core/world.hpp"

namespace pathrace::baselines {
namespace {

constexpr int halvings = 6;
constexpr double least_gap = 0.05;  // V_robot: a robot that touches is pushed away with a finite force

struct FieldSettings {
  double gain = 0.5;
  double reach = 3;
};

class PotentialField final : public Navigator {
 public:
  explicit PotentialField(const FieldSettings& settings) : settings_(settings) {}

  Point next(const Snapshot& snapshot, Context& context) override {
    context.meter.spend_evaluations(1);
    const std::uint64_t looks = snapshot.discs.size() * (2 + halvings);
    if (!afford(context.meter, looks)) return snapshot.robot;
    const Point force = force_at(snapshot);
    const Point aim{snapshot.robot.x + force.x, snapshot.robot.y + force.y};
    const double longest = std::min(snapshot.robot_step, straight_line(snapshot.robot, snapshot.goal));
    double length = straight_line(aim, snapshot.robot) > 0 ? longest : 0;
    for (int i = 0; i <= halvings && length > 0; ++i, length /= 2) {
      const Point to = kept_inside(snapshot, along(snapshot.robot, force, length));
      if (is_free_way(snapshot, to)) return to;
    }
    return snapshot.robot;
  }

 private:
  static Point along(Point from, Point force, double length) {
    const double size = straight_line({0, 0}, force);
    return {from.x + length * force.x / size, from.y + length * force.y / size};
  }

  Point force_at(const Snapshot& snapshot) const {
    const Point robot = snapshot.robot;
    const double to_goal = straight_line(robot, snapshot.goal);
    Point force{0, 0};
    if (to_goal > 0) force = {(snapshot.goal.x - robot.x) / to_goal, (snapshot.goal.y - robot.y) / to_goal};
    for (const Disc& disc : snapshot.discs) {
      const double apart = straight_line(robot, disc.centre);
      const double gap = (apart - disc.radius - snapshot.robot_radius) / snapshot.robot_step;
      if (gap >= settings_.reach || apart == 0) continue;
      const double d = std::max(gap, least_gap);
      const double push = settings_.gain * (1 / d - 1 / settings_.reach) / (d * d);
      force.x += push * (robot.x - disc.centre.x) / apart;
      force.y += push * (robot.y - disc.centre.y) / apart;
    }
    return force;
  }

  FieldSettings settings_;
};

}  // namespace

PlannerCard potential_field_card() {
  PlannerCard card;
  card.name = "potential-field";
  card.kind = Kind::navigator;
  card.random = false;
  card.summary = "is drawn to the goal and pushed away by discs";
  card.source = "O. Khatib, IJRR 5(1), 1986";
  const Schema<FieldSettings> schema{{
      real("gain", &FieldSettings::gain, 0, 1000, "", Source::ours,
           "strength of the discs against the goal's 1"),
      real("reach", &FieldSettings::reach, 0.1, 100, "V_robot", Source::ours,
           "gap beyond which a disc is ignored"),
  }};
  return with_navigator_parameters(std::move(card), schema, [](const FieldSettings& settings) {
    return std::make_unique<PotentialField>(settings);
  });
}

}  // namespace pathrace::baselines
