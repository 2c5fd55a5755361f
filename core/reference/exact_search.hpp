// The reference: proves a scenario's optimum. No planner uses it, and it uses nothing of theirs.
#pragma once

#include "core/scenario.hpp"

namespace pathrace::reference {

/// The proven optimum from start to goal; its length is empty when there is no way. Expects free cells.
Optimum optimum(const Terrain& terrain, Cell start, Cell goal);

}  // namespace pathrace::reference
