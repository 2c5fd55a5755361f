// Questions on ROS maps, `ros/<map>/<k>`: k = 1, 2, 3, ... without end.
//
// Start and goal of question k are two different cells of the map's largest region (the largest set of free
// cells joined by straight steps; the one met first, row by row, when several are as large), drawn uniformly
// from Stream(0).fork("scenario").fork(id). Unknown cells are blocked, the rule is strict.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/scenario.hpp"
#include "scenarios/offer.hpp"

namespace pathrace::scenarios {

struct RosMapEntry {
  std::string name;
  std::filesystem::path yaml;
};

/// The yaml files below a folder that have an `image`, sorted by name: the file's name without extension, or,
/// where several files share it, the name of the folder, a dash and that. Files that are no yaml at all are
/// entries too, so that asking for one tells what is wrong with it. When there is none below the folder,
/// those below its neighbour `ros` count. Throws InputError when two have one name even so, EnvironmentError
/// when a folder cannot be listed.
std::vector<RosMapEntry> find_ros_maps(const std::filesystem::path& folder);

/// The maps of one folder, each read once. Safe to use from several threads.
class RosQueries {
 public:
  explicit RosQueries(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Throws InputError for an unknown map (with the nearest match), a k that is no number, or a map that
  /// cannot be read; InvalidScenario when its largest region has fewer than two cells.
  Scenario load(const std::string& id, const std::string& map, const std::string& k);

  /// The first thirty questions of every map.
  std::vector<std::string> list();

  /// Adds the first questions of every map below the folder itself to what there is to race on.
  void offer(const OfferLimits& limits, Offer& offer);

 private:
  struct Opened {
    std::shared_ptr<const OccupancyGrid> grid;
    std::vector<Cell> region;
  };
  const std::vector<RosMapEntry>& entries();
  const Opened& open(const std::string& map);

  std::filesystem::path folder_;
  std::mutex mutex_;
  bool listed_ = false;
  std::vector<RosMapEntry> entries_;
  std::map<std::string, Opened> maps_;
};

}  // namespace pathrace::scenarios
