#include "bench/roster.hpp"

#include <algorithm>
#include <iterator>
#include <memory>

#include "algorithms/algorithms.hpp"
#include "baselines/baselines.hpp"
#include "baselines/navigators/replan.hpp"

namespace pathrace::bench {
namespace {

std::shared_ptr<const Catalogue> planners_of_maps(const std::vector<PlannerCard>& cards) {
  std::vector<PlannerCard> chosen;
  std::copy_if(cards.begin(), cards.end(), std::back_inserter(chosen),
               [](const PlannerCard& card) { return !card.navigates(); });
  return std::make_shared<const Catalogue>(std::move(chosen), baselines::absent_planners());
}

}  // namespace

const Catalogue& roster() {
  static const Catalogue catalogue = [] {
    std::vector<PlannerCard> cards = algorithms::cards();
    std::vector<PlannerCard> yardsticks = baselines::cards();
    cards.insert(cards.end(), std::make_move_iterator(yardsticks.begin()),
                 std::make_move_iterator(yardsticks.end()));
    cards.push_back(baselines::replan_card(planners_of_maps(cards)));
    return Catalogue(std::move(cards), baselines::absent_planners());
  }();
  return catalogue;
}

}  // namespace pathrace::bench
