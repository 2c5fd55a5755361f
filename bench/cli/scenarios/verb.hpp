// A verb of `scenarios`: one file in this folder and one line in verbs.def.
#pragma once

#include <string>

#include "bench/cli/command.hpp"
#include "bench/cli/options.hpp"
#include "core/scenario.hpp"
#include "scenarios/map_reader.hpp"

namespace pathrace::bench::cli {

/// Adds `scenarios VERB`; `example` is what follows the verb on a line that can be pasted.
CLI::App* add_verb(CLI::App& parent, const std::string& verb, const std::string& summary,
                   const std::string& example, std::function<int()> body);

/// A scenario by its id, with its proven optimum. `maps`: the folder of recorded maps as given, or empty.
Scenario proven_scenario(const std::string& id, const std::string& maps);

/// "33.3137", or "no way".
std::string print_optimum(const Scenario& scenario);

/// What a verb is about: a scenario of the library, or a map file.
struct Subject {
  std::string id;  ///< of a scenario, or the path of a map file
  std::string maps;
  MapFileOptions map;

  bool is_map_file() const;
};

/// Adds the options ID|FILE, --maps and those of map files.
void add_subject_options(CLI::App& verb, Subject& subject);

/// One line: size, free cells, and where the map lies.
std::string describe_map(const std::string& file, const scenarios::GridMap& map,
                         const MapFileOptions& options);

}  // namespace pathrace::bench::cli
