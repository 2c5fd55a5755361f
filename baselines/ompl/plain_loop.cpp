#include "baselines/ompl/plain_loop.hpp"

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>

#include <cmath>
#include <memory>

#include "baselines/ompl/random.hpp"

namespace pathrace::baselines {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

using Values = ob::RealVectorStateSpace::StateType;

std::shared_ptr<ob::SpaceInformation> sampled_plane(const OccupancyGrid& grid, std::uint64_t& lookups) {
  const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  ob::RealVectorBounds bounds(2);
  bounds.setLow(-0.5);
  bounds.setHigh(0, grid.width() - 0.5);
  bounds.setHigh(1, grid.height() - 0.5);
  space->setBounds(bounds);
  auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker([&grid, &lookups](const ob::State* state) {
    ++lookups;
    const double* at = state->as<Values>()->values;
    return grid.is_free(
        {static_cast<int>(std::floor(at[0] + 0.5)), static_cast<int>(std::floor(at[1] + 0.5))});
  });
  si->setStateValidityCheckingResolution(0.005);
  si->setup();
  return si;
}

ob::PlannerPtr planner_of(PlainPlanner kind, const std::shared_ptr<ob::SpaceInformation>& si) {
  if (kind == PlainPlanner::rrt_connect) return std::make_shared<og::RRTConnect>(si);
  return std::make_shared<og::RRTstar>(si);
}

}  // namespace

PlainRun plain_loop(PlainPlanner kind, const Problem& problem, const Stream& stream, std::uint64_t calls) {
  ompl::msg::noOutputHandler();
  const RandomScope seeds(stream);
  PlainRun run;
  const auto si = sampled_plane(problem.grid, run.lookups);
  const auto definition = std::make_shared<ob::ProblemDefinition>(si);
  ob::ScopedState<ob::RealVectorStateSpace> start(si->getStateSpace());
  ob::ScopedState<ob::RealVectorStateSpace> goal(si->getStateSpace());
  start[0] = problem.start.x;
  start[1] = problem.start.y;
  goal[0] = problem.goal.x;
  goal[1] = problem.goal.y;
  definition->setStartAndGoalStates(start, goal);
  const ob::PlannerPtr planner = planner_of(kind, si);
  planner->setProblemDefinition(definition);
  planner->setup();
  planner->solve(ob::PlannerTerminationCondition([&calls] { return calls == 0 || --calls == 0; }));
  run.solved = definition->hasExactSolution();
  return run;
}

}  // namespace pathrace::baselines
