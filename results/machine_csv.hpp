// machine.csv: what each session of a store ran on.
#pragma once

#include <ostream>

#include "results/store.hpp"

namespace pathrace::results {

/// Columns session, name, value; one line per fact.
void write_machine_csv(std::ostream& out, const Store& store);

}  // namespace pathrace::results
