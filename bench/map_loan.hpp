// The map as a planner gets it: shared, or checked.
#pragma once

#include <memory>

#include "core/scenario.hpp"

namespace pathrace::bench {

#ifdef NDEBUG
inline constexpr bool maps_are_checked = false;
#else
inline constexpr bool maps_are_checked = true;
#endif

/// Checked, a planner gets a copy of its own, so that nobody else sees what it does to it; afterwards the
/// copy is compared with the map. One byte per cell, and two passes over it, outside of the planner's time.
class MapLoan {
 public:
  MapLoan(const Terrain& map, bool checked) : map_(map), lent_(map) {
    if (checked) lent_.grid = std::make_shared<OccupancyGrid>(*map.grid);
  }

  const Terrain& terrain() const { return lent_; }
  bool intact() const { return lent_.grid == map_.grid || *lent_.grid == *map_.grid; }

 private:
  Terrain map_;
  Terrain lent_;
};

}  // namespace pathrace::bench
