// Particle swarm on way-points.
//
// A particle is a path at any angle: way-points between start and goal, joined by segments. Its cost is its
// length plus a penalty for each blocked cell that it enters, so that a swarm first finds its way out of the
// walls and then shortens it. Only a path that enters none is an answer.
//
// A swarm lives for `life` iterations; then another one is born, with one way-point more, until the budget is
// spent: few way-points are soon in place, hard maps need many. After the most way-points come the fewest
// again.
//
// Swarm: Algorithm 1 of A. Z. Nasrollahy, H. H. S. Javadi, EMS 2009. Way-points with a penalty for collisions
// are usual in the field; the numbers are this project's.
//
// One particle judged = one evaluation, one cell tested = one check. Particle i of iteration k of life l
// draws from stream.fork(l).fork(k).fork(i). Counters of the record: `lives`, swarms born; `clear`, particles
// judged that entered no wall.
#include <memory>
#include <optional>
#include <vector>

#include "algorithms/pso/swarm.hpp"
#include "algorithms/pso/waypoint_birth.hpp"
#include "algorithms/pso/waypoint_cost.hpp"
#include "core/catalogue.hpp"
#include "core/error.hpp"

namespace pathrace::algorithms {
namespace {

struct PsoSettings : SwarmSettings {
  PsoSettings() {
    particles = 100;
    inertia = InertiaRule::constriction;
    c1 = 2.05;
    c2 = 2.05;
    v_max = 1;
    topology = Topology::ring;
  }
  int waypoints_min = 3;
  int waypoints_max = 10;
  int life = 200;
  Birth birth = Birth::line;
  double scatter = 0.25;
  double penalty = 1;
};

double half_perimeter(const OccupancyGrid& grid) {
  return grid.width() + grid.height();
}

/// One query.
class WaypointSearch {
 public:
  WaypointSearch(const PsoSettings& settings, const Problem& problem, const WallMap& walls)
      : settings_(settings),
        nursery_(problem.grid, problem.start, problem.goal, settings.birth,
                 settings.scatter * half_perimeter(problem.grid)),
        cost_(walls, problem.start, problem.goal),
        penalty_(settings.penalty * half_perimeter(problem.grid)),
        verdicts_(static_cast<std::size_t>(settings.particles)) {}

  Answer run(Context& context) {
    for (std::uint64_t life = 0; !context.meter.exhausted(); ++life) {
      Swarm swarm(settings_, nursery_.box(waypoints_of(life), settings_.v_max));
      context.meter.count("lives", 1);
      live(swarm, context.stream.fork(life), context);
      if (context.overlay != nullptr && context.meter.exhausted()) draw(swarm, *context.overlay);
    }
    return best_;
  }

 private:
  std::size_t waypoints_of(std::uint64_t life) const {
    const auto least = static_cast<std::size_t>(settings_.waypoints_min);
    const auto most = static_cast<std::size_t>(settings_.waypoints_max);
    return least + life % (most - least + 1);
  }

  // Iteration 0 is the birth.
  void live(Swarm& swarm, const Stream& stream, Context& context) {
    const auto last = static_cast<std::size_t>(settings_.life);
    for (std::size_t k = 0; k <= last && !context.meter.exhausted(); ++k) {
      const std::size_t batch = context.meter.admitted(swarm.size());
      move_and_judge(swarm, k, batch, stream.fork(k), context.executor);
      const std::size_t paid = charge(batch, context.meter, swarm);
      swarm.learn(paid);
      context.meter.end_iteration();
    }
  }

  void move_and_judge(Swarm& swarm, std::size_t k, std::size_t batch, const Stream& stream,
                      Executor& executor) {
    const Momentum pace = momentum(settings_, k, static_cast<std::size_t>(settings_.life));
    for_each_abreast(executor, batch, [&](std::size_t first, std::size_t count) {
      if (k == 0) {
        for (std::size_t i = first; i < first + count; ++i) nursery_.place(swarm, i, stream.fork(i));
      } else {
        swarm.move(first, count, pace, stream);
      }
      const std::span<WaypointVerdict> verdicts(verdicts_.data() + first, count);
      cost_.judge(swarm.positions(first, count), verdicts);
      for (std::size_t i = first; i < first + count; ++i) {
        swarm.judge(i, verdicts_[i].length + penalty_ * verdicts_[i].walls);
      }
    });
  }

