// A* with the exact distance on an empty map as heuristic: octile, or Manhattan under `four`.
#include "baselines/grid/grid_search.hpp"
#include "core/catalogue.hpp"

namespace pathrace::baselines {

PlannerCard astar_card() {
  PlannerCard card;
  card.name = "astar";
  card.kind = Kind::search;
  card.random = false;
  card.complete_search = true;
  card.summary = "A* on the grid: an optimal path, with exact integer costs";
  card.version = 2;
  card.source = "P. Hart, N. Nilsson, B. Raphael, IEEE Trans. SSC 4(2), 1968";
  return without_parameters(std::move(card), [](const Terrain& terrain) -> std::unique_ptr<MapPlanner> {
    if (terrain.rule == MoveRule::four) return grid_search<ManhattanDistance>(terrain);
    return grid_search<OctileDistance>(terrain);
  });
}

}  // namespace pathrace::baselines
