// A planner of OMPL as a card of the catalogue.
//
// The list is planners.def, one line for each planner; the files of a family read their lines of it, so that
// the library's large headers are compiled side by side.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/catalogue.hpp"

namespace pathrace::baselines {

using MakeOmplPlanner = std::function<ompl::base::PlannerPtr(const ompl::base::SpaceInformationPtr&)>;

template <typename OmplPlanner>
ompl::base::PlannerPtr make_ompl_planner(const ompl::base::SpaceInformationPtr& si) {
  return std::make_shared<OmplPlanner>(si);
}

/// What a planner does with the time that its first path leaves.
enum class Aim {
  first,  ///< nothing
  best,   ///< improves the path until the budget is spent
};

struct OmplEntry {
  std::string name;
  MakeOmplPlanner make;
  Aim aim = Aim::first;
  std::string summary;
  std::string source;
  ParameterValues defaults = {};  ///< where they differ from those of the adapter and the library
};

PlannerCard ompl_card(const OmplEntry& entry);

}  // namespace pathrace::baselines
