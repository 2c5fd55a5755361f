// `scenarios show`: one scenario, drawn on the terminal or as a picture.
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <sstream>

#include "bench/cli/picture_file.hpp"
#include "bench/cli/scenarios/verb.hpp"
#include "bench/run_folder.hpp"
#include "core/hash.hpp"
#include "core/plain_text.hpp"
#include "scenarios/ascii.hpp"
#include "scenarios/image/png_writer.hpp"

namespace pathrace::bench::cli {
namespace {

struct ShowOptions {
  Subject subject;
  std::string out;
};

void print_world(const std::string& id, const World& world) {
  fmt::print("{}: {} x {} units, {} discs ({} of them walls), robot of radius {} at {:.2f},{:.2f}\n", id,
             world.width, world.height, world.discs.size(), world.walls, world.robot_radius, world.start.x,
             world.start.y);
  fmt::print("goal at {:.2f},{:.2f}, {}; V_robot {}, V_goal {} (P {}), V_obs {} (P {}), threshold {}\n",
             world.goal.x, world.goal.y, name(world.goal_law), world.robot_step, world.goal_step,
             world.goal_chance, world.disc_step, world.disc_chance, world.arrival);
  fmt::print("{} steps at most, no run takes fewer than {}; hash {}\n", world.max_steps,
             world.least_steps ? std::to_string(*world.least_steps) : "that", hex(world.hash));
}

int show_map(const ShowOptions& options) {
  const std::string& file = options.subject.id;
  const scenarios::GridMap map = scenarios::read_map(file, map_options(options.subject.map));
  if (!options.out.empty()) {
    require_extension(options.out, {".png"});
    std::ostringstream bytes;
    scenarios::write_png(bytes, *map.grid);
    write_file(options.out, bytes.str());
    return done;
  }
  fmt::print("{}\n", escape_controls(describe_map(file, map, options.subject.map)));
  std::fflush(stdout);
  scenarios::print_ascii(std::cout, *map.grid);
  return done;
}

int show_scenario(const ShowOptions& options) {
  if (options.subject.is_map_file()) return show_map(options);
  if (!options.out.empty()) {
    require_extension(options.out, {".png", ".svg"});
    const Scenario scenario = proven_scenario(options.subject.id, options.subject.maps);
    write_picture(options.out, scenario, std::nullopt, scenario.id);
    return done;
  }
  const Scenario scenario = proven_scenario(options.subject.id, options.subject.maps);
  if (scenario.world) {
    print_world(scenario.id, *scenario.world);
    std::fflush(stdout);
    scenarios::print_ascii(std::cout, scenario);
    return done;
  }
  fmt::print("{}: {}x{} cells, {} free, rule {}, start {},{}, goal {},{}, optimum {}\n", scenario.id,
             scenario.grid().width(), scenario.grid().height(), scenario.grid().free_cells(),
             name(scenario.terrain.rule), scenario.start.x, scenario.start.y, scenario.goal.x,
             scenario.goal.y, print_optimum(scenario));
  std::fflush(stdout);
  scenarios::print_ascii(std::cout, scenario);
  return done;
}

}  // namespace

void add_scenarios_show(CLI::App& parent) {
  auto options = std::make_shared<ShowOptions>();
  CLI::App* verb = add_verb(parent, "show", "draw a scenario or a map file on the terminal, or as a picture",
                            "trap-u/20/3", [options] { return show_scenario(*options); });
  verb->add_option("-o,--out", options->out,
                   "draw it into a .png or .svg file instead (a map file: .png, one pixel a cell)")
      ->type_name("FILE");
  add_subject_options(*verb, options->subject);
}

}  // namespace pathrace::bench::cli
