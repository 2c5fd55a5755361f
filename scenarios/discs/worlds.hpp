// From the parts of an id to a world of discs.
#pragma once

#include <memory>
#include <string>

#include "scenarios/discs/settings.hpp"

namespace pathrace::scenarios {

/// The world with this id: walls, ends and loose discs are drawn from its stream until all fit. Throws
/// InvalidScenario when they never do.
std::shared_ptr<const World> draw_world(const std::string& id, const DiscsKind& kind,
                                        const DiscsSettings& settings);

}  // namespace pathrace::scenarios
