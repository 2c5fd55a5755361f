// Ten thousand generated scenarios: the same bits from every compiler and executor, each with a way, and with
// an optimum that Dijkstra's algorithm of the baselines finds too.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "core/hash.hpp"
#include "scenarios/family.hpp"
#include "scenarios/library.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::bench {
namespace {

constexpr std::size_t ten_thousand = 10'000;
constexpr std::size_t compared = testing::instrumented ? 500 : ten_thousand;  // instrumented code is slow

// From running the code; a commit that moves it raises the library's version.
constexpr const char* library_digest = "49f140b257d7fead";

// Every family of maps with a seed, in sizes 5 to 40, with seeds from 1000 on: none of them is listed.
std::vector<std::string> many_ids(std::size_t wanted) {
  std::vector<std::string> ids;
  for (int seed = 1000; ids.size() < wanted; ++seed) {
    for (const scenarios::Family& family : scenarios::families()) {
      const std::string& listed = family.library.front();
      const std::size_t size = listed.find('/') + 1;
      const std::size_t end = listed.find_first_of("-/", size);
      if (family.parameters.empty() || family.dynamic || ids.size() == wanted) continue;
      ids.push_back(fmt::format("{}{}{}{}", listed.substr(0, size), 5 + seed % 36,
                                listed.substr(end, listed.rfind('/') + 1 - end), seed));
    }
  }
  return ids;
}

std::vector<std::uint64_t> content_hashes(const std::vector<std::string>& ids, Executor& executor) {
  const scenarios::Library library;
  std::vector<std::uint64_t> hashes(ids.size());
  for_each_index(executor, ids.size(), std::size_t{16},
                 [&](std::size_t i) { hashes[i] = content_hash(library.load(ids[i])); });
  return hashes;
}

std::string digest_of(const std::vector<std::uint64_t>& hashes) {
  Hasher hasher;
  for (const std::uint64_t hash : hashes) hasher.add(hash);
  return hex(hasher.value());
}

TEST(LibraryDigest, IsTheCommittedConstant) {
  const auto executor = make_executor("serial", 1);
  EXPECT_EQ(digest_of(content_hashes(many_ids(ten_thousand), *executor)), library_digest);
}

TEST(LibraryDigest, IsTheSameOnEveryExecutor) {
  const std::vector<std::string> ids = many_ids(compared);
  const std::vector<std::uint64_t> serial = content_hashes(ids, *make_executor("serial", 1));
  for (const std::string& backend : testing::executors_under_test()) {
    EXPECT_EQ(content_hashes(ids, *make_executor(backend, 4)), serial) << backend;
  }
}

TEST(LibraryDigest, EveryScenarioHasTwoEndsAndTheOptimumThatDijkstraFinds) {
  const scenarios::Library library;
  for (const std::string& id : many_ids(compared)) {
    const Scenario scenario = library.load(id);
    ASSERT_NE(scenario.start, scenario.goal) << id;
    ASSERT_TRUE(scenario.optimum.length.has_value()) << id;
    const TrialRecord record = testing::run({"dijkstra"}, scenario);
    ASSERT_EQ(record.verdict, Verdict::solved) << id;
    ASSERT_EQ(record.metrics->lattice, scenario.optimum.length) << id;
  }
}

}  // namespace
}  // namespace pathrace::bench
