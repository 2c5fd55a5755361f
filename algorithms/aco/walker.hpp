// Walkers: they walk the ants of an iteration, several at a time.
//
// One step of one ant is a chain of dependent instructions: weights, sums, comparison, next cell, next
// weights. A walker keeps a few ants on the way and lets each take a step in turn, so that one's waiting is
// another's work; the draws of all of them are made at once. Each ant draws from its own stream, so who walks
// beside it changes nothing.
//
// A lane is the memory of one ant under way: the directions of its path, and a byte per cell with the mark of
// the last ant that stood there. Ants of a lane take the marks 1 to 255 in turn; only then are they wiped.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "algorithms/aco/ant_queue.hpp"
#include "algorithms/aco/choice.hpp"
#include "algorithms/aco/dead_end.hpp"
#include "algorithms/aco/early_deposits.hpp"
#include "algorithms/aco/hand_over.hpp"
#include "algorithms/aco/nest.hpp"
#include "algorithms/aco/roll_call.hpp"
#include "algorithms/aco/trail.hpp"
#include "algorithms/aco/walk.hpp"
#include "algorithms/draws.hpp"
#include "core/meter.hpp"
#include "core/stream.hpp"

namespace pathrace::algorithms {

/// What all ants of a colony share while they walk.
struct Ground {
  const Nest& nest;
  const Trail& trail;
  DeadEnd dead_end = DeadEnd::die;
  double q0 = 0;                ///< chance of the best step instead of eq. (1)
  std::uint64_t max_steps = 0;  ///< a walk of more decisions is given up
  bool keep_the_dead = false;   ///< keep the path of ants that did not arrive
  bool keep_popped = false;     ///< keep the steps that were taken back
  bool count_turns = false;     ///< walks know their turns
};

/// What all ants of an iteration share.
struct Outing {
  const Stream& stream;      ///< ant i draws from stream.fork(i)
  std::uint64_t step_limit;  ///< decisions of an ant
  const Meter& meter;
  std::vector<Walk>& walks;       ///< a slot per ant
  std::uint32_t round = 0;        ///< in which those who are back sign
  RollCall* roll_call = nullptr;  ///< where they sign, if somebody waits for them
};

/// Runs ants one after another or side by side. Not for use by two threads at once.
/// On lines of its own: neighbours belong to threads of their own.
class alignas(128) Walker {
 public:
  /// Beyond the first-level cache: whether what a step reads is worth asking for ahead of time.
  static constexpr bool is_far(std::size_t cells) { return cells > 1U << 12; }

  /// As many lanes as are fastest on a map of this many cells: the further away what ants read is, the more
  /// of a step is waiting, and the more ants are needed to fill the wait. Fewer again where their memory
  /// would run to gigabytes.
  static constexpr std::size_t lanes_for(std::size_t cells) {
    if (!is_far(cells) || cells >= 1U << 21) return 4;
    return cells > 1U << 15 ? 12 : 8;
  }

  /// 1 to Draws::capacity lanes.
  explicit Walker(const Ground& ground, std::size_t lanes);
  Walker(const Walker&) = delete;
  Walker& operator=(const Walker&) = delete;

  /// From now on the two, and all that either has joined, hand ants over. They have the same ground, number
  /// of lanes and outings.
  void join(Walker& other) { hand_over_.join(other.hand_over_); }

  /// Walks ants of the queue until it is empty: one draw per decision (loop erasure draws twice when it is
  /// stuck), to the goal, to death, or to the limit; then takes ants over from walkers it has joined, until
  /// these have none to give. With `deposits`, goes on with them when ants are back; without, reads the rows
  /// for others while there are some. Returns how many ants it has taken over.
  std::size_t run(AntQueue& ants, const Outing& outing, EarlyDeposits* deposits = nullptr);

 private:
  static constexpr std::uint64_t clock_interval = 1024;

  // What a step of an ant reads and changes.
  struct Foot {
    std::uint32_t cell = 0;
    std::uint32_t behind = 0;   // the cell before, not marked yet
    std::uint32_t further = 0;  // the cell before that, not marked yet
    std::uint8_t mark = 0;
    RecentSteps recent;
    std::uint8_t* marks = nullptr;  // of padded index 0
    std::uint8_t* first = nullptr;  // direction of the path; the byte before it may be read
    std::uint8_t* next = nullptr;   // where the next direction goes
    std::uint64_t left = 0;         // decisions until limits and clock are looked at

    std::size_t length() const { return static_cast<std::size_t>(next - first); }
  };

  struct alignas(64) Lane : Foot {
    std::uint64_t pause = 0;  // how many decisions there will have been when limits and clock are looked at
    std::size_t ant = 0;
    std::vector<std::uint8_t> mark_bytes;  // framed, so that a row beyond the padded grid can be read
    std::vector<std::uint8_t> path_bytes;
    std::vector<std::uint32_t> place;  // path length at which a cell was entered, from 1; loop erasure only
    std::vector<Step> popped;

