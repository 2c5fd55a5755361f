// A trial plan: a campaign with everything looked up, as an ordered list of keyed trials.
//
// Order: scenarios as selected, within each the planners as listed, within each the repetitions. The order is
// for people and for resuming; no result depends on it. In a campaign with maps and dynamic worlds, planners
// race on maps and navigators in worlds; a planner that nothing was selected for gets its trials all the
// same, and is recorded as unsupported.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/campaign.hpp"
#include "core/catalogue.hpp"
#include "core/record.hpp"
#include "core/scenario.hpp"
#include "scenarios/library.hpp"

namespace pathrace::bench {

struct Trial {
  std::size_t scenario = 0;  ///< index into TrialPlan::scenarios
  std::size_t entrant = 0;   ///< index into TrialPlan::entrants
  Budget budget;
  TrialKey key;
  std::uint64_t hash = 0;  ///< of the key
};

/// The repetitions of one planner on one scenario, as indices into the plan.
struct TrialGroup {
  std::uint32_t scenario = 0;
  std::uint32_t entrant = 0;
  std::uint32_t choice = 0;  ///< into Campaign::scenarios
};

struct TrialPlan {
  Campaign campaign;
  std::vector<Scenario> scenarios;
  std::vector<Entrant> entrants;
  std::vector<TrialGroup> groups;
  std::vector<std::uint64_t> contents;  ///< content hashes of the scenarios
  std::vector<std::string> calls;       ///< full calls of the entrants
  std::vector<std::string> left_out;    ///< questions that cannot be raced on, and why, a line each
  std::vector<std::string> repeated;    ///< scenarios that ask an earlier one's question: "ID (EARLIER ID)"

  /// Trials; trial i is of group i / repetitions. They are made when asked for: a million need no memory.
  std::size_t size() const { return groups.size() * campaign.repetitions; }
  Trial trial(std::size_t i) const;
  const TrialGroup& group_of(std::size_t i) const { return groups[i / campaign.repetitions]; }
  const Budget& budget_of(const TrialGroup& group) const;

  /// Names the whole plan: a store belongs to exactly one.
  std::uint64_t hash() const;
};

/// Recorded queries that are none, and questions whose ends have no way between them on recorded maps and map
/// files, are left out: no planner answers for them. Throws InputError for unknown names, bad values, two
/// planners with one label, or an empty plan.
TrialPlan plan_trials(const Campaign& campaign, const scenarios::Library& library,
                      const Catalogue& catalogue);

/// Takes planners out of the campaign that the catalogue knows as absent. Returns their names.
std::vector<std::string> leave_out_absent(Campaign& campaign, const Catalogue& catalogue);

}  // namespace pathrace::bench
