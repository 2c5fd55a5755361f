// What the gallery shows of each family.
#pragma once

#include <vector>

#include "results/gallery.hpp"
#include "scenarios/family.hpp"

namespace pathrace::bench {

/// Up to `count` ids of a family's library that make good tiles: the first of the last listed group (ids that
/// differ in their last part only) whose map has 20 to 32 cells a side; without one, of the group whose map
/// is nearest to that.
std::vector<std::string> gallery_ids(const scenarios::Family& family, std::size_t count);

/// Up to `per_family` tiles of each family, in the library's order, each with a shortest path.
std::vector<results::Tile> gallery_tiles(std::size_t per_family);

}  // namespace pathrace::bench
