// Finding scen files and their maps, and taking some of their queries.
#include "scenarios/movingai/folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "tests/scenarios/movingai_files.hpp"

namespace pathrace::scenarios {
namespace {

namespace fs = std::filesystem;
using pathrace::testing::message_of;
using pathrace::testing::TemporaryFolder;

const std::string some_map = "type octile\nheight 1\nwidth 1\nmap\n.\n";

std::string scen_on(const std::string& map) {
  return "version 1\n0\t" + map + "\t1\t1\t0\t0\t0\t0\t0\n";
}

std::string refusal(const fs::path& folder) {
  return message_of<InputError>([&] { find_scens(folder); });
}

TEST(MovingAiFolder, ScensAreFoundAtEveryDepthAndSortedByName) {
  const TemporaryFolder folder;
  folder.write("z/deep/er/arena.map", some_map);
  folder.write("z/deep/er/arena.map.scen", scen_on("maps/dao/arena.map"));
  folder.write("empty.map", some_map);
  folder.write("empty-random-1.scen", scen_on("empty.map"));
  folder.write("empty-even-1.scen", scen_on("empty.map"));
  folder.write("README.md", "no scen file");
  fs::create_directory(folder.path() / "folder.scen");
  const std::vector<ScenEntry> found = find_scens(folder.path());
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].name, "arena");
  EXPECT_EQ(found[0].scen, folder.path() / "z/deep/er/arena.map.scen");
  EXPECT_EQ(found[0].map, folder.path() / "z/deep/er/arena.map");
  EXPECT_EQ(found[1].name, "empty-even-1");
  EXPECT_EQ(found[1].map, folder.path() / "empty.map");
  EXPECT_EQ(found[2].name, "empty-random-1");
}

TEST(MovingAiFolder, ANameThatCommandsTheTerminalIsRefused) {
  const TemporaryFolder folder;
  folder.write("x.map", some_map);
  folder.write("a\x1b[2J.scen", scen_on("x.map"));
  const std::string message = refusal(folder.path());
  EXPECT_NE(message.find("is named 'a\\x1b[2J'; expected a name without control characters"),
            std::string::npos)
      << message;
}

TEST(MovingAiFolder, TheMapBesideTheScenGoesFirst) {
  const TemporaryFolder folder;
  folder.write("a/x.map", some_map);
  folder.write("b/x.map", some_map);
  folder.write("c/x.map", some_map);
  folder.write("b/x.map.scen", scen_on("a/x.map"));
  EXPECT_EQ(find_scens(folder.path()).at(0).map, folder.path() / "b/x.map");
}

TEST(MovingAiFolder, AMapElsewhereInTheFolderIsFoundByItsName) {
  const TemporaryFolder folder;
  folder.write("maps/x.map", some_map);
  folder.write("scens/x.map.scen", scen_on("foreign/x.map"));
  EXPECT_EQ(find_scens(folder.path()).at(0).map, folder.path() / "maps/x.map");
}

TEST(MovingAiFolder, AMapInTwoPlacesIsNotGuessed) {
  const TemporaryFolder folder;
  const std::string a = folder.write("a/x.map", some_map).string();
  const std::string b = folder.write("b/x.map", some_map).string();
  const std::string scen = folder.write("c/x.map.scen", scen_on("x.map")).string();
  EXPECT_EQ(refusal(folder.path()), scen + ":2: names map 'x.map', which is " + a + " as well as " + b);
}

TEST(MovingAiFolder, AScenWithoutItsMapIsRefused) {
  const TemporaryFolder folder;
  folder.write("y.map", some_map);
  const std::string scen = folder.write("x.map.scen", scen_on("dao/x.map")).string();
  EXPECT_EQ(refusal(folder.path()), scen + ":2: names map 'x.map', and there is none in the folder");
}

TEST(MovingAiFolder, AScenThatNamesTwoMapsIsRefused) {
  const TemporaryFolder folder;
  folder.write("x.map", some_map);
  folder.write("y.map", some_map);
  const std::string scen = folder.write("x.scen", scen_on("x.map") + "0 y.map 1 1 0 0 0 0 0\n").string();
  EXPECT_EQ(refusal(folder.path()), scen + ":3: names map 'y.map', expected 'x.map'");
}

