#include "baselines/baselines.hpp"

#include "baselines/ompl_names.hpp"

#ifdef PATHRACE_OMPL
#include <iterator>

#include "baselines/ompl/cards.hpp"
#endif

namespace pathrace::baselines {

#define PATHRACE_PLANNER(card) PlannerCard card();
#include "baselines/planners.def"
#undef PATHRACE_PLANNER

std::vector<PlannerCard> cards() {
  std::vector<PlannerCard> cards = {
#define PATHRACE_PLANNER(card) card(),
#include "baselines/planners.def"
#undef PATHRACE_PLANNER
  };
#ifdef PATHRACE_OMPL
  std::vector<PlannerCard> library = ompl_cards();
  cards.insert(cards.end(), std::make_move_iterator(library.begin()), std::make_move_iterator(library.end()));
#endif
  return cards;
}

std::vector<AbsentPlanner> absent_planners() {
  std::vector<AbsentPlanner> absent;
#ifndef PATHRACE_OMPL
  for (std::string& name : ompl_names()) {
    absent.push_back(
        {std::move(name), "OMPL: apt-get install libompl-dev, then ./pathrace builds again, with it"});
  }
#endif
  return absent;
}

}  // namespace pathrace::baselines