  // Pays in the order of the particles, and keeps the best clear path. The particle that meets the end of the
  // checks is cut there: it and those behind it do not count. Returns how many do.
  std::size_t charge(std::size_t batch, Meter& meter, const Swarm& swarm) {
    std::uint64_t clear = 0;
    std::size_t paid = 0;
    for (; paid < batch && verdicts_[paid].cells <= meter.checks_left(); ++paid) {
      meter.spend_checks(verdicts_[paid].cells);
      meter.spend_evaluations(1);
      if (verdicts_[paid].walls > 0) continue;
      ++clear;
      if (best_ && !(verdicts_[paid].length < best_length_)) continue;
      best_length_ = verdicts_[paid].length;
      best_ = cost_.path(swarm.position(paid));
      meter.improved(best_length_);
    }
    if (paid < batch) meter.spend_checks(meter.checks_left());
    meter.count("clear", clear);
    return paid;
  }

  // The way-points of the last swarm, and where its best particle goes.
  void draw(const Swarm& swarm, Overlay& overlay) const {
    for (std::size_t i = 0; i < swarm.size(); ++i) {
      const std::vector<Point> points = cost_.path(swarm.position(i)).points;
      overlay.points.insert(overlay.points.end(), points.begin(), points.end());
    }
    overlay.polyline = cost_.path(swarm.best_position()).points;
  }

  const PsoSettings& settings_;
  WaypointNursery nursery_;
  WaypointCost cost_;
  double penalty_;
  std::vector<WaypointVerdict> verdicts_;
  Answer best_;
  double best_length_ = 0;
};

class ParticleSwarm final : public MapPlanner {
 public:
  ParticleSwarm(const PsoSettings& settings, const Terrain& terrain)
      : settings_(settings), terrain_(terrain), walls_(*terrain.grid) {}

  Answer plan(Cell start, Cell goal, Context& context) override {
    if (start == goal) return stay(start, context.meter);
    return WaypointSearch(settings_, {*terrain_.grid, terrain_.rule, start, goal}, walls_).run(context);
  }

 private:
  static Answer stay(Cell cell, Meter& meter) {
    if (meter.exhausted()) return std::nullopt;
    meter.spend_evaluations(1);
    meter.improved(0);
    return Path{Track::any_angle, {centre(cell)}};
  }

  PsoSettings settings_;
  Terrain terrain_;
  WallMap walls_;
};

Planner planner_of(const PsoSettings& settings) {
  return [settings](const Terrain& terrain) -> std::unique_ptr<MapPlanner> {
    return std::make_unique<ParticleSwarm>(settings, terrain);
  };
}

Schema<PsoSettings> pso_schema() {
  using S = PsoSettings;
  constexpr auto most = static_cast<std::int64_t>(WaypointCost::max_waypoints);
  return swarm_schema<S>(
      {
          integer("waypoints_min", &S::waypoints_min, 1, most, "way-points", Source::inferred,
                  "way-points of the first swarm, between start and goal"),
          integer(
              "waypoints_max", &S::waypoints_max, 1, most, "way-points", Source::inferred,
              "each swarm has one way-point more than the one before, up to this; then from the least again"),
          integer("life", &S::life, 1, 1000000, "iterations", Source::inferred,
                  "moves of a swarm before the next one is born; inertia falls over a life"),
          choice("birth", &S::birth, Source::inferred,
                 "line: way-points near their places on the straight line; uniform: anywhere on the map"),
          real("scatter", &S::scatter, 0, 10, "width + height", Source::inferred,
               "birth=line: how far a coordinate may be from its place"),
          real("penalty", &S::penalty, 0, 1e6, "width + height", Source::inferred,
               "price of a blocked cell that a path enters; above any detour it pays to avoid"),
      },
      {{"inertia", Source::literature},
       {"c1", Source::literature},
       {"c2", Source::literature},
       {"particles", Source::inferred},
       {"v_max", Source::inferred},
       {"topology", Source::field}},
      {at_most("waypoints_min", &S::waypoints_min, "waypoints_max", &S::waypoints_max)});
}

}  // namespace

PlannerCard pso_card() {
  PlannerCard card;
  card.name = "pso";
  card.kind = Kind::pso;
  card.track = Track::any_angle;
  card.summary = "particle swarm: a particle is a path of way-points, entering walls costs a penalty";
  card.source =
      "swarm: A. Z. Nasrollahy, H. H. S. Javadi, EMS 2009, Algorithm 1; constriction: M. Clerc, J. Kennedy, "
      "IEEE "
      "Trans. Evol. Comp. 6(1), 2002; way-points: algorithms.md 4";
  card.default_budget.evaluations = 200'000;
  return with_parameters(std::move(card), pso_schema(), planner_of);
}

}  // namespace pathrace::algorithms
