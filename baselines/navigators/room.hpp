// Room to move: what the navigators of this folder know about discs.
#pragma once

#include "core/navigator.hpp"

namespace pathrace::baselines {

/// The point `length` from `from` on the way to `to`; `to` itself when it is not farther.
Point towards(Point from, Point to, double length);

/// Can the robot drive straight from where it is to `to` without coming nearer to a disc than to touch it?
/// Where it overlaps a disc already, it may only move away. One check per disc.
bool is_free_way(const Snapshot& snapshot, Point to);

/// Does the robot on its way from `from` to `to` overlap no disc? One check per disc.
bool is_clear(const Snapshot& snapshot, Point from, Point to);

/// The gap between the robot, were it there, and the nearest disc; the workspace's width without discs. One
/// check per disc.
double room_at(const Snapshot& snapshot, Point robot);

/// The nearest place at which the whole robot is inside the workspace.
Point kept_inside(const Snapshot& snapshot, Point point);

/// Spends `checks` when so many are left, else what is left: then the run ends with this step.
bool afford(Meter& meter, std::uint64_t checks);

}  // namespace pathrace::baselines
