#include "bench/cli/plan_question.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/error.hpp"
#include "scenarios/library.hpp"
#include "scenarios/map_questions.hpp"
#include "scenarios/under_rule.hpp"

namespace pathrace::bench::cli {
namespace {

using scenarios::MapPlace;
using scenarios::MapQuestions;
using scenarios::WorldPoint;

// One end of the way, in cells or in metres.
MapPlace chosen_place(const MapQuestions& map, const std::string& option, const std::string& cell,
                      const std::string& metres) {
  if (cell.empty() == metres.empty()) {
    throw InputError(fmt::format("--map needs either {0} X,Y or {0}-m X,Y", option));
  }
  if (metres.empty()) return map.at(parse_cell(option, cell));
  const Point point = parse_point(option + "-m", metres);
  return map.at(WorldPoint{point.x, point.y});
}

Asked ask_on_map(const PlanQuestion& question) {
  const MapQuestions map(question.map, map_options(question.map_options));
  const MapPlace start = chosen_place(map, "--start", question.start, question.start_m);
  const MapPlace goal = chosen_place(map, "--goal", question.goal, question.goal_m);
  Asked asked{map.between(start, goal), std::nullopt};
  if (map.map().measured || question.in_metres()) asked.frame = map.frame();
  return asked;
}

}  // namespace

void add_question_options(CLI::App& command, PlanQuestion& question) {
  command.add_option("--scenario", question.scenario, "a scenario of the library")->type_name("ID");
  command
      .add_option("--map", question.map,
                  "a map file (.map .yaml .yml .pgm .ppm .pbm .png .bmp .csv .txt), with --start and --goal")
      ->type_name("FILE");
  command.add_option("--start", question.start, "a cell; 0,0 is the upper left")->type_name("X,Y");
  command.add_option("--goal", question.goal, "a cell")->type_name("X,Y");
  command
      .add_option("--start-m", question.start_m,
                  "the same in metres of the map's frame; so is the answer then")
      ->type_name("X,Y");
  command.add_option("--goal-m", question.goal_m, "the same in metres")->type_name("X,Y");
  add_map_file_options(command, question.map_options);
  command
      .add_option("--maps", question.maps, "folder of recorded maps, for movingai/... and ros/... scenarios")
      ->type_name("DIR");
  command
      .add_option("--rule", question.rule, "four, strict, squeeze or free (default: the scenario's, strict)")
      ->type_name("RULE");
}

Asked ask(const PlanQuestion& question) {
  if (question.scenario.empty() == question.map.empty()) {
    throw InputError("expected either --scenario ID or --map FILE --start X,Y --goal X,Y");
  }
  Asked asked;
  if (question.map.empty()) {
    asked.scenario = scenarios::Library(maps_folder(question.maps)).load(question.scenario);
  } else {
    asked = ask_on_map(question);
  }
  if (!question.rule.empty()) {
    const auto rule = parse_name<MoveRule>("move rule", question.rule);
    if (asked.scenario.world) throw InputError("--rule: there are no moves of cells in a dynamic world");
    asked.scenario = scenarios::under_rule(std::move(asked.scenario), rule);
  }
  scenarios::prove(asked.scenario);
  return asked;
}

}  // namespace pathrace::bench::cli
