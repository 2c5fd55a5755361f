// The pheromone trail of a grid, and what ants read of it.
//
// One cache line per padded cell: eight strengths tau^alpha and eight desirabilities eta^beta, one per
// direction. The weight of eq. (1) is their product, made while an ant chooses, so that a deposit touches one
// float and nothing has to be refreshed. Desirabilities are 0 where a step is closed and are divided by the
// largest eta of their row first: probabilities stay the same, and beta = 20 on a large map does not
// underflow.
//
// Evaporation is a factor of the whole trail, which leaves eq. (1) as it is: tau = scale * stored. So an
// iteration costs what its ants touch, not the map. The lower limit is exact all the same: a step that
// nobody touches only decays, so its tau is the larger of what is stored and the limit, whenever it is read.
// What would break that (an upper limit or a lower one that falls, a scale too small for floats) rewrites
// the whole trail; it is rare.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "algorithms/aco/held_path.hpp"
#include "algorithms/aco/huge_pages.hpp"
#include "algorithms/aco/row_marks.hpp"
#include "algorithms/aco/trail_row.hpp"
#include "core/moves.hpp"

namespace pathrace::algorithms {

class Trail {
 public:
  /// eta of the step in `direction` from the cell with this padded index; positive.
  using Heuristic = std::function<double(std::size_t index, int direction)>;

  static constexpr double no_limit = std::numeric_limits<double>::infinity();

  Trail(const MoveTable& moves, double initial, double alpha, double beta, const Heuristic& eta);

  const TrailRow* rows() const { return rows_.data(); }
  /// The least strength that counts: the lower limit in the units of TrailRow::strength.
  float least_strength() const { return least_strength_; }
  /// What an ant weighs the step with, up to a factor of the row; 0 for closed steps.
  float weight(std::size_t index, int direction) const;

  /// True when every open step has a weight: no product of strength and desirability underflows.
  bool every_step_weighs() const { return least_strength_ * least_desirability_ > 0; }

  double pheromone(std::size_t index, int direction) const;
  /// tau := value, within the limits.
  void set(std::size_t index, int direction, double value);
  /// tau := value on every step, within the limits.
  void reset(double value);

  /// tau := max(persistence * tau, lower limit) on every step.
  void evaporate(double persistence);
  /// tau := factor * tau + amount on one step, within the limits. factor >= 0.
  void change(std::size_t index, int direction, double factor, double amount);
  /// The same, on the step back too when `both_ways`.
  void change(std::size_t index, int direction, double factor, double amount, bool both_ways) {
    change(index, direction, factor, amount);
    if (both_ways) change(moves_.step(index, direction), opposite(direction), factor, amount);
  }
  void deposit(std::size_t index, int direction, double amount, bool both_ways) {
    change(index, direction, 1, amount, both_ways);
  }

  /// `change` on each step of a path from `index` on. Threads may do so at the same time when the
  /// steps that they change are out of different cells.
  void change_along(std::size_t index, std::span<const std::uint8_t> directions, double factor, double amount,
                    bool both_ways);

  class Deposits;

  /// From now on there is room for a draft, if alpha is 1. Before any thread reads the trail.
  void keep_draft();
  /// Begins a draft of the next trail: this one with `persistence` times its pheromone. What ants read stays
  /// as it is until the draft is adopted; the limits stay as they are until then. False when there can be
  /// none: there is no room, or the whole trail is due for rewriting. While no other thread reads the trail.
  bool begin_draft(double persistence);
  /// `change_along` on the draft, with factor 1 and amount >= 0. The trail may be read meanwhile.
  void deposit_on_draft(std::size_t index, std::span<const std::uint8_t> directions, double amount,
                        bool both_ways);
  /// The same with any factor.
  void change_draft_along(std::size_t index, std::span<const std::uint8_t> directions, double factor,
                          double amount, bool both_ways);
  /// The draft becomes the trail: bit by bit what `evaporate` and the same changes would have made of it.
  void adopt_draft();
  /// No draft is under way. While no other thread reads the trail.
  void drop_draft() { drafting_ = false; }
  /// The rows for threads that do not deposit, as long as a draft is under way. A row that two cores read and
  /// one of them writes changes cores again and again; so they have copies.
  const TrailRow* rows_for_others() const { return drafting_ ? copies_.data() : rows_.data(); }
  /// Asks for the copies that have changed when the draft was begun: another core has written them.
  void fetch_copies() const;
  /// Asks for the copies that are likely to be written next, once no other thread reads them any more.
  void claim_copies() const;

