// Maps on which colonies and genetic algorithms are affordable: they keep some hundred bytes per cell.
#pragma once

#include <fmt/format.h>

#include <cstdint>

#include "core/error.hpp"
#include "core/grid.hpp"

namespace pathrace::algorithms {

/// The grid. Throws Unsupported when it has more than 2^24 cells.
inline const OccupancyGrid& affordable(const OccupancyGrid& grid) {
  constexpr std::int64_t most = std::int64_t{1} << 24;
  const std::int64_t cells = std::int64_t{grid.width()} * grid.height();
  if (cells <= most) return grid;
  throw Unsupported(fmt::format("plans on maps of at most {} cells; this one has {}", most, cells));
}

}  // namespace pathrace::algorithms
