// Obstacles as connected groups of blocked cells.
//
// "Per obstacle", says the paper, without saying which cells are one. Eight-connectivity is the default: two
// cells that touch at a corner are one obstacle. The circles drawn around obstacles only bias the search, so
// an ant that may squeeze through such a corner still can.
//
// Tan Tan, Liu Shudong, Zhang Yan, "Simulation Study of Path Planning Method for Mobile Robot", 3.3.1 (1).
#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "core/grid.hpp"
#include "core/names.hpp"

namespace pathrace::algorithms {

enum class Neighbours { four, eight };

/// The blocked cells of one obstacle, in row order.
using Obstacle = std::vector<Cell>;

/// Every obstacle inside the map, ordered by its first cell in row order. O(cells).
std::vector<Obstacle> obstacles_of(const OccupancyGrid& grid, Neighbours neighbours);

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::Neighbours> =
    std::to_array<std::pair<algorithms::Neighbours, std::string_view>>({
        {algorithms::Neighbours::four, "four"},
        {algorithms::Neighbours::eight, "eight"},
    });
}  // namespace pathrace
