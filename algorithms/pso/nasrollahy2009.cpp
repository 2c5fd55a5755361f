// A swarm steers a robot among moving discs.
//
// Before each step a swarm is born around the robot and evolves for K iterations; the robot goes where its
// best particle is. A particle is a place at the distance R = min(V_robot, distance to the goal) from the
// robot:
//
//   F = |robot, particle| + |particle, goal| + Penalty     (8), (9); the penalty: arc_penalty.hpp
//
// A. Z. Nasrollahy, H. H. S. Javadi, "Using Particle Swarm Optimization for Robot Path Planning in Dynamic
// Environments with Moving Obstacles and Target", EMS 2009, pp. 60-65. The equations are lost from the text
// at hand; algorithms.md 4 has the reconstruction. Free radii would make F flat along the line to the goal,
// and a robot that may stay where it is stalls; so particles move in the plane by (1) to (3) and are
// projected onto the circle before they are judged.
//
// One particle judged = one evaluation, a disc tested against it = one check (two legs, so two per disc).
// Particle i of iteration k draws from the step's stream.fork(k).fork(i). Counters of the record: `barred`,
// steps whose best particle was still inside a disc or without a way; `revisits`, steps back to an earlier
// place.
#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "algorithms/pso/arc_penalty.hpp"
#include "algorithms/pso/heading.hpp"
#include "algorithms/pso/swarm.hpp"
#include "core/catalogue.hpp"

namespace pathrace::algorithms {
namespace {

struct NasrollahySettings : SwarmSettings {
  int iterations = 50;
  Heading heading = Heading::projected;
  StepAcross step_across = StepAcross::arc;
  bool stay_when_barred = true;
  double barrier = 1000;
  double adjacency = 1e-6;
  double revisit = 0.1;
};

LegJudge judge_of(const NasrollahySettings& settings, const Snapshot& snapshot) {
  const Workspace workspace{snapshot.width, snapshot.height};
  const double scale = workspace.diagonal();
  return {snapshot,
          grow(snapshot.discs, snapshot.robot_radius, workspace, settings.adjacency * scale),
          {settings.barrier * scale, settings.step_across}};
}

/// The swarm of one step.
class StepSwarm {
 public:
  StepSwarm(const NasrollahySettings& settings, const Snapshot& snapshot)
      : settings_(settings),
        snapshot_(snapshot),
        compass_(settings.heading, std::min(snapshot.robot_step, separation(snapshot.robot, snapshot.goal))),
        judge_(judge_of(settings, snapshot)),
        swarm_(settings, compass_.box(snapshot.robot_step, settings.v_max)) {}

  void evolve(Context& context) {
    const auto last = static_cast<std::size_t>(settings_.iterations);
    for (std::size_t k = 0; k <= last && !context.meter.exhausted(); ++k) iterate(k, context);
  }

  /// False when the budget admitted no particle.
  bool judged() const { return std::isfinite(swarm_.best_cost()); }
  Point best() const { return place(swarm_.best_position()); }
  /// The best particle is inside a disc, or has no way to the goal.
  bool barred() const { return judge_.penalty(best()) >= judge_.barrier(); }

  /// The two legs of the best particle.
  void draw_legs(Overlay& overlay) const { overlay.polyline = {snapshot_.robot, best(), snapshot_.goal}; }

 private:
  Point place(std::span<const double> position) const {
    const Point step = compass_.step(position);
    return {snapshot_.robot.x + step.x, snapshot_.robot.y + step.y};
  }

  // Iteration 0 is the birth.
  void iterate(std::size_t k, Context& context) {
    const std::size_t batch = admitted(context.meter);
    const Stream stream = context.stream.fork(k);
    const Momentum pace = momentum(settings_, k, static_cast<std::size_t>(settings_.iterations));
    for_each_abreast(context.executor, batch, [&](std::size_t first, std::size_t count) {
      if (k > 0) swarm_.move(first, count, pace, stream);
      for (std::size_t i = first; i < first + count; ++i) {
        if (k == 0) {
          compass_.place(swarm_.position(i), swarm_.velocity(i), swarm_.box(), stream.fork(i));
        } else {
          compass_.project(swarm_.position(i), stream.fork(i));
        }
        swarm_.judge(i, cost(place(swarm_.position(i))));
      }
    });
    context.meter.spend_evaluations(batch);
    context.meter.spend_checks(batch * judge_.checks());
    if (batch < swarm_.size()) context.meter.spend_checks(leftover(context.meter));
    swarm_.learn(batch);
    if (context.overlay != nullptr && is_drawn(k)) draw(batch, *context.overlay);
  }

