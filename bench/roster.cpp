#include "bench/roster.hpp"

#include <iterator>

#include "algorithms/algorithms.hpp"
#include "baselines/baselines.hpp"

namespace pathrace::bench {

const Catalogue& roster() {
  static const Catalogue catalogue = [] {
    std::vector<PlannerCard> cards = algorithms::cards();
    std::vector<PlannerCard> yardsticks = baselines::cards();
    cards.insert(cards.end(), std::make_move_iterator(yardsticks.begin()),
                 std::make_move_iterator(yardsticks.end()));
    return Catalogue(std::move(cards));
  }();
  return catalogue;
}

}  // namespace pathrace::bench
