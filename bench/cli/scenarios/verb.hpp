// A verb of `scenarios`: one file in this folder and one line in verbs.def.
#pragma once

#include <string>

#include "bench/cli/command.hpp"
#include "core/scenario.hpp"

namespace pathrace::bench::cli {

/// Adds `scenarios VERB`; `example` is what follows the verb on a line that can be pasted.
CLI::App* add_verb(CLI::App& parent, const std::string& verb, const std::string& summary,
                   const std::string& example, std::function<int()> body);

/// A scenario by its id, with its proven optimum. `maps`: the folder of recorded maps as given, or empty.
Scenario proven_scenario(const std::string& id, const std::string& maps);

/// "33.3137", or "no way".
std::string print_optimum(const Scenario& scenario);

/// Adds the options ID and --maps.
void add_scenario_options(CLI::App& verb, std::string& id, std::string& maps);

}  // namespace pathrace::bench::cli
