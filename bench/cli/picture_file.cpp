#include "bench/cli/picture_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "bench/run_folder.hpp"
#include "core/error.hpp"
#include "results/picture_png.hpp"
#include "results/svg.hpp"

namespace pathrace::bench::cli {
namespace {

// ".html, .png or .svg"
std::string listed(const std::vector<std::string>& words) {
  std::string list = words.front();
  for (std::size_t i = 1; i < words.size(); ++i) {
    list += (i + 1 == words.size() ? " or " : ", ") + words[i];
  }
  return list;
}

}  // namespace

void require_extension(const std::string& file, const std::vector<std::string>& extensions) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) return;
  throw InputError(fmt::format("{}: expected a {} file", file, listed(extensions)));
}

void require_svg_size(const std::string& file, const Scenario& scenario) {
  constexpr std::int64_t most = std::int64_t{1} << 24;
  if (scenario.world) return;
  const OccupancyGrid& grid = scenario.grid();
  if (std::int64_t{grid.width()} * grid.height() <= most) return;
  throw InputError(
      fmt::format("{}: a map of {}x{} cells is too large for an SVG picture, expected at most {} "
                  "cells; a PNG picture shows any map",
                  file, grid.width(), grid.height(), most));
}

void write_picture(const std::string& file, const Scenario& scenario, const Answer& answer,
                   const std::string& title) {
  require_extension(file, {".png", ".svg"});
  std::ostringstream bytes;
  if (std::filesystem::path(file).extension() == ".png") {
    results::write_png(bytes, scenario, {title, answer});
  } else {
    require_svg_size(file, scenario);
    results::write_svg(bytes, scenario, {title, answer});
  }
  write_file(file, bytes.str());
}

}  // namespace pathrace::bench::cli
