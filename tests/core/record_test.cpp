// What names a trial, and what its digest covers.

#include "core/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace pathrace {
namespace {

TrialKey key() {
  return {"dense/20-30/7", 11, "as:ants=20", 1, 3, 5, work_hash(Budget{5000, {}, {}, {}})};
}

TEST(TrialKey, TheSameTrialHasTheSameHash) {
  EXPECT_EQ(key().hash(), key().hash());
}

TEST(TrialKey, EachFieldChangesTheHash) {
  const std::vector<std::function<void(TrialKey&)>> changes = {
      [](TrialKey& k) { k.scenario = "dense/20-30/8"; },
      [](TrialKey& k) { k.content = 12; },
      [](TrialKey& k) { k.planner = "as:ants=21"; },
      [](TrialKey& k) { k.version = 2; },
      [](TrialKey& k) { k.repetition = 4; },
      [](TrialKey& k) { k.seed = 6; },
      [](TrialKey& k) {
        k.budget = work_hash(Budget{5001, {}, {}, {}});
      },
      [](TrialKey& k) { std::swap(k.repetition, k.seed); },
  };
  std::set<std::uint64_t> hashes{key().hash()};
  for (const auto& change : changes) {
    TrialKey changed = key();
    change(changed);
    hashes.insert(changed.hash());
  }
  EXPECT_EQ(hashes.size(), changes.size() + 1);
}

TEST(TrialKey, AWallLimitDoesNotChangeTheHash) {
  TrialKey timed = key();
  timed.budget = work_hash(Budget{5000, {}, {}, 2.5});
  EXPECT_EQ(timed.hash(), key().hash());
}

TEST(RootStream, DependsOnSeedScenarioAndRepetition) {
  const std::set<std::uint64_t> places = {
      root_stream(1, "dense/20-30/7", 0).place(), root_stream(2, "dense/20-30/7", 0).place(),
      root_stream(1, "dense/20-30/8", 0).place(), root_stream(1, "dense/20-30/7", 1).place()};
  EXPECT_EQ(places.size(), 4U);
}

// The three arguments are all there is: whoever shares them shares the draws.
TEST(RootStream, IsTheSameForTheSameQuestion) {
  Stream a = root_stream(9, "asr/fig5", 2);
  Stream b = root_stream(9, "asr/fig5", 2);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(a.bits(), b.bits());
}

TrialRecord record() {
  TrialRecord record;
  record.key = 77;
  record.verdict = Verdict::solved;
  record.answer = lattice_path({{0, 0}, {1, 0}, {2, 1}});
  record.work = {100, 5, 2000};
  record.trace = {{{10, 1, 200}, 0.25, 4.5}, {{60, 3, 900}, 0.5, 2.5}};
  return record;
}

std::uint64_t digest_after(const std::function<void(TrialRecord&)>& change) {
  TrialRecord changed = record();
  change(changed);
  return digest(changed);
}

TEST(Digest, ChangesWithPathVerdictWorkAndTrace) {
  const std::vector<std::function<void(TrialRecord&)>> changes = {
      [](TrialRecord& r) { r.verdict = Verdict::invalid; },
      [](TrialRecord& r) { r.answer.reset(); },
      [](TrialRecord& r) { r.answer->track = Track::any_angle; },
      [](TrialRecord& r) { r.answer->points.pop_back(); },
      [](TrialRecord& r) { r.answer->points.clear(); },
      [](TrialRecord& r) { r.answer->points[1].x = std::nextafter(1.0, 2.0); },
      [](TrialRecord& r) { std::swap(r.answer->points[1].x, r.answer->points[1].y); },
      [](TrialRecord& r) { std::swap(r.answer->points[0], r.answer->points[1]); },
      [](TrialRecord& r) { ++r.work.evaluations; },
      [](TrialRecord& r) { ++r.work.iterations; },
      [](TrialRecord& r) { ++r.work.checks; },
      [](TrialRecord& r) { r.trace.pop_back(); },
      [](TrialRecord& r) { r.trace[0].cost = std::nextafter(4.5, 5.0); },
      [](TrialRecord& r) { ++r.trace[1].work.evaluations; },
      [](TrialRecord& r) { ++r.trace[1].work.iterations; },
      [](TrialRecord& r) { ++r.trace[1].work.checks; },
      [](TrialRecord& r) { std::swap(r.trace[0], r.trace[1]); },
  };
  std::set<std::uint64_t> digests{digest(record())};
  for (const auto& change : changes) digests.insert(digest_after(change));
  EXPECT_EQ(digests.size(), changes.size() + 1);
}

TEST(Digest, DoesNotChangeWithTimesKeyOrCosts) {
  const std::uint64_t expected = digest(record());
  EXPECT_EQ(digest_after([](TrialRecord& r) { r.trace[0].wall_s = 9; }), expected);
  EXPECT_EQ(digest_after([](TrialRecord& r) { r.key = 78; }), expected);
  EXPECT_EQ(digest_after([](TrialRecord& r) { r.costs = {1.5, 0.5, "tbb", 8, 4, true, {}, {}, {}, {}}; }),
            expected);
}

TEST(CampaignDigest, DoesNotDependOnTheOrderOfRows) {
  std::vector<KeyedDigest> rows = {{3, 30, false}, {1, 10, false}, {2, 20, false}, {2, 19, false}};
  const std::uint64_t expected = campaign_digest(rows);
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.digest < b.digest; });
  do {
    ASSERT_EQ(campaign_digest(rows), expected);
  } while (std::next_permutation(rows.begin(), rows.end(),
                                 [](const auto& a, const auto& b) { return a.digest < b.digest; }));
}

TEST(CampaignDigest, LeavesTimedRowsOut) {
  EXPECT_EQ(campaign_digest({{1, 10, false}, {2, 20, true}}), campaign_digest({{1, 10, false}}));
  EXPECT_EQ(campaign_digest({{2, 20, true}}), campaign_digest({}));
}

TEST(CampaignDigest, ChangesWithEachKeyAndDigestAndWithWhichBelongsToWhich) {
  const std::set<std::uint64_t> digests = {
      campaign_digest({}),
      campaign_digest({{1, 10, false}}),
      campaign_digest({{1, 10, false}, {2, 20, false}}),
      campaign_digest({{1, 10, false}, {2, 21, false}}),
      campaign_digest({{1, 10, false}, {3, 20, false}}),
      campaign_digest({{1, 20, false}, {2, 10, false}}),
      campaign_digest({{1, 10, false}, {1, 10, false}}),
  };
  EXPECT_EQ(digests.size(), 7U);
}

}  // namespace
}  // namespace pathrace
