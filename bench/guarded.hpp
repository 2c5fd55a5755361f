// What planners throw becomes a verdict.
#pragma once

#include <functional>

#include "core/record.hpp"

namespace pathrace::bench {

/// Calls `body`, which plans. When it throws, verdict and note say why, and the record has no answer;
/// Interrupted passes through.
void guarded(TrialRecord& record, const std::function<void()>& body);

}  // namespace pathrace::bench
