// A path: the polyline a planner answers with, and the track it races on.
#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "core/cell.hpp"
#include "core/names.hpp"

namespace pathrace {

enum class Track {
  lattice,    ///< each step is a legal move from one cell centre to the next
  any_angle,  ///< each segment keeps out of the blocked squares
  dynamic,    ///< the positions of a robot among moving discs, one per step
};

template <>
inline constexpr auto names_of<Track> = std::to_array<std::pair<Track, std::string_view>>({
    {Track::lattice, "lattice"},
    {Track::any_angle, "any_angle"},
    {Track::dynamic, "dynamic"},
});

struct Path {
  Track track = Track::lattice;
  std::vector<Point> points;  ///< from start to goal, both included; one point when they are the same

  friend bool operator==(const Path&, const Path&) = default;
};

inline Path lattice_path(const std::vector<Cell>& cells) {
  Path path;
  path.points.reserve(cells.size());
  for (const Cell cell : cells) path.points.push_back(centre(cell));
  return path;
}

}  // namespace pathrace
