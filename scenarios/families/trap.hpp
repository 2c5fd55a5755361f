// What the trap families share: walls, and the eight ways to turn a sketch.
#pragma once

#include <functional>

#include "scenarios/family.hpp"

namespace pathrace::scenarios {

/// Blocks the cells of the rectangle from one corner to the other, both included, that lie on the map.
void wall(OccupancyGrid& grid, Cell from, Cell to);

/// One of the eight symmetries of a square map, drawn from the stream: every trap opens to every side.
Sketch turned(const Sketch& sketch, Stream& stream);

/// `share` of n, rounded to the nearest integer.
int share_of(int n, double share);

/// The card of a family `name/<n>/<seed>` in sizes 10 and 20: `draw(n, stream)` is its sketch before turning.
Family trap_family(const std::string& name, std::string summary, std::function<Sketch(int, Stream&)> draw);

}  // namespace pathrace::scenarios
