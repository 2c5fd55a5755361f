#include "baselines/ompl/race.hpp"

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "baselines/ompl/inspector.hpp"
#include "baselines/ompl/plane.hpp"
#include "baselines/ompl/random.hpp"

namespace pathrace::baselines {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

double distance(Point a, Point b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

double length_of(const std::vector<Point>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
  return length;
}

std::vector<Point> points_of(const og::PathGeometric& path) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < path.getStateCount(); ++i) {
    const Point point = point_of(path.getState(static_cast<unsigned>(i)));
    if (points.empty() || point != points.back()) points.push_back(point);
  }
  return points;
}

class Race {
 public:
  Race(const OmplSettings& settings, const Problem& problem, Context& context)
      : settings_(settings),
        start_(centre(problem.start)),
        goal_(centre(problem.goal)),
        meter_(context.meter),
        overlay_(context.overlay),
        inspector_(problem.grid, context.meter),
        si_(inspected_plane(inspector_)),
        problem_(std::make_shared<ob::ProblemDefinition>(si_)) {
    const ob::ScopedState<> start = state_at(start_);
    const ob::ScopedState<> goal = state_at(goal_);
    problem_->addStartState(start);
    const auto region = std::make_shared<ob::GoalState>(si_);
    region->setState(goal);
    if (settings.goal_radius > 0) region->setThreshold(settings.goal_radius);
    problem_->setGoal(region);
    problem_->setIntermediateSolutionCallback(
        [this](const ob::Planner*, const std::vector<const ob::State*>& states, ob::Cost cost) {
          const double length = cost.value() + gap_to_goal(states);
          straight_ = straight_ || length <= distance(start_, goal_) * (1 + 1e-9);
          meter_.improved(length);
        });
  }

  Answer run(const MakeOmplPlanner& make, const ParameterValues& declared) {
    const ob::PlannerPtr planner = make(si_);
    for (const auto& [name, value] : declared) planner->params().setParam(name, affordable(name, value));
    planner->setProblemDefinition(problem_);
    planner->setup();
    planner->solve(ob::PlannerTerminationCondition([this] { return must_stop(); }));
    inspector_.reopen();
    if (!problem_->hasExactSolution()) {
      draw_attempt();
      return std::nullopt;
    }
    Path path{Track::any_angle, points_of(*problem_->getSolutionPath()->as<og::PathGeometric>())};
    if (path.points.back() != goal_) path.points.push_back(goal_);
    report(path.points);
    if (settings_.simplify) simplify(path.points);
    return path;
  }

 private:
  ob::ScopedState<> state_at(Point point) const {
    ob::ScopedState<> state(si_->getStateSpace());
    place(state.get(), point);
    return state;
  }

  // Each sample of a batch is an evaluation: what a larger batch than the budget adds is time and memory.
  std::string affordable(const std::string& name, const std::string& value) const {
    if (name != "samples_per_batch" && name != "num_samples") return value;
    const std::uint64_t most = std::min(meter_.evaluations_left(), meter_.checks_left());
    const std::uint64_t asked = std::stoull(value);
    return asked > most ? std::to_string(most + 1) : value;
  }

  // Asked by the planner once a round. The rounds are the meter's iterations. Nothing is shorter than a
  // straight path, and the library's ordered sampler would look for a better one for ever.
  bool must_stop() {
    const bool enough_calls = settings_.max_calls != 0 && calls_ >= settings_.max_calls;
    if (straight_ || enough_calls || inspector_.spent() || meter_.exhausted()) {
      inspector_.close();
      return true;
    }
    ++calls_;
    meter_.end_iteration();
    return false;
  }

  // The way from a path's end to the goal's centre, where the planner may end beside it. Planners report the
  // states of a path in either order, some without its ends.
  double gap_to_goal(const std::vector<const ob::State*>& states) const {
    if (settings_.goal_radius <= 0 || states.empty()) return 0;
    const double gap =
        std::min(distance(point_of(states.front()), goal_), distance(point_of(states.back()), goal_));
    return gap <= settings_.goal_radius ? gap : 0;
  }

  // The planner's own sum of the same pieces may differ in the last digits.
  void report(const std::vector<Point>& points) {
    const double length = length_of(points);
    if (meter_.trace().empty() || length < meter_.trace().back().cost * (1 - 1e-12)) meter_.improved(length);
  }

  // A path that does not reach the goal is no answer.
  void draw_attempt() const {
    if (overlay_ == nullptr || !problem_->hasSolution()) return;
    overlay_->polyline = points_of(*problem_->getSolutionPath()->as<og::PathGeometric>());
  }

  // On what the search has left of the budget: it never costs a path.
  void simplify(std::vector<Point>& points) {
    const Work before = meter_.work();
    og::PathGeometric path(si_);
    for (const Point point : points) path.append(state_at(point).get());
    og::PathSimplifier simplifier(si_);
    simplifier.simplify(
        path, ob::PlannerTerminationCondition([this] { return inspector_.spent() || meter_.exhausted(); }));
    meter_.count("simplify_evaluations", meter_.work().evaluations - before.evaluations);
    meter_.count("simplify_checks", meter_.work().checks - before.checks);
    std::vector<Point> shorter = points_of(path);
    if (length_of(shorter) >= length_of(points) || !stands(shorter)) return;
    points = std::move(shorter);
    report(points);
  }

  // A simplifier that ran out of budget half-way may leave a piece that nobody has looked at.
  bool stands(const std::vector<Point>& points) const {
    if (points.empty() || points.front() != start_ || points.back() != goal_) return false;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (!inspector_.space().along(points[i - 1], points[i], Meter::unlimited).free) return false;
    }
    return true;
  }

  OmplSettings settings_;
  Point start_;
  Point goal_;
  Meter& meter_;
  Overlay* overlay_;
  Inspector inspector_;
  std::shared_ptr<ob::SpaceInformation> si_;
  std::shared_ptr<ob::ProblemDefinition> problem_;
  std::uint64_t calls_ = 0;
  bool straight_ = false;  // a path as short as the distance has been found
};

}  // namespace

Answer race(const MakeOmplPlanner& make, const OmplSettings& settings, const ParameterValues& declared,
            const Problem& problem, Context& context) {
  require_our_seeds();
  if (context.meter.exhausted()) return std::nullopt;
  if (problem.start == problem.goal) {
    context.meter.spend_evaluations(1);
    context.meter.improved(0);
    return Path{Track::any_angle, {centre(problem.start)}};
  }
  const RandomScope seeds(context.stream);
  return Race(settings, problem, context).run(make, declared);
}

}  // namespace pathrace::baselines
