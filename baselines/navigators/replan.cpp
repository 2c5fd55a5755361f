// Replanning: before each step the discs become a grid, a planner of static maps plans on it, and the robot
// drives towards the farthest point of the path that it can see.
//
// Discs grow by the robot's radius and by `margin` cells: from 0.75 cells on, a path from cell to cell cannot
// cut a disc. Where nothing is found, discs grow by the radius alone; where still nothing is found, the robot
// waits, and steps aside when a disc comes near. The planner's evaluations and checks are the navigator's; a
// disc looked at is one check more.
#include "baselines/navigators/replan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "baselines/navigators/disc_map.hpp"
#include "baselines/navigators/room.hpp"

namespace pathrace::baselines {
namespace {

using Planners = std::shared_ptr<const Catalogue>;

struct ReplanSettings {
  std::string planner = "astar";  // canonical: every parameter, in parentheses when it has some
  double resolution = 1;
  double margin = 0.75;
  int evaluations = 200;
};

// "(as:ants=20)" and "as:ants=20" are the same.
std::string_view without_parentheses(std::string_view text) {
  const bool enclosed = text.size() > 1 && text.front() == '(' && text.back() == ')';
  return enclosed ? text.substr(1, text.size() - 2) : text;
}

Entrant inner_entrant(const Catalogue& planners, std::string_view text) {
  return planners.enter(parse_call(without_parentheses(text)));
}

class Replan final : public Navigator {
 public:
  Replan(const ReplanSettings& settings, Planners planners)
      : settings_(settings), planners_(std::move(planners)) {
    const Entrant entrant = inner_entrant(*planners_, settings_.planner);
    planner_ = entrant.card->make(entrant.values);
  }

  Point next(const Snapshot& snapshot, Context& context) override {
    for (const double margin : {settings_.margin, 0.0}) {
      const std::optional<std::vector<Point>> way = plan(snapshot, margin, context);
      if (!way) continue;
      if (const std::optional<Point> step = step_along(*way, snapshot, context.meter)) return *step;
    }
    return step_aside(snapshot, context.meter);
  }

 private:
  std::optional<std::vector<Point>> plan(const Snapshot& snapshot, double margin, Context& context) const {
    if (!afford(context.meter, snapshot.discs.size())) return std::nullopt;
    const DiscMap map(snapshot, settings_.resolution, margin);
    Meter meter(budget_left(context.meter));
    Context inner{context.stream, context.executor, meter};
    const Answer answer =
        planner_(map.terrain())->plan(map.cell_of(snapshot.robot), map.cell_of(snapshot.goal), inner);
    context.meter.spend_evaluations(meter.work().evaluations);
    context.meter.spend_checks(meter.work().checks);
    if (!answer) return std::nullopt;
    std::vector<Point> way;
    for (const Point point : answer->points) way.push_back(map.place_of(point));
    way.back() = snapshot.goal;
    return way;
  }

  Budget budget_left(const Meter& meter) const {
    Budget budget;
    budget.evaluations =
        std::min(static_cast<std::uint64_t>(settings_.evaluations), meter.evaluations_left());
    if (meter.checks_left() != Meter::unlimited) budget.checks = meter.checks_left();
    return budget;
  }

  // The step towards the farthest point in sight; else the first step that is free at all.
  static std::optional<Point> step_along(const std::vector<Point>& way, const Snapshot& snapshot,
                                         Meter& meter) {
    for (const bool whole : {true, false}) {
      for (std::size_t left = way.size(); left > 0; --left) {
        if (!afford(meter, snapshot.discs.size())) return std::nullopt;
        const Point point = way[left - 1];
        const Point step = kept_inside(snapshot, towards(snapshot.robot, point, snapshot.robot_step));
        if (step != snapshot.robot && is_free_way(snapshot, whole ? point : step)) return step;
      }
    }
    return std::nullopt;
  }

  // Where a disc is nearer than half a step: to the roomiest of nine places in reach, the present one
  // included.
  static Point step_aside(const Snapshot& snapshot, Meter& meter) {
    Point best = snapshot.robot;
    double most = room_at(snapshot, best);
    if (!afford(meter, snapshot.discs.size() * 17) || most >= snapshot.robot_step / 2) return best;
    for (const Point direction :
         {Point{1, 0}, {0.6, 0.8}, {0, 1}, {-0.8, 0.6}, {-1, 0}, {-0.6, -0.8}, {0, -1}, {0.8, -0.6}}) {
      const Point place = kept_inside(snapshot, {snapshot.robot.x + snapshot.robot_step * direction.x,
                                                 snapshot.robot.y + snapshot.robot_step * direction.y});
      const double room = room_at(snapshot, place);
      if (room <= most || !is_free_way(snapshot, place)) continue;
      most = room;
      best = place;
    }
    return best;
  }

  ReplanSettings settings_;
  Planners planners_;
  Planner planner_;
};

Field<ReplanSettings> planner_field(const Planners& planners) {
  Field<ReplanSettings> field;
  field.card = {"planner",
                "planner",
                "",
                "NAME or (NAME:key=value,...)",
                "",
                Source::ours,
                "plans each step; `replan(NAME)` says the same"};
  field.read = [planners](ReplanSettings& settings, std::string_view text) {
    const std::string call = inner_entrant(*planners, text).full_call();
    settings.planner = call.find(':') == std::string::npos ? call : "(" + call + ")";
  };
  field.print = [](const ReplanSettings& settings) { return settings.planner; };
  return field;
}

Schema<ReplanSettings> schema_of(const Planners& planners) {
  return {{
      planner_field(planners),
      real("resolution", &ReplanSettings::resolution, 0.25, 100, "units", Source::ours, "edge of a cell"),
      real("margin", &ReplanSettings::margin, 0, 100, "cells", Source::ours,
           "kept from discs beside the radius"),
      integer("evaluations", &ReplanSettings::evaluations, 1, 1000000, "evaluations", Source::ours,
              "the planner's budget for a step"),
  }};
}

// replan(as:ants=20):resolution=2
std::string spell(const Catalogue& planners, const std::vector<ParameterCard>& cards,
                  const ParameterValues& values) {
  std::string text = fmt::format("replan({})", inner_entrant(planners, values.at("planner")).label);
  char separator = ':';
  for (const ParameterCard& card : cards) {
    const std::string& value = values.at(card.name);
    if (card.name == "planner" || value == card.default_value) continue;
    text += fmt::format("{}{}={}", std::exchange(separator, ','), card.name, value);
  }
  return text;
}

}  // namespace

PlannerCard replan_card(const std::shared_ptr<const Catalogue>& planners) {
  PlannerCard card;
  card.name = "replan";
  card.kind = Kind::navigator;
  card.summary = "plans anew before each step, with any planner of static maps: replan(astar)";
  card.source = "yardstick of this project";
  card = with_navigator_parameters(
      std::move(card), schema_of(planners),
      [planners](const ReplanSettings& settings) { return std::make_unique<Replan>(settings, planners); });
  card.spell = [planners, cards = card.parameters](const ParameterValues& values) {
    return spell(*planners, cards, values);
  };
  return card;
}

}  // namespace pathrace::baselines
