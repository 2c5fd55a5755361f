// `scenarios export`: a scenario as a file for other tools.
#include <fmt/format.h>

#include <filesystem>
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
#include "scenarios/ros/writer.hpp"
#include "scenarios/text_grid.hpp"

namespace pathrace::bench::cli {
namespace {

struct ExportOptions {
  Subject subject;
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

constexpr std::string_view formats = "map, ros, scen, png, svg, csv or txt";

// Formats that hold a grid alone; false for the others.
bool write_grid_as(const std::string& format, std::ostream& out, const OccupancyGrid& grid) {
  if (format == "map") {
    scenarios::write_map(out, grid);
  } else if (format == "png") {
    scenarios::write_png(out, grid);
  } else if (format == "csv") {
    scenarios::write_text_grid(out, grid, ",");
  } else if (format == "txt") {
    scenarios::write_text_grid(out, grid, "");
  } else {
    return false;
  }
  return true;
}

[[noreturn]] void refuse_format(const std::string& format) {
  throw InputError(fmt::format(
      "--format: {}", unknown_name("format", format, {"map", "ros", "scen", "png", "svg", "csv", "txt"})));
}

void write_as(const std::string& format, std::ostream& out, const Scenario& scenario) {
  if (format == "png" && scenario.world) {
    results::write_png(out, scenario, {scenario.id});
  } else if (format == "scen") {
    scenarios::write_scen(out, file_name_of(scenario.id), scenario);
  } else if (format == "svg") {
    require_svg_size("--format svg", scenario);
    results::write_svg(out, scenario, {scenario.id});
  } else if (!write_grid_as(format, out, scenario.grid())) {
    refuse_format(format);
  }
}

void write_map_as(const std::string& format, std::ostream& out, const std::string& file,
                  const OccupancyGrid& grid) {
  if (write_grid_as(format, out, grid)) return;
  if (format == "scen" || format == "svg") {
    throw InputError(
        fmt::format("{}: a map without start and goal; expected a scenario for --format {}", file, format));
  }
  refuse_format(format);
}

void export_ros(const ExportOptions& options, const OccupancyGrid& grid, const scenarios::MapFrame& frame) {
  const std::filesystem::path yaml = options.out;
  if (yaml.extension() != ".yaml" && yaml.extension() != ".yml") {
    throw InputError(fmt::format(
        "--format ros writes a yaml file and its picture: expected -o FILE.yaml, got '{}'", options.out));
  }
  const std::filesystem::path picture = std::filesystem::path(yaml).replace_extension(".pgm");
  for (const std::filesystem::path& file : {yaml, picture}) {
    std::error_code absent;
    if (options.subject.is_map_file() && std::filesystem::equivalent(file, options.subject.id, absent)) {
      throw InputError(fmt::format("{}: is the map itself; expected another -o FILE.yaml", file.string()));
    }
  }
  std::ostringstream bytes;
  scenarios::write_pgm(bytes, grid);
  write_file(picture, bytes.str());
  std::ostringstream text;
  scenarios::write_map_yaml(text, picture.filename().string(), frame);
  write_file(yaml, text.str());
}

void print_or_write(const ExportOptions& options, const std::string& text) {
  if (options.out.empty()) {
    std::cout << text;
  } else {
    write_file(options.out, text);
  }
}

int export_map(const ExportOptions& options) {
  const scenarios::GridMap map = scenarios::read_map(options.subject.id, map_options(options.subject.map));
  if (options.format == "ros") {
    export_ros(options, *map.grid, map.frame);
    return done;
  }
  std::ostringstream text;
  write_map_as(options.format, text, options.subject.id, *map.grid);
  print_or_write(options, text.str());
  return done;
}

int export_scenario(const ExportOptions& options) {
  if (options.subject.is_map_file()) return export_map(options);
  const Scenario scenario = proven_scenario(options.subject.id, options.subject.maps);
  if (options.format == "ros") {
    const double resolution = options.subject.map.resolution.value_or(1);
    export_ros(options, scenario.grid(),
               {scenario.grid().width(), scenario.grid().height(), resolution, {}, 0});
    return done;
  }
  std::ostringstream text;
  write_as(options.format, text, scenario);
  print_or_write(options, text.str());
  return done;
}

}  // namespace

void add_scenarios_export(CLI::App& parent) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* verb =
      add_verb(parent, "export", "write a scenario or a map file for other tools",
               "dense/20-20/7 --format map -o dense.map", [options] { return export_scenario(*options); });
  verb->add_option("--format", options->format, std::string(formats))->required()->type_name("FORMAT");
  verb->add_option("-o,--out", options->out,
                   "the file (default: standard output); ros: a yaml, the picture lies beside it")
      ->type_name("FILE");
  add_subject_options(*verb, options->subject);
}

}  // namespace pathrace::bench::cli
