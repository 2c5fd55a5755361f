// Recorded queries: the MovingAI files of one folder, each read once.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "core/scenario.hpp"
#include "scenarios/movingai/folder.hpp"
#include "scenarios/movingai/map_file.hpp"
#include "scenarios/movingai/scen_file.hpp"

namespace pathrace::scenarios {

/// The scenario of one query, valid; throws InvalidScenario that names file and line otherwise.
Scenario scenario_of(const std::string& id, const MapFile& map, const ScenFile& scen, const ScenQuery& query);

class RecordedQueries {
 public:
  explicit RecordedQueries(const std::filesystem::path& folder);

  /// `movingai/<scen>/<k>` for every query of every scen file.
  std::vector<std::string> list();
  Scenario load(const std::string& id, const std::string& scen, const std::string& k);
  std::vector<std::string> spread(std::size_t per_scen, int longest_side, std::vector<std::string>* left_out);

 private:
  struct Opened {
    const MapFile* map;
    const ScenFile* scen;
  };
  Opened open(const std::string& scen);
  Opened open(const ScenEntry& entry);

  std::vector<ScenEntry> entries_;
  std::mutex mutex_;
  std::map<std::filesystem::path, MapFile> maps_;
  std::map<std::filesystem::path, ScenFile> scens_;
};

}  // namespace pathrace::scenarios
