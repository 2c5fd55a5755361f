// The command line: arguments in, exit code out.
#pragma once

namespace pathrace::bench::cli {

/// Runs the program. Every failure is one line on stderr: 2 for bad input, 3 when the environment failed.
int run(int argc, const char* const* argv);

}  // namespace pathrace::bench::cli
