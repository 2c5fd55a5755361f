// The colony: ants that walk, pay and learn, iteration by iteration, under a pheromone rule.
//
// One walk = one evaluation, one decision of an ant = one check; the steps of the greedy walk that sets the
// initial pheromone, where a rule asks for one, are checks too. Ant i of iteration t draws from
// stream.fork(t).fork(i). Counters of the record: `arrived`, walks that reached the goal; `pops`, steps back.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "algorithms/aco/ant_queue.hpp"
#include "algorithms/aco/early_deposits.hpp"
#include "algorithms/aco/nest.hpp"
#include "algorithms/aco/pheromone_rule.hpp"
#include "algorithms/aco/shared_deposits.hpp"
#include "algorithms/aco/trail.hpp"
#include "algorithms/aco/walk.hpp"
#include "algorithms/aco/walker.hpp"
#include "core/catalogue.hpp"
#include "core/planner.hpp"

namespace pathrace::algorithms {

/// How much an ant heeds the pheromone and the heuristic, where it is not the colony's alpha and beta.
struct Taste {
  double alpha = 1;
  double beta = 1;
};

class Colony {
 public:
  /// The rule outlives the colony.
  Colony(PheromoneRule& rule, const Problem& problem);
  Colony(const Colony&) = delete;
  Colony& operator=(const Colony&) = delete;

  /// Walks and learns until the budget is spent.
  Answer run(Context& context);

  const Nest& nest() const { return nest_; }
  const Trail& trail() const { return *trail_; }
  Trail& trail() { return *trail_; }
  /// Of the last iteration, one slot per ant.
  const std::vector<Walk>& walks() const { return walks_; }
  std::vector<Walk>& walks() { return walks_; }
  /// Best so far; has arrived once there is one.
  const Walk& best() const { return best_; }

  /// During a run: the rule's imprint, of the first `count` ants.
  void imprint(std::size_t count);
  /// During a run: each of the first `count` ants that arrived adds the rule's amount to the steps of its
  /// path, in ant order.
  void deposit_all(std::size_t count);
  /// Adds `amount` to each step of the walk's path.
  void deposit(const Walk& walk, double amount);
  /// tau := factor * tau + amount on each step of the walk's path.
  void change(const Walk& walk, double factor, double amount);
  /// Ants treat the cell as closed from the next iteration on. Start and goal stay open.
  void close(std::size_t index);
  /// Closes a legal step and its reverse: a diagonal past a cell that has become an obstacle.
  void close_step(std::size_t index, int direction);
  /// From the next iteration on, consecutive ants form groups of equal size with a taste each, on the
  /// pheromone as it is now: a rule that wants groups calls this in begin() and after each change of the
  /// trail. Always the same number of tastes.
  void regroup(const std::vector<Taste>& tastes);
  /// 0 without groups.
  std::size_t group_of(std::size_t ant) const { return groups_.empty() ? 0 : ant / group_size_; }

 private:
  struct Group {
    std::optional<Trail> trail;
    std::optional<Ground> ground;
  };

  Ground ground_on(const Trail& trail) const;
  bool lay_trail(Meter& meter);
  void iterate(std::uint64_t iteration, Context& context);
  void make_walkers(const Executor& executor);
  std::size_t walk_all(Context& context, const Stream& stream);
  /// Of the first `count` walks.
  Tally tally(std::size_t count) const;
  /// The same, known already when all these ants are back and deposits were made meanwhile.
  std::optional<Tally> early_tally(std::size_t count);
  std::size_t charge(std::size_t walked, const std::optional<Tally>& known, Meter& meter) const;
  bool keep_best(const Tally& tally, Meter& meter);
  void deposit_in_turn(std::size_t count);
  Walk strongest_trail() const;
  void draw(Overlay& overlay) const;

  PheromoneRule& rule_;
  const ColonySettings& settings_;
  Problem problem_;
  Nest nest_;
  std::optional<Trail> trail_;
  std::optional<Ground> ground_;
  std::vector<std::unique_ptr<Group>> groups_;
  std::deque<Walker> walkers_;   // one per thread, or per group
  std::deque<AntQueue> queues_;  // one per walker; groups have theirs
  std::size_t group_size_ = 1;
  std::uint32_t round_ = 0;                // of walks, over all runs
  std::optional<RollCall> roll_call_;      // where several threads walk and the rule admits early work
  std::optional<EarlyDeposits> deposits_;  // the same on small maps
  std::optional<SharedDeposits> shared_;   // where there are several threads
  std::vector<Walk> walks_;
  std::vector<double> amounts_;  // a slot per walk
  Walk best_;
  Executor* executor_ = nullptr;  // of the current run
};

/// A rule from what it asks for: its settings, and perhaps the problem, and perhaps a stream of its own.
template <typename Rule, typename Settings>
Rule make_rule(const Settings& settings, const Problem& problem, const Stream& stream) {
  if constexpr (std::is_constructible_v<Rule, const Settings&, const Problem&, const Stream&>) {
    return Rule(settings, problem, stream.fork("rule"));
  } else if constexpr (std::is_constructible_v<Rule, const Settings&, const Problem&>) {
    return Rule(settings, problem);
  } else {
    return Rule(settings);
  }
}

/// A card's planner for a rule that make_rule can make. Start and goal in one cell are the walk of no steps.
template <typename Settings, typename Rule>
PlannerCard colony_card(PlannerCard card, const Schema<Settings>& schema);

/// Start and goal in one cell: a walk of no steps, whose deposit would be infinite.
Answer stay(const Problem& problem, Meter& meter, Track track = Track::lattice);

template <typename Settings, typename Rule>
PlannerCard colony_card(PlannerCard card, const Schema<Settings>& schema) {
  card.kind = Kind::aco;
  const Track track = card.track;
  return with_parameters(std::move(card), schema, [track](const Settings& settings) {
    return unprepared([settings, track](const Problem& problem, Context& context) -> Answer {
      if (problem.start == problem.goal) return stay(problem, context.meter, track);
      auto rule = make_rule<Rule>(settings, problem, context.stream);
      return Colony(rule, problem).run(context);
    });
  });
}

}  // namespace pathrace::algorithms
