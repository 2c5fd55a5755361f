// Dijkstra's algorithm: A* without a heuristic.
#include "baselines/grid/grid_search.hpp"
#include "core/catalogue.hpp"

namespace pathrace::baselines {

PlannerCard dijkstra_card() {
  PlannerCard card;
  card.name = "dijkstra";
  card.kind = Kind::search;
  card.random = false;
  card.complete_search = true;
  card.summary = "Dijkstra's algorithm on the grid: an optimal path without a heuristic";
  card.version = 2;
  card.source = "E. W. Dijkstra, Numerische Mathematik 1, 1959";
  return without_parameters(std::move(card), grid_search<ZeroDistance>);
}

}  // namespace pathrace::baselines
