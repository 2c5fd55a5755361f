// Deposits that are made while other ants still walk.
//
// Deposits of an iteration come in ant order, one after another; on a small map they are a tenth of the work,
// and threads that wait for them would be idle. So one of the walkers, whenever an ant of its own is back,
// deposits for all ants that are back and next in order, on a draft of the next trail. When everybody is
// back, few are left.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "algorithms/aco/pheromone_rule.hpp"
#include "algorithms/aco/roll_call.hpp"

namespace pathrace::algorithms {

/// For one thread at a time; the walks may be written meanwhile. On lines of its own: other threads read what
/// stands beside it.
class alignas(128) EarlyDeposits {
 public:
  /// Everything outlives this.
  EarlyDeposits(const PheromoneRule& rule, const Nest& nest, Trail& trail, const std::vector<Walk>& walks,
                const RollCall& roll_call);

  /// Ants 0..ants-1 are about to walk, and sign in this round. Nothing is done early when no draft can be
  /// had, nor for a few rounds after the rule's condition has not held.
  void begin(std::size_t ants, std::uint32_t round);
  /// Deposits for those that are back and next in order.
  void go_on();
  /// The same once all are back, which is when no other thread reads the trail.
  void conclude();
  /// What those walks come to that deposits were made for.
  const Tally& tally() const { return tally_; }
  /// Once all are back: deposits for the rest; the trail is then the next one, evaporation included. False
  /// when no deposits for just this many ants were begun: the trail is as it was.
  bool finish(std::size_t ants);

 private:
  static constexpr int longest_pause = 63;

  void leave_imprint(const Walk& walk);
  void give_up();

  const PheromoneRule& rule_;
  const Nest& nest_;
  Trail& trail_;
  const std::vector<Walk>& walks_;
  const RollCall& roll_call_;
  Imprint imprint_;
  bool plain_;  // deposits on paths only
  bool until_a_step_back_;
  Tally tally_;
  std::size_t ants_ = 0;  // 0 without a draft
  std::uint32_t round_ = 0;
  int pause_ = 0;       // rounds, after the last time that the condition has not held
  int rounds_off_ = 0;  // of it that are left
};

}  // namespace pathrace::algorithms
