// The families of planners.def, each in a file of its own.
#pragma once

#include <vector>

#include "core/catalogue.hpp"

namespace pathrace::baselines {

std::vector<PlannerCard> ompl_tree_cards();
std::vector<PlannerCard> ompl_best_tree_cards();
std::vector<PlannerCard> ompl_batch_cards();
std::vector<PlannerCard> ompl_roadmap_cards();
std::vector<PlannerCard> ompl_cell_cards();

}  // namespace pathrace::baselines
