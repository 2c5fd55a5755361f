// Ctrl-C: the first asks the process to stop and keep what it has, the second ends it at once.
#pragma once

namespace pathrace::bench {

/// From now on the first SIGINT or SIGTERM sets `stop_requested` (core/checkpoint.hpp) and restores the
/// default action of both signals.
void stop_on_signals();

}  // namespace pathrace::bench
