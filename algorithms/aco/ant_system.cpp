// Ant System on a grid.
//
// Each ant walks from the start, choosing the next cell with probability proportional to
// pheromone^alpha * heuristic^beta among the neighbours it has not visited (1). When all ants of an iteration
// have walked, every trail keeps the share (1 - evaporation) of its pheromone (2), and each ant that arrived
// adds Q / length to the steps it took (3).
//
// M. Dorigo, V. Maniezzo, A. Colorni, "Ant System: Optimization by a Colony of Cooperating Agents", IEEE
// Trans. SMC-B 26(1), 1996; as the "traditional ant colony" of Tan et al., eq. (1) to (3).
//
// One walk = one evaluation, one decision of an ant = one check. Ant i of iteration t draws from
// stream.fork(t).fork(i). Deposits are added in ant order at the iteration's end.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/aco/ant.hpp"
#include "algorithms/aco/trail.hpp"
#include "core/catalogue.hpp"

namespace pathrace::algorithms {

enum class AntHeuristic { inv_goal, inv_step };
enum class AntAnswer { best_so_far, argmax_pheromone };

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::AntHeuristic> =
    std::to_array<std::pair<algorithms::AntHeuristic, std::string_view>>({
        {algorithms::AntHeuristic::inv_goal, "inv_goal"},
        {algorithms::AntHeuristic::inv_step, "inv_step"},
    });
template <>
inline constexpr auto names_of<algorithms::AntAnswer> =
    std::to_array<std::pair<algorithms::AntAnswer, std::string_view>>({
        {algorithms::AntAnswer::best_so_far, "best_so_far"},
        {algorithms::AntAnswer::argmax_pheromone, "argmax_pheromone"},
    });
}  // namespace pathrace

namespace pathrace::algorithms {
namespace {

struct AntSystemSettings {
  int ants = 50;
  double alpha = 1;
  double beta = 7;
  double evaporation = 0.3;
  double deposit = 1;
  double initial_pheromone = 8;
  double pheromone_floor = 1e-12;
  double goal_attraction = 100;
  bool both_ways = true;
  AntHeuristic heuristic = AntHeuristic::inv_goal;
  DeadEnd dead_end = DeadEnd::die;
  AntAnswer answer = AntAnswer::best_so_far;
  std::int64_t max_steps = 0;
};

using S = AntSystemSettings;

Schema<S> schema() {
  return {{
      integer("ants", &S::ants, 1, 100000, "ants", Source::seen, "m, walks per iteration"),
      real("alpha", &S::alpha, 0, 20, "", Source::seen,
           "weight of the pheromone in eq. (1); 0 learns nothing"),
      real("beta", &S::beta, 0, 50, "", Source::seen, "weight of the heuristic in eq. (1)"),
      real("evaporation", &S::evaporation, 0, 1, "", Source::seen,
           "share of the pheromone lost per iteration; the paper's rho is the share kept, 1 - evaporation"),
      real("deposit", &S::deposit, 0, 1e9, "pheromone * cells", Source::seen,
           "Q of eq. (3): an ant adds Q / length"),
      real("initial_pheromone", &S::initial_pheromone, 1e-9, 1e9, "pheromone", Source::seen,
           "C, tau at the start"),
      real("pheromone_floor", &S::pheromone_floor, 0, 1, "pheromone", Source::inferred,
           "tau never falls below this, so that no step is lost for ever"),
      real("goal_attraction", &S::goal_attraction, 1e-6, 1e9, "1 / cells", Source::seen,
           "heuristic value of a step onto the goal itself, where 1 / distance is infinite"),
      boolean("both_ways", &S::both_ways, Source::seen, "deposit on a step and on its reverse"),
      choice("heuristic", &S::heuristic, Source::seen,
             "inv_goal: 1 / distance of the next cell to the goal; inv_step: 1 / length of the step, the "
             "paper's text"),
      choice("dead_end", &S::dead_end, Source::seen, "what an ant does when all its neighbours are tabu"),
      choice("answer", &S::answer, Source::paper,
             "best_so_far, or argmax_pheromone: the walk along the strongest trail, as the paper ends"),
      integer("max_steps", &S::max_steps, 0, 1'000'000'000'000, "decisions", Source::ours,
              "a walk gives up after so many decisions; 0: twenty times the free cells"),
  }};
}

Trail::Heuristic heuristic(const S& settings, const Problem& problem, const MoveTable& moves) {
  if (settings.heuristic == AntHeuristic::inv_step) {
    return [](std::size_t, int direction) { return is_diagonal(direction) ? 1 / std::numbers::sqrt2 : 1.0; };
  }
  return [&settings, &problem, &moves](std::size_t index, int direction) {
    const Cell cell = problem.grid.cell(moves.step(index, direction));
    if (cell == problem.goal) return settings.goal_attraction;
    const double dx = cell.x - problem.goal.x;
    const double dy = cell.y - problem.goal.y;
    return 1 / std::sqrt(dx * dx + dy * dy);
  };
}

class Colony {
 public:
  Colony(const S& settings, const Problem& problem)
      : settings_(settings),
        problem_(problem),
        moves_(problem.grid, problem.rule),
        trail_(moves_, settings.initial_pheromone, settings.alpha, settings.beta,
               heuristic(settings, problem, moves_)),
        ground_{moves_,
                trail_,
                problem.grid.index(problem.start),
                problem.grid.index(problem.goal),
                settings.dead_end,
                max_steps()} {
    ants_.reserve(static_cast<std::size_t>(settings.ants));
    for (int i = 0; i < settings.ants; ++i) ants_.emplace_back(ground_);
  }

