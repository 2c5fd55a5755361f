// The referee: judges an answer without a line of the planners' code.
//
// It spells the four move rules and the any-angle rule out from the cells themselves, so that a mistake in
// the table that planners share cannot hide behind itself.
//
// Any-angle rule: a blocked cell is the open square of side 1 around its centre. A segment may touch an
// edge or a corner, may not enter a square, and may not pass between two blocked cells that touch at a
// corner or share an edge. What lies outside the map is blocked.
#pragma once

#include <optional>
#include <string>

#include "core/distance_transform.hpp"
#include "core/metrics.hpp"
#include "core/path.hpp"
#include "core/scenario.hpp"

namespace pathrace {

struct Judgement {
  std::string fault;                   ///< empty when the path is legal
  std::optional<PathMetrics> metrics;  ///< of a legal path, recomputed from its points

  bool legal() const { return fault.empty(); }
};

class Referee {
 public:
  explicit Referee(const Terrain& terrain);

  /// Safe to call from several threads at once.
  Judgement judge(const Path& path, Cell start, Cell goal) const;

 private:
  std::string fault_of(const Path& path, Cell start, Cell goal) const;

  Terrain terrain_;
  DistanceTransform clearance_;
};

}  // namespace pathrace
