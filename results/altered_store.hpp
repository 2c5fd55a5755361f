// A store that SQLite can read, but that does not hold what was recorded.
#pragma once

#include "core/error.hpp"

namespace pathrace::results {

/// A row was changed, or rows are gone. Checksums guard against accidents and edits, not against somebody who
/// computes them anew.
class AlteredStore : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace pathrace::results
