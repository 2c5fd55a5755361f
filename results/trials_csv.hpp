// trials.csv: every trial in long form, one line each, without path and trace.
#pragma once

#include <ostream>

#include "results/store.hpp"

namespace pathrace::results {

/// Names and order of the columns are those of the view `trials`; a missing value is an empty field.
void write_trials_csv(std::ostream& out, const Store& store);

}  // namespace pathrace::results
