// `scenarios export`: a scenario as a file for other tools.
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <sstream>

#include "bench/cli/picture_file.hpp"
#include "bench/cli/scenarios/verb.hpp"
#include "bench/run_folder.hpp"
#include "core/error.hpp"
#include "results/picture_png.hpp"
#include "results/svg.hpp"
#include "scenarios/image/png_writer.hpp"
#include "scenarios/movingai/writer.hpp"
#include "scenarios/text_grid.hpp"

namespace pathrace::bench::cli {
namespace {

struct ExportOptions {
  std::string id;
  std::string maps;
  std::string format;
  std::string out;
};

std::string file_name_of(const std::string& id) {
  std::string file = id;
  for (char& c : file) {
    if (c == '/') c = '-';
  }
  return file + ".map";
}

void write_as(const std::string& format, std::ostream& out, const Scenario& scenario) {
  if (format == "png" && scenario.world) {
    results::write_png(out, scenario, {scenario.id});
  } else if (format == "map") {
    scenarios::write_map(out, scenario.grid());
  } else if (format == "scen") {
    scenarios::write_scen(out, file_name_of(scenario.id), scenario);
  } else if (format == "png") {
    scenarios::write_png(out, scenario.grid());
  } else if (format == "svg") {
    require_svg_size("--format svg", scenario);
    results::write_svg(out, scenario, {scenario.id});
  } else if (format == "csv") {
    scenarios::write_text_grid(out, scenario.grid(), ",");
  } else if (format == "txt") {
    scenarios::write_text_grid(out, scenario.grid(), "");
  } else {
    throw InputError(fmt::format(
        "--format: {}", unknown_name("format", format, {"map", "scen", "png", "svg", "csv", "txt"})));
  }
}

int export_scenario(const ExportOptions& options) {
  const Scenario scenario = proven_scenario(options.id, options.maps);
  std::ostringstream text;
  write_as(options.format, text, scenario);
  if (options.out.empty()) {
    std::cout << text.str();
  } else {
    write_file(options.out, text.str());
  }
  return done;
}

}  // namespace

void add_scenarios_export(CLI::App& parent) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* verb =
      add_verb(parent, "export", "write a scenario as a file", "dense/20-20/7 --format map -o dense.map",
               [options] { return export_scenario(*options); });
  verb->add_option("--format", options->format, "map, scen, png, svg, csv or txt")
      ->required()
      ->type_name("FORMAT");
  verb->add_option("-o,--out", options->out, "the file (default: standard output)")->type_name("FILE");
  add_scenario_options(*verb, options->id, options->maps);
}

}  // namespace pathrace::bench::cli
