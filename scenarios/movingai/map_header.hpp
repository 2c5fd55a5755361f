// The header of a `.map` file, checked before a single row is read.
#pragma once

#include <cstdint>
#include <string>

#include "scenarios/text.hpp"

namespace pathrace::scenarios {

struct MapHeader {
  int width = 0;   ///< columns
  int height = 0;  ///< rows
  int line = 0;    ///< of the closing `map`; row y is on line + 1 + y
};

/// More bytes than any sensible header has.
inline constexpr std::uintmax_t longest_header = 4096;

/// Takes the header's lines. Throws InputError on anything but the three keys, each once, in any order, and
/// `map`; on any type but octile; on a size that OccupancyGrid does not take.
MapHeader read_map_header(Lines& lines, const std::string& name);

/// Throws InputError when a file of `bytes` holds more than twice what its header accounts for.
void require_plausible_size(const MapHeader& header, std::uintmax_t bytes, const std::string& name);

}  // namespace pathrace::scenarios