  // The birth and the iterations 1, 2, 4, 8, ...: a swarm at its end is one point.
  static bool is_drawn(std::size_t k) { return k == 0 || std::has_single_bit(k); }

  void draw(std::size_t count, Overlay& overlay) const {
    for (std::size_t i = 0; i < count; ++i) overlay.points.push_back(place(swarm_.position(i)));
  }

  // Eq. (9).
  double cost(Point particle) const {
    return compass_.radius() + separation(particle, snapshot_.goal) + judge_.penalty(particle);
  }

  std::size_t admitted(const Meter& meter) const {
    const std::size_t wanted = meter.admitted(swarm_.size());
    if (judge_.checks() == 0) return wanted;
    return static_cast<std::size_t>(std::min<std::uint64_t>(wanted, meter.checks_left() / judge_.checks()));
  }

  // Checks that do not suffice for one more particle are spent in its start.
  std::uint64_t leftover(const Meter& meter) const {
    return meter.checks_left() < judge_.checks() ? meter.checks_left() : 0;
  }

  const NasrollahySettings& settings_;
  const Snapshot& snapshot_;
  Compass compass_;
  LegJudge judge_;
  Swarm swarm_;
};

class Nasrollahy2009 final : public Navigator {
 public:
  explicit Nasrollahy2009(const NasrollahySettings& settings) : settings_(settings) {}

  Point next(const Snapshot& snapshot, Context& context) override {
    const Point robot = snapshot.robot;
    if (robot == snapshot.goal) return robot;
    StepSwarm swarm(settings_, snapshot);
    swarm.evolve(context);
    if (!swarm.judged()) return robot;
    const bool barred = swarm.barred();
    context.meter.count("barred", barred ? 1 : 0);
    const Point next = barred && settings_.stay_when_barred ? robot : swarm.best();
    remember(robot, next, settings_.revisit * snapshot.robot_step, context.meter);
    if (context.overlay != nullptr) swarm.draw_legs(*context.overlay);
    return next;
  }

 private:
  // A robot that swings between two detours comes back to places it has left.
  void remember(Point robot, Point next, double near, Meter& meter) {
    const bool again =
        std::any_of(left_.begin(), left_.end(), [&](Point place) { return separation(place, next) <= near; });
    meter.count("revisits", again ? 1 : 0);
    if (next != robot) left_.push_back(robot);
  }

  NasrollahySettings settings_;
  std::vector<Point> left_;  // where the robot has been
};

}  // namespace

PlannerCard nasrollahy2009_card() {
  using S = NasrollahySettings;
  PlannerCard card;
  card.name = "nasrollahy2009";
  card.kind = Kind::navigator;
  card.version = 2;
  card.summary = "particle swarm that picks each step among moving discs by the detours it leaves";
  card.source = "A. Z. Nasrollahy, H. H. S. Javadi, EMS 2009, eq. (1)-(10); lost equations: algorithms.md 4";
  card.default_budget.iterations = 500;
  const Schema<S> schema = swarm_schema<S>(
      {
          integer("iterations", &S::iterations, 0, 100000, "iterations", Source::field,
                  "K, moves of the swarm per step; its birth comes on top"),
          choice(
              "heading", &S::heading, Source::inferred,
              "projected: a particle is a step in the plane, brought to length R; angle: alpha of eq. (6)"),
          choice("step_across", &S::step_across, Source::paper,
                 "price of a next step that crosses a disc: arc, as published, the way around, so that the "
                 "robot may clip the disc's edge; barred, as if the step ended inside it"),
          boolean("stay_when_barred", &S::stay_when_barred, Source::inferred,
                  "stay when even the best particle is inside a disc or without a way"),
          real("barrier", &S::barrier, 1, 1e9, "diagonals", Source::inferred,
               "penalty of what is no way, in diagonals of the workspace"),
          real("adjacency", &S::adjacency, 0, 1, "diagonals", Source::inferred,
               "discs are adjacent when the robot's spare room between them is at most this"),
          real("revisit", &S::revisit, 0, 10, "V_robot", Source::ours,
               "a step this near to a place left before counts as a revisit; counted only"),
      },
      {});
  return with_navigator_parameters(
      std::move(card), schema, [](const S& settings) { return std::make_unique<Nasrollahy2009>(settings); });
}

}  // namespace pathrace::algorithms