  Answer run(Context& context) {
    for (std::uint64_t iteration = 0; !context.meter.exhausted(); ++iteration) {
      const std::size_t walked = walk_all(context, context.stream.fork(iteration));
      const std::size_t counted = charge_and_keep_best(walked, context.meter);
      context.meter.end_iteration();
      reinforce(counted);
    }
    return settings_.answer == AntAnswer::best_so_far ? path_of(best_) : path_of(strongest_trail());
  }

 private:
  std::uint64_t max_steps() const {
    if (settings_.max_steps > 0) return static_cast<std::uint64_t>(settings_.max_steps);
    return 20 * static_cast<std::uint64_t>(problem_.grid.free_cells());
  }

  std::size_t walk_all(Context& context, const Stream& stream) {
    const std::size_t batch = context.meter.admitted(ants_.size());
    const std::uint64_t limit = context.meter.checks_left();
    const auto threads = static_cast<std::size_t>(context.executor.threads());
    const std::size_t grain = std::max<std::size_t>(1, batch / (4 * threads));
    for_each_index(context.executor, batch, grain,
                   [&](std::size_t i) { ants_[i].walk(stream.fork(i), limit, context.meter); });
    return batch;
  }

  // Pays for the walks in ant order. The ant that meets the end of the checks is cut there: its walk and
  // those behind it do not count. Returns how many walks do.
  std::size_t charge_and_keep_best(std::size_t walked, Meter& meter) {
    for (std::size_t i = 0; i < walked; ++i) {
      const std::uint64_t left = meter.checks_left();
      if (ants_[i].steps() > left || (ants_[i].steps() == left && !ants_[i].arrived() && left > 0)) {
        meter.spend_checks(left);
        return i;
      }
      meter.spend_checks(ants_[i].steps());
      meter.spend_evaluations(1);
      keep_best(ants_[i], meter);
      if (meter.checks_left() == 0) return i + 1;
    }
    return walked;
  }

  void keep_best(const Ant& ant, Meter& meter) {
    if (!ant.arrived()) return;
    const LatticeLength length = ant.length();
    if (!best_.empty() && length >= shortest_) return;
    best_ = ant.path();
    shortest_ = length;
    meter.improved(length.value());
  }

  void reinforce(std::size_t counted) {
    trail_.evaporate(1 - settings_.evaporation, settings_.pheromone_floor);
    for (std::size_t k = 0; k < counted; ++k) {
      if (!ants_[k].arrived()) continue;
      const double amount = settings_.deposit / ants_[k].length().value();
      for (std::size_t i = 0; i + 1 < ants_[k].path().size(); ++i) {
        trail_.deposit(ants_[k].path()[i], ants_[k].direction(i), amount, settings_.both_ways);
      }
    }
    trail_.refresh();
  }

  // From the start along the strongest pheromone over unvisited cells; empty when that ends elsewhere.
  std::vector<std::uint32_t> strongest_trail() const {
    std::vector<std::uint8_t> visited(moves_.size(), 0);
    std::vector<std::uint32_t> path{static_cast<std::uint32_t>(ground_.start)};
    while (path.back() != ground_.goal) {
      const std::size_t cell = path.back();
      visited[cell] = 1;
      int strongest = -1;
      for (int d = 0; d < direction_count; ++d) {
        if ((moves_[cell] >> d & 1) == 0 || visited[moves_.step(cell, d)] != 0) continue;
        if (strongest < 0 || trail_.pheromone(cell, d) > trail_.pheromone(cell, strongest)) strongest = d;
      }
      if (strongest < 0) return {};
      path.push_back(static_cast<std::uint32_t>(moves_.step(cell, strongest)));
    }
    return path;
  }

  Answer path_of(const std::vector<std::uint32_t>& indices) const {
    if (indices.empty()) return std::nullopt;
    Path path;
    for (const std::uint32_t index : indices) path.points.push_back(centre(problem_.grid.cell(index)));
    return path;
  }

  const S& settings_;
  const Problem& problem_;
  MoveTable moves_;
  Trail trail_;
  Ant::Ground ground_;
  std::vector<Ant> ants_;
  std::vector<std::uint32_t> best_;
  LatticeLength shortest_;
};

// Start and goal in one cell: the walk of no steps, whose deposit would be infinite.
Answer stay(const Problem& problem, Meter& meter) {
  if (meter.exhausted()) return std::nullopt;
  meter.spend_evaluations(1);
  meter.improved(0);
  return lattice_path({problem.start});
}

}  // namespace

PlannerCard ant_system_card() {
  PlannerCard card;
  card.name = "as";
  card.kind = Kind::aco;
  card.summary = "Ant System: all ants that arrive reinforce the steps they took";
  card.source = "M. Dorigo, V. Maniezzo, A. Colorni, IEEE Trans. SMC-B 26(1), 1996; Tan et al., eq. (1)-(3)";
  card.default_budget.iterations = 100;
  return with_parameters(std::move(card), schema(), [](const S& settings) {
    return unprepared([settings](const Problem& problem, Context& context) {
      if (problem.start == problem.goal) return stay(problem, context.meter);
      return Colony(settings, problem).run(context);
    });
  });
}

}  // namespace pathrace::algorithms
