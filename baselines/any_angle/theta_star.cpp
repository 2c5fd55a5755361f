// Theta* and Lazy Theta*, as planners.
#include "baselines/any_angle/theta_search.hpp"
#include "core/catalogue.hpp"

namespace pathrace::baselines {
namespace {

PlannerCard theta_card(std::string name, std::string summary, std::string source, Looking looking) {
  PlannerCard card;
  card.name = std::move(name);
  card.kind = Kind::any_angle;
  card.random = false;
  card.complete_search = true;
  card.track = Track::any_angle;
  card.summary = std::move(summary);
  card.source = std::move(source);
  return without_parameters(std::move(card),
                            [looking](const Terrain& terrain) -> std::unique_ptr<MapPlanner> {
                              return std::make_unique<ThetaSearch>(terrain, looking);
                            });
}

}  // namespace

PlannerCard theta_star_card() {
  return theta_card("theta-star", "Theta*: A* whose cells take for parent what they see; nearly shortest",
                    "A. Nash, K. Daniel, S. Koenig, A. Felner, AAAI 2007", Looking::at_reaching);
}

PlannerCard lazy_theta_star_card() {
  return theta_card("lazy-theta-star", "Lazy Theta*: Theta* that looks once per cell expanded",
                    "A. Nash, S. Koenig, C. Tovey, AAAI 2010", Looking::at_expanding);
}

}  // namespace pathrace::baselines
