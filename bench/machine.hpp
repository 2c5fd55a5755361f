// What times depend on: the machine, the system, the compiler, and the libraries.
#pragma once

#include <vector>

#include "results/store.hpp"

namespace pathrace::bench {

/// Of this process, for Store::begin_session; the date is UTC, memory is in bytes, and the state of the
/// source tree is that of when the build was configured. What the system does not tell is left out.
std::vector<results::MachineFact> machine_facts();

}  // namespace pathrace::bench
