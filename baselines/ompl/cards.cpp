#include "baselines/ompl/cards.hpp"

#include <iterator>

#include "baselines/ompl/families.hpp"

namespace pathrace::baselines {

std::vector<PlannerCard> ompl_cards() {
  std::vector<PlannerCard> cards;
  for (const auto family :
       {ompl_tree_cards, ompl_best_tree_cards, ompl_batch_cards, ompl_roadmap_cards, ompl_cell_cards}) {
    std::vector<PlannerCard> members = family();
    cards.insert(cards.end(), std::make_move_iterator(members.begin()),
                 std::make_move_iterator(members.end()));
  }
  return cards;
}

}  // namespace pathrace::baselines
