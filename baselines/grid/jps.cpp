// Jump point search, as a planner.
#include "baselines/grid/jump_point_search.hpp"
#include "core/catalogue.hpp"

namespace pathrace::baselines {

PlannerCard jps_card() {
  PlannerCard card;
  card.name = "jps";
  card.kind = Kind::search;
  card.random = false;
  card.complete_search = true;
  card.summary = "jump point search: an optimal path, scanning 64 cells at a time";
  card.source =
      "D. Harabor, A. Grastien, AAAI 2011 and ICAPS 2014 (block-based scanning, pruning of intermediate "
      "points)";
  return without_parameters(std::move(card), [](const Terrain& terrain) -> std::unique_ptr<MapPlanner> {
    if (fits_small_ring(*terrain.grid)) return std::make_unique<JumpPointSearch<>>(terrain);
    return std::make_unique<JumpPointSearch<LargeRing>>(terrain);
  });
}

}  // namespace pathrace::baselines
