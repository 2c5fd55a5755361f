// Pheromone rules: what distinguishes one ant colony from another.
//
// The colony walks, pays and remembers the best; the rule says with how much pheromone it begins and what an
// iteration leaves behind. What a paper does "at once", while ants still walk, a rule does here, at the
// iteration's end and in ant order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/aco/colony_settings.hpp"
#include "algorithms/aco/nest.hpp"
#include "algorithms/aco/trail.hpp"
#include "algorithms/aco/walk.hpp"
#include "core/planner.hpp"

namespace pathrace::algorithms {

class Colony;

/// The greedy walk that initial pheromone is measured by.
struct Scout {
  double length = 1;  ///< C_nn, cells
  double steps = 1;   ///< of that walk
};

/// What an iteration brought home.
struct Harvest {
  std::uint64_t iteration = 0;
  std::size_t count = 0;           ///< ants 0..count-1 count; those behind them ran out of budget
  const Walk* shortest = nullptr;  ///< of this iteration, the first of its cost; null when nobody arrived
  bool improved = false;           ///< the best so far is of this iteration
};

/// What the ants of an iteration do to the trail: tau := persistence * tau on every step; then, ant by ant,
/// tau := factor * tau + amount on the steps of its path.
struct Imprint {
  double persistence = 1;
  double factor = 1;         ///< not negative
  bool of_the_dead = false;  ///< ants that did not arrive leave one, too
  bool on_popped = false;    ///< on steps that were taken back, too, after those of the path

  /// Nothing but eq. (3): those who arrived add to their paths.
  bool is_deposit() const { return factor == 1 && !of_the_dead && !on_popped; }
};

/// May deposits, imprints that is, be made while other ants still walk?
enum class Early {
  no,
  yes,
  until_a_step_back,  ///< only in iterations in which no ant steps back
};

class PheromoneRule {
 public:
  explicit PheromoneRule(const ColonySettings& settings) : settings_(settings) {}
  PheromoneRule(const PheromoneRule&) = delete;
  PheromoneRule& operator=(const PheromoneRule&) = delete;
  virtual ~PheromoneRule() = default;

  const ColonySettings& settings() const { return settings_; }

  /// tau at the start, by the variant's formula. Not asked when the settings name one.
  virtual double initial_pheromone(const Scout& scout) const = 0;
  /// Chance of the best step instead of eq. (1).
  virtual double q0() const { return 0; }
  /// True: walks keep the path of ants that died.
  virtual bool keeps_the_dead() const { return false; }
  /// True: walks list the steps that were taken back.
  virtual bool keeps_popped() const { return false; }

  /// True: walks know their turns.
  virtual bool counts_turns() const { return false; }

  /// The same throughout a run.
  virtual Imprint imprint() const { return {.persistence = 1 - settings_.evaporation}; }
  /// Not `no`: revise() alters no walk, and learn() changes no pheromone before it calls Colony::imprint.
  /// `amount` and `better` may be called while ants walk.
  virtual Early deposits_early() const { return Early::no; }

  /// Once, when nest and trail stand: limits, an initial field over the even one.
  virtual void begin(Colony& colony);
  /// After all ants have walked and paid, before the best is chosen: may alter walks or add work.
  virtual void revise(Colony& /*colony*/, Context& /*context*/, std::size_t /*count*/) {}
  /// Is `challenger` better than `incumbent`? Both arrived. Strict: the first of equals stays.
  virtual bool better(const Walk& challenger, const Walk& incumbent) const {
    return challenger.length < incumbent.length;
  }
  /// What an ant adds to each step of its path, eq. (3).
  virtual double amount(const Walk& walk) const { return settings_.deposit / walk.length.value(); }
  /// The iteration's end: evaporation, deposits, penalties, dead ends.
  virtual void learn(Colony& colony, const Harvest& harvest) = 0;
  /// Adds to a picture what this colony knows beside its pheromone.
  virtual void draw(Overlay& /*overlay*/) const {}
  /// The answer, from the best walk.
  virtual Path finish(const Nest& nest, const Walk& best) const { return path_of(nest, best); }

 protected:
  /// 1 / (evaporation * length): what one ant's deposits of 1 / length settle at. Evaporation 0 counts as
  /// 1e-6.
  double settled(double length) const { return 1 / (std::max(settings_.evaporation, 1e-6) * length); }

 private:
  const ColonySettings& settings_;
};

/// What the walks of an iteration come to.
struct Tally {
  std::size_t walks = 0;
  std::uint64_t arrived = 0;
  std::uint64_t decisions = 0;
  std::uint64_t pops = 0;
  const Walk* shortest = nullptr;  ///< as in Harvest

  void add(const Walk& walk, const PheromoneRule& rule) {
    ++walks;
    decisions += walk.decisions;
    pops += walk.pops;
    if (!walk.arrived) return;
    ++arrived;
    if (shortest == nullptr || rule.better(walk, *shortest)) shortest = &walk;
  }
};

}  // namespace pathrace::algorithms
