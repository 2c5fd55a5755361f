// A dynamic world and a run as a picture: walls, discs with their trails, the goal with its trail, the swarm,
// the robot's way.
#pragma once

#include "core/world.hpp"
#include "results/picture.hpp"

namespace pathrace::results {

/// Discs are drawn where the run ended, rings and lines show how they came there. Without an answer it shows
/// the world before it moves. The overlay's circles, line and points are in units of the world.
void draw_world_picture(Pen& pen, const PictureLayout& layout, const World& world, const Shown& shown);

}  // namespace pathrace::results