    std::uint64_t decisions() const { return pause - left; }
    // Of n steps, p of them back, a path is n - 2p long; a last decision may have brought nothing but death.
    // Steps into loops are no steps back, and with places there are no others.
    std::uint64_t pops() const { return place.empty() ? (decisions() - length()) / 2 : 0; }
  };

  // By a mask of directions, how far off a step in the first of them leads, in cells; 0 for none.
  using FirstOffsets = std::array<std::int32_t, 1U << direction_count>;

  // What does not change while lanes run: a copy on the stack, which no store can be suspected to alter.
  struct Terms {
    Terms(const Ground& ground, const TrailRow* trail_rows, const FirstOffsets& first);

    std::uint32_t offset(int direction) const {
      return static_cast<std::uint32_t>(offsets[static_cast<std::size_t>(direction)]);
    }
    std::uint32_t first_offset(unsigned mask) const {
      return static_cast<std::uint32_t>(first_offsets[mask]);
    }

    const TrailRow* rows;
    const std::int32_t* first_offsets;
    std::array<std::int32_t, direction_count> offsets{};
    std::ptrdiff_t stride;
    std::uint32_t goal;
    float least_strength;
    float q0;
  };

  enum class Outcome { goes_on, arrived, died };

  // Where a step leads.
  struct Turn {
    int direction;  // no_choice when stuck, unless that backs up
    int back;       // 1 when it takes the last step back
    std::uint32_t target;
  };

  // How ants walk: what the loop over their steps is compiled for.
  struct Gait {
    bool greedy;
    bool with_places;
    bool backs_up;  // a stuck ant steps back by the same instructions as one that goes on
    bool far;
  };

  template <Gait gait>
  std::size_t run_lanes(AntQueue& ants);
  template <Gait gait>
  std::size_t walk_side_by_side(AntQueue& ants, std::size_t under_way, const TrailRow* rows);
  template <Gait gait>
  void walk_one_by_one(AntQueue& ants, const TrailRow* rows);
  /// What a step is made of is inline, whatever else is called: the loop would lose a seventh of its speed.
  template <Gait gait>
  [[gnu::always_inline]] inline Outcome step(std::size_t k, const Terms& terms);
  /// Steps of lane 0, to one that does not simply go on, or to the next look at the clock.
  template <Gait gait>
  [[gnu::noinline]] Outcome walk_alone(const TrailRow* rows);
  [[gnu::always_inline]] static inline ChoicePoint choice_point(const Foot& foot, const Terms& terms);
  /// In few instructions.
  template <Gait gait>
  [[gnu::always_inline]] static inline Turn turn_at(const Foot& foot, std::uint64_t bits, const Terms& terms);
  /// In little time.
  template <Gait gait>
  [[gnu::always_inline]] static inline Turn turn_soon(const Foot& foot, std::uint64_t bits,
                                                      const Terms& terms);
  /// When it is stuck and cannot even step back, an ant dies.
  template <Gait gait>
  [[gnu::always_inline]] static inline Outcome take(Foot& foot, std::uint32_t* place, const Turn& turn,
                                                    const Terms& terms);
  [[gnu::noinline]] void begin(std::size_t k, std::size_t ant);
  [[gnu::noinline]] void finish(Lane& lane, bool arrived);
  /// Asks for what the next step reads, while other lanes take theirs. Inline, or g++ would drop the calls
  /// (core/prefetch.hpp); its way out of that would cost the inner loop a tenth of its speed.
  [[gnu::always_inline]] static inline void fetch(const Foot& foot, const TrailRow* row,
                                                  std::ptrdiff_t stride) {
    const std::uint8_t* marks = foot.marks + foot.cell;
    __builtin_prefetch(row);
    __builtin_prefetch(marks - stride);
    __builtin_prefetch(marks);
    __builtin_prefetch(marks + stride);
  }
  /// Gives the last half of so many lanes away, to the walker that asks. Returns how many are left.
  [[gnu::noinline]] std::size_t give(std::size_t under_way);
  bool may_go_on(Lane& lane) const;
  /// Marks what is not marked yet.
  static void settle(Lane& lane);
  void move(Lane& lane, int direction) const;
  /// Bit d is set when the step is open and leads to a cell the ant has not been on. The lane is settled.
  unsigned unvisited(const Lane& lane) const;
  Outcome stuck(std::size_t k);
  Outcome back_up(Lane& lane) const;
  Outcome revisit(std::size_t k);

  const Ground& ground_;
  std::vector<Lane> lanes_;
  Draws draws_;                             // a column per lane
  std::vector<const std::uint8_t*> paths_;  // where an ant's path was written last, if by this walker
  // of the current run
  const Outing* outing_ = nullptr;
  EarlyDeposits* deposits_ = nullptr;
  std::uint64_t limit_ = 0;
  FirstOffsets first_offsets_{};
  HandOver hand_over_{*this};
};

}  // namespace pathrace::algorithms
