// The roster: every planner that this program knows.
#pragma once

#include "core/catalogue.hpp"

namespace pathrace::bench {

const Catalogue& roster();

}  // namespace pathrace::bench
