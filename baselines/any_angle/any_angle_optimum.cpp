// The reference of the any-angle track, as a planner.
#include "baselines/any_angle/taut_search.hpp"
#include "core/catalogue.hpp"

namespace pathrace::baselines {

PlannerCard any_angle_optimum_card() {
  PlannerCard card;
  card.name = "any-angle-optimum";
  card.kind = Kind::any_angle;
  card.random = false;
  card.complete_search = true;
  card.track = Track::any_angle;
  card.summary = "a proven shortest path for a point robot: A* over taut paths around corners";
  card.source = "S. Oh, H. W. Leong, SoCS 2017 (taut paths); D. Harabor et al., JAIR 56, 2016 (Anya)";
  return without_parameters(std::move(card), [](const Terrain& terrain) -> std::unique_ptr<MapPlanner> {
    return std::make_unique<TautSearch>(terrain);
  });
}

}  // namespace pathrace::baselines