  /// Keeps every tau in lower..upper from now on. 0 <= lower <= upper.
  void limit(double lower, double upper);
  double lower_limit() const { return lower_; }
  double upper_limit() const { return upper_; }

  /// No ant takes this step any more.
  void close(std::size_t index, int direction) {
    rows_[index].desirability[static_cast<std::size_t>(direction)] = 0;
    if (draft_.empty()) return;
    draft_[index].desirability[static_cast<std::size_t>(direction)] = 0;
    copies_[index].desirability[static_cast<std::size_t>(direction)] = 0;
  }

 private:
  // The bounds of what is stored, at a scale.
  struct Bounds {
    float least = 0;  // lower limit / scale
    float most = 0;   // upper limit / scale
  };

  using Rows = std::vector<TrailRow, HugePages<TrailRow>>;
  using Stored = std::array<float, direction_count>;

  float& stored(std::size_t index, int direction);
  const float& stored(std::size_t index, int direction) const;
  float strength_of(float stored) const;
  void change_strengths(std::size_t index, std::span<const std::uint8_t> directions, double factor,
                        double amount, bool both_ways);
  void mark_changes(std::size_t index, std::span<const std::uint8_t> directions, bool both_ways);
  /// These make the copies, and the draft, what the trail is.
  void write_copies();
  void fill_draft();
  /// The rows whose copies are due.
  void list_copied();
  template <typename Change>
  void visit_draft(std::size_t index, std::span<const std::uint8_t> directions, bool both_ways,
                   const Change& change);
  std::span<const std::uint32_t> copied() const { return {copied_.data(), copied_count_}; }
  Bounds bounds_at(double scale) const;
  void rescale();
  /// Multiplies every tau out, within the limits; the scale is 1 afterwards.
  void rewrite(double persistence = 1);
  void rewrite_strengths();

  const MoveTable& moves_;
  RowSteps steps_;
  double alpha_;
  double scale_ = 1;
  double smallest_scale_;
  double lower_ = 0;
  double upper_ = no_limit;
  float least_ = 0;  // lower_ / scale_
  float most_ = 0;   // upper_ / scale_
  float least_strength_ = 0;
  float least_desirability_ = 1;  // of legal steps
  float unit_ = 1;                // stored tau whose strength is 1, when alpha is not 1
  Rows rows_;
  std::vector<Stored> stored_;         // tau / scale, when alpha is not 1; else the strengths themselves
  RowMarks changed_;                   // rows, since a draft was adopted last and by that
  Rows copies_;                        // of rows, for other threads; empty when no draft is kept
  std::vector<std::uint32_t> copied_;  // first the rows whose copies were written when a draft was begun last
  std::size_t copied_count_ = 0;       // how many those are
  RowMarks listed_;                    // the same rows
  bool drafting_ = false;              // a draft is under way, and the copies are those of the trail

  // What a thread writes while others read the trail: on lines of its own. An adopted draft and the trail
  // change places, so that few rows have to be copied for the next one.
  alignas(128) Rows draft_;  // of the same desirabilities; empty when none is kept
  RowMarks drafted_;         // rows, by changes of the draft
  HeldPath held_;            // of the draft, or of the rows while there are Deposits
  double draft_scale_ = 1;
  Bounds draft_bounds_;
  bool draft_is_close_ = false;  // it differs from the trail in changed rows only, and so do the copies
  bool draft_is_due_ = false;    // it was begun and not filled yet, which may be done while others walk
};

/// Deposits on a trail, one after another. It has all of them once this is gone; nobody reads it before.
class Trail::Deposits {
 public:
  explicit Deposits(Trail& trail) : trail_(trail) { trail_.held_.drop(); }
  Deposits(const Deposits&) = delete;
  Deposits& operator=(const Deposits&) = delete;
  ~Deposits() { trail_.held_.end(); }

  /// `change_along` with factor 1 and amount >= 0.
  void add(std::size_t index, std::span<const std::uint8_t> directions, double amount, bool both_ways);

 private:
  Trail& trail_;
};

}  // namespace pathrace::algorithms
