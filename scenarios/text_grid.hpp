// Grids of 0 and 1 as text: a row of the map on each line, 0 free, 1 blocked.
//
// The digits of a row follow one another (`0110`), or stand between separators: a comma, a semicolon, blanks
// or tabs, or one of the two with blanks around it. Between separators a cell may be quoted ("0"), or a
// number that equals 0 or 1 (1.000e+00, as numpy.savetxt writes); one separator may follow the last cell.
// Other numbers are refused: cells have no weights.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <string_view>

#include "core/grid.hpp"

namespace pathrace::scenarios {

/// Throws InputError "FILE:LINE: the value, its column (from 1), what was expected" for anything but rows of
/// one length, InputError for a file that is missing or too large for any map, EnvironmentError when the
/// machine refuses.
OccupancyGrid read_text_grid(const std::filesystem::path& file);
/// The same for a text at hand; `name` stands for the file.
OccupancyGrid parse_text_grid(std::string_view text, const std::string& name);

/// Rows of digits with `separator` between them, or nothing when it is empty. Throws EnvironmentError when
/// the stream fails.
void write_text_grid(std::ostream& out, const OccupancyGrid& grid, std::string_view separator);

}  // namespace pathrace::scenarios
