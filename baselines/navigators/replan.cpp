// Replanning: before each step the discs become a grid, a planner of static maps plans on it, and the robot
// drives along its path, or along its last one while that is clear and no longer (steer.hpp). The planner's
// evaluations and checks are the navigator's; a disc looked at is one check more. Counted beside them:
// `planning_checks`, the planner's alone.
#include "baselines/navigators/replan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "baselines/navigators/steer.hpp"

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
      : settings_(settings), planners_(std::move(planners)), steering_(settings.resolution, settings.margin) {
    const Entrant entrant = inner_entrant(*planners_, settings_.planner);
    planner_ = entrant.card->make(entrant.values);
  }

  Point next(const Snapshot& snapshot, Context& context) override {
    return steering_.next(snapshot, context.meter,
                          [&](const DiscMap& map, std::size_t) { return plan(map, snapshot, context); });
  }

 private:
  Answer plan(const DiscMap& map, const Snapshot& snapshot, Context& context) const {
    Meter meter(budget_left(context.meter));
    Context inner{context.stream, context.executor, meter};
    Answer answer =
        planner_(map.terrain())->plan(map.cell_of(snapshot.robot), map.cell_of(snapshot.goal), inner);
    context.meter.spend_evaluations(meter.work().evaluations);
    context.meter.spend_checks(meter.work().checks);
    context.meter.count("planning_checks", meter.work().checks);
    return answer;
  }

  Budget budget_left(const Meter& meter) const {
    Budget budget;
    budget.evaluations =
        std::min(static_cast<std::uint64_t>(settings_.evaluations), meter.evaluations_left());
    if (meter.checks_left() != Meter::unlimited) budget.checks = meter.checks_left();
    return budget;
  }

  ReplanSettings settings_;
  Planners planners_;
  Steering steering_;
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
  card.random = false;
  card.version = 2;
  card.summary = "plans anew before each step, with any planner of static maps: replan(astar)";
  card.source = "yardstick of this project";
  card = with_navigator_parameters(
      std::move(card), schema_of(planners),
      [planners](const ReplanSettings& settings) { return std::make_unique<Replan>(settings, planners); });
  card.spell = [planners, cards = card.parameters](const ParameterValues& values) {
    return spell(*planners, cards, values);
  };
  card.inner = [planners](const ParameterValues& values) {
    return inner_entrant(*planners, values.at("planner"));
  };
  return card;
}

}  // namespace pathrace::baselines