TEST(MovingAiFolder, TwoScensOfOneNameAreRefused) {
  const TemporaryFolder folder;
  folder.write("x.map", some_map);
  const std::string one = folder.write("a/x.map.scen", scen_on("x.map")).string();
  const std::string other = folder.write("b/x.scen", scen_on("x.map")).string();
  EXPECT_EQ(refusal(folder.path()), other + ": is named 'x', as is " + one + "; expected a name of its own");
}

TEST(MovingAiFolder, AMalformedScenIsNamed) {
  const TemporaryFolder folder;
  const std::string scen = folder.write("x.map.scen", "version 3\n").string();
  EXPECT_EQ(refusal(folder.path()), scen + ":1: 'version 3'; expected 'version 1'");
}

TEST(MovingAiFolder, AFolderWithoutScensIsRefused) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal(folder.path()), folder.path().string() + ": holds no .scen file");
  folder.write("a/x.map", some_map);
  EXPECT_EQ(refusal(folder.path()), folder.path().string() + ": holds no .scen file");
}

TEST(MovingAiFolder, AMissingFolderAndAFileAreRefused) {
  const TemporaryFolder folder;
  const fs::path missing = folder.path() / "missing";
  const fs::path file = folder.write("x.map", some_map);
  EXPECT_EQ(refusal(missing), missing.string() + ": no such folder");
  EXPECT_EQ(refusal(file), file.string() + ": is a file; expected a folder of maps");
}

TEST(MovingAiFolder, AFolderThatCannotBeListedIsTheEnvironmentsFault) {
  if (geteuid() == 0) GTEST_SKIP() << "root may list every folder";
  const TemporaryFolder folder;
  folder.write("x.map", some_map);
  folder.write("x.map.scen", scen_on("x.map"));
  folder.write("closed/y.map", some_map);
  fs::permissions(folder.path() / "closed", fs::perms::none);
  const std::string message = message_of<EnvironmentError>([&] { find_scens(folder.path()); });
  fs::permissions(folder.path() / "closed", fs::perms::owner_all);
  EXPECT_EQ(message, folder.path().string() + ": cannot be listed: Permission denied");
}

using Indices = std::vector<std::size_t>;

TEST(MovingAiSpread, FewQueriesAreTakenWhereTheyAreEvenlyApart) {
  EXPECT_EQ(spread(10, 1), Indices{9});
  EXPECT_EQ(spread(10, 2), (Indices{4, 9}));
  EXPECT_EQ(spread(10, 5), (Indices{1, 3, 5, 7, 9}));
}

TEST(MovingAiSpread, AllAreTakenWhenThereAreNoMoreThanAskedFor) {
  EXPECT_EQ(spread(3, 3), (Indices{0, 1, 2}));
  EXPECT_EQ(spread(3, 100), (Indices{0, 1, 2}));
}

TEST(MovingAiSpread, NoneAreTakenOfNoneOrWhenNoneIsAskedFor) {
  EXPECT_EQ(spread(0, 5), Indices{});
  EXPECT_EQ(spread(5, 0), Indices{});
  EXPECT_EQ(spread(0, 0), Indices{});
}

TEST(MovingAiSpread, AnyNumberIsTakenOnceEachEvenlyUpToTheLast) {
  for (std::size_t total = 1; total <= 60; ++total) {
    for (std::size_t count = 1; count <= 70; ++count) {
      const Indices taken = spread(total, count);
      ASSERT_EQ(taken.size(), std::min(total, count)) << total << " " << count;
      ASSERT_EQ(taken.back(), total - 1);
      // Steps from one to the next, and from one before the first of all to the first taken.
      std::set<std::size_t> steps = {taken.front() + 1};
      for (std::size_t i = 1; i < taken.size(); ++i) {
        ASSERT_LT(taken[i - 1], taken[i]);
        steps.insert(taken[i] - taken[i - 1]);
      }
      ASSERT_LE(*steps.rbegin() - *steps.begin(), 1U) << total << " " << count;
    }
  }
}

}  // namespace
}  // namespace pathrace::scenarios
