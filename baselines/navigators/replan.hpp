// `replan(PLANNER)`: a navigator made of any planner of static maps.
#pragma once

#include <memory>

#include "core/catalogue.hpp"

namespace pathrace::baselines {

/// `planners`: what PLANNER may be.
PlannerCard replan_card(const std::shared_ptr<const Catalogue>& planners);

}  // namespace pathrace::baselines
