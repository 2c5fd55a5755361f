// Pictures as files: the extension says which kind.
#pragma once

#include <string>
#include <vector>

#include "core/planner.hpp"
#include "core/scenario.hpp"

namespace pathrace::bench::cli {

/// Throws InputError that names the file and the extensions it may have, such as ".png".
void require_extension(const std::string& file, const std::vector<std::string>& extensions);

/// Throws InputError when the scenario's map is too large for an SVG picture, which has a rectangle for each
/// run of blocked cells: more than 2^24 cells.
void require_svg_size(const std::string& file, const Scenario& scenario);

/// Writes a .png or .svg picture. Throws InputError for another extension, EnvironmentError when the file
/// cannot be written.
void write_picture(const std::string& file, const Scenario& scenario, const Answer& answer,
                   const std::string& title);

}  // namespace pathrace::bench::cli
