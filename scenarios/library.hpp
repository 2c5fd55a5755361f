// The library: from an id to a scenario, and from a pattern to ids.
//
// The generated families are endless; the library lists a finite part of them. Recorded queries,
// `movingai/<scen>/<k>`, come from a folder of .map and .scen files, k counting the queries of the scen file
// from 1. Questions on ROS maps, `ros/<map>/<k>`, come from the yaml files of the same folder, or of the
// folder `ros` beside it. Any id may end in another move rule, `,rule=free`.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/scenario.hpp"
#include "scenarios/offer.hpp"

namespace pathrace::scenarios {

class RosQueries;

class Library {
 public:
  /// `maps`: a folder that holds .map and .scen files, ROS maps, or both, at any depth; without it there are
  /// neither recorded queries nor ROS maps.
  explicit Library(std::optional<std::filesystem::path> maps = std::nullopt);
  ~Library();
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  /// The finite list of generated and curated ids, family by family; the same everywhere. No two of them ask
  /// the same question (scenarios/repeats.hpp).
  std::vector<std::string> list() const;

  /// The scenario with this id, which may end in `,rule=squeeze` or another move rule; generated ones carry
  /// their proven optimum, recorded ones and those under another rule do not yet.
  /// Throws InputError for an unknown family or a malformed id, InvalidScenario for a query that cannot be
  /// one. Safe to call from several threads.
  Scenario load(const std::string& id) const;

  /// The ids that a campaign's pattern stands for: an id, a range of seeds `dense/20-20/1..30`, a glob over
  /// the list (`trap-*/20/*`, where `*` stays within one part), or a set `set/traps`. A seed that a glob
  /// names counts as given, listed or not: `trap-*/20/101`. Throws InputError when there is none.
  std::vector<std::string> select(const std::string& pattern) const;

  /// What the folder offers to race on: queries of scen files, spread evenly, questions on ROS maps, and maps
  /// without either. Expects a folder.
  Offer offer(const OfferLimits& limits) const;

  const std::optional<std::filesystem::path>& maps() const { return maps_; }

 private:
  class Recorded;
  Recorded& recorded(const std::string& id) const;
  RosQueries& ros(const std::string& id) const;
  Scenario load_plain(const std::string& id) const;  // without a rule
  std::vector<std::string> listed_for(const std::string& pattern) const;

  std::optional<std::filesystem::path> maps_;
  mutable std::unique_ptr<Recorded> recorded_;
  mutable std::unique_ptr<RosQueries> ros_;
};

/// Adds the proven optimum where it is missing, by exact search; a dynamic world has none.
void prove(Scenario& scenario);

}  // namespace pathrace::scenarios
