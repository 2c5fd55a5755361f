// The informed pursuit: a bound that no navigator can beat.
//
// A robot that knows where the goal will be, and that no disc stops, drives straight to where it meets it.
// It arrives after the least k with |start - goal_k| <= k V_robot + threshold, goal_k being the goal after k
// moves. A fleeing goal never comes nearer by a move of its own, so it counts as if it stood still.
#pragma once

#include <cstdint>
#include <optional>

#include "core/world.hpp"

namespace pathrace {

/// Steps of the informed pursuit; nothing when it needs more than `max_steps`.
std::optional<std::uint64_t> least_steps(const World& world);

}  // namespace pathrace
