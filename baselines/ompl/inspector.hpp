// The inspector answers what a planner asks about free space, and charges it to the trial's meter.
//
// One question, about a point or about a straight motion, is one evaluation; each cell looked at is one
// check. When the budget is spent the answer is "no", free of charge, until the planner asks whether it must
// stop.
#pragma once

#include <cstdint>

#include "baselines/ompl/free_space.hpp"
#include "core/meter.hpp"

namespace pathrace::baselines {

class Inspector {
 public:
  Inspector(const OccupancyGrid& grid, Meter& meter) : space_(grid), meter_(meter) {}

  bool may_be(Point point) {
    if (closed_) return true;
    if (spent()) return space_.at(point, Meter::unlimited).free;
    return charge(space_.at(point, meter_.checks_left()));
  }
  bool may_go(Point from, Point to) {
    return !spent() && charge(space_.along(from, to, meter_.checks_left()));
  }

  /// The planner has been told to stop.
  void close() { closed_ = true; }
  /// For what comes after the planner, on what the budget has left.
  void reopen() { closed_ = false; }
  /// True when no further motion will be allowed.
  bool spent() const {
    return closed_ || meter_.evaluations_left() == 0 || meter_.checks_left() == 0 || meter_.timed();
  }

  const FreeSpace& space() const { return space_; }
  Meter& meter() { return meter_; }

 private:
  bool charge(FreeSpace::Look look) {
    meter_.spend_evaluations(1);
    meter_.spend_checks(look.cells);
    return look.free;
  }

  FreeSpace space_;
  Meter& meter_;
  bool closed_ = false;
};

}  // namespace pathrace::baselines
