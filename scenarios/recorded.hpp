// Recorded queries: the MovingAI files of one folder, each read once.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "core/scenario.hpp"
#include "scenarios/movingai/folder.hpp"
#include "scenarios/movingai/map_file.hpp"
#include "scenarios/movingai/scen_file.hpp"
#include "scenarios/offer.hpp"

namespace pathrace::scenarios {

/// The scenario of one query, valid; throws InvalidScenario that names file and line otherwise.
Scenario scenario_of(const std::string& id, const MapFile& map, const ScenFile& scen, const ScenQuery& query);

class RecordedQueries {
 public:
  /// Throws as list_scens does. What is wrong with a single scen file is said when one is asked for in vain.
  explicit RecordedQueries(std::filesystem::path folder);

  /// `movingai/<scen>/<k>` for every query of every scen file.
  std::vector<std::string> list();
  Scenario load(const std::string& id, const std::string& scen, const std::string& k);

  /// Adds some queries of each scen file, spread evenly, to what there is to race on.
  void offer(const OfferLimits& limits, Offer& offer);
  /// The maps that the scen files are about.
  std::set<std::filesystem::path> maps() const;

 private:
  struct Opened {
    const MapFile* map;
    const ScenFile* scen;
  };
  Opened open(const std::string& scen);
  Opened open(const ScenEntry& entry);
  void require_any() const;

  std::filesystem::path folder_;
  std::vector<std::string> faults_;  // of scen files that are none
  std::vector<ScenEntry> entries_;
  std::mutex mutex_;
  std::map<std::filesystem::path, MapFile> maps_;
  std::map<std::filesystem::path, ScenFile> scens_;
};

}  // namespace pathrace::scenarios
