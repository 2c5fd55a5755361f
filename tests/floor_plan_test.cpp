// The floor plan holds: who includes whom, which outside library lives in which room, where random numbers
// come from. Offending snippets show that the checker sees each of them.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/floor_plan.hpp"

namespace pathrace {
namespace {

using testing::complaints;
using testing::Tree;

std::string lines(const std::vector<std::string>& complaints) {
  std::string text;
  for (const std::string& complaint : complaints) text += complaint + "\n";
  return text;
}

// What is said about a file of one line.
std::string said(const std::string& path, const std::string& line) {
  return lines(complaints(path, line + "\n"));
}

std::string said_of_include(const std::string& path, const std::string& header) {
  return said(path, "#include \"" + header + "\"");
}

TEST(FloorPlan, ThisTreeKeepsToIt) {
  const Tree tree = testing::read_tree(PATHRACE_SOURCE_DIR);
  EXPECT_TRUE(tree.count("core/grid.hpp"));
  EXPECT_TRUE(tree.count("core/reference/exact_search.cpp"));
  EXPECT_GT(tree.size(), 35U);
  EXPECT_EQ(lines(complaints(tree)), "");
}

TEST(FloorPlan, SiblingsNeverIncludeEachOtherAndNobodyIncludesTheBench) {
  const std::vector<std::string> rooms = {"core", "scenarios", "algorithms", "baselines", "results", "bench"};
  for (const std::string& room : rooms) {
    for (const std::string& other : rooms) {
      const bool allowed = room == other || other == "core" || room == "bench";
      const std::string expected =
          allowed ? ""
                  : room + "/a.cpp:1: " + other + "/b.hpp: " + room + " must not include " + other + "\n";
      if (room == "bench" || other != "core") {
        EXPECT_EQ(said_of_include(room + "/a.cpp", other + "/b.hpp"), expected);
      }
      EXPECT_EQ(said_of_include(room + "/a.cpp", other + "/sub/b.hpp").empty(), allowed);
    }
    EXPECT_NE(said_of_include(room + "/a.cpp", "tests/support/maps.hpp"), "") << room;
  }
}

TEST(FloorPlan, TestsMayIncludeEverything) {
  EXPECT_EQ(said("tests/core/a_test.cpp", "#include \"bench/a.hpp\"\nstd::mt19937 g;"), "");
}

TEST(FloorPlan, EachLibraryLivesInItsRooms) {
  struct Library {
    std::string header;
    std::vector<std::string> homes;
  };
  const std::vector<Library> libraries = {
      {"Eigen/Core", {"core", "algorithms"}},
      {"fmt/format.h",
       {"core", "scenarios", "algorithms", "baselines", "baselines/ompl", "results", "bench", "bench/micro"}},
      {"png.h", {"scenarios", "results"}},
      {"yaml-cpp/yaml.h", {"scenarios"}},
      {"ompl/base/Planner.h", {"baselines/ompl"}},
      {"SQLiteCpp/SQLiteCpp.h", {"results"}},
      {"sqlite3.h", {"results"}},
      {"nlohmann/json.hpp", {"results", "bench"}},
      {"boost/math/distributions.hpp", {"results"}},
      {"boost/graph/astar_search.hpp", {}},
      {"tbb/parallel_for.h", {"bench"}},
      {"oneapi/tbb.h", {"bench"}},
      {"omp.h", {"bench"}},
      {"mpi.h", {"bench"}},
      {"CLI/CLI.hpp", {"bench"}},
      {"toml++/toml.h", {"bench"}},
      {"spdlog/spdlog.h", {"bench"}},
      {"benchmark/benchmark.h", {"bench/micro"}},
      {"opencv2/core.hpp", {}},
      {"curl.h", {}},
  };
  for (const std::string room : {"core", "scenarios", "algorithms", "baselines", "baselines/ompl", "results",
                                 "bench", "bench/micro"}) {
    for (const Library& library : libraries) {
      const bool home = std::count(library.homes.begin(), library.homes.end(), room) != 0;
      EXPECT_EQ(said(room + "/a.cpp", "#include <" + library.header + ">").empty(), home)
          << room << " " << library.header;
    }
  }
}

TEST(FloorPlan, StandardAndPosixHeadersAreWelcome) {
  for (const std::string header : {"vector", "cstdint", "unistd.h", "sys/wait.h", "spawn.h"}) {
    EXPECT_EQ(said("bench/a.cpp", "#include <" + header + ">"), "") << header;
  }
}

TEST(FloorPlan, APathNamesItsRoom) {
  EXPECT_EQ(
      said_of_include("core/a.cpp", "grid.hpp"),
      "core/a.cpp:1: grid.hpp: neither a header of a room, by its path from the root, nor of a library in "
      "the floor plan\n");
  EXPECT_NE(said_of_include("core/a.cpp", "../core/grid.hpp"), "");
}

TEST(FloorPlan, AnIncludeIsSeenHoweverItIsSpelled) {
  for (const std::string line :
       {"#include <bench/a.hpp>", "#include\"bench/a.hpp\"", "  #  include \"bench/a.hpp\"",
        "/* x */ #include \"bench/a.hpp\"", "#include \"bench/a.hpp\"  // why"}) {
    EXPECT_NE(said("core/a.cpp", line), "") << line;
  }
  EXPECT_EQ(lines(complaints("core/a.cpp", "\n\n#include \"bench/a.hpp\"\n")),
            "core/a.cpp:3: bench/a.hpp: core must not include bench\n");
}

TEST(FloorPlan, AnIncludeInACommentIsNone) {
  EXPECT_EQ(said("core/a.cpp", "// #include \"bench/a.hpp\""), "");
  EXPECT_EQ(said("core/a.cpp", "/*\n#include \"bench/a.hpp\"\n*/"), "");
}

TEST(FloorPlan, PlayersDoNotIncludeWhatJudgesThem) {
  for (const std::string header : {"core/referee.hpp", "core/metrics.hpp", "core/reference/exact_search.hpp",
                                   "core/record.hpp", "core/distance_transform.hpp"}) {
    for (const std::string room : {"algorithms/aco", "baselines", "baselines/ompl"}) {
      EXPECT_EQ(said_of_include(room + "/a.cpp", header),
                room + "/a.cpp:1: " + header + ": a player must not reach what judges it\n");
    }
    EXPECT_EQ(said_of_include("bench/a.cpp", header), "");
    EXPECT_EQ(said_of_include("results/a.cpp", header), "");
  }
  EXPECT_EQ(said_of_include("algorithms/a.cpp", "core/moves.hpp"), "");
}

TEST(FloorPlan, JudgesDoNotIncludeWhatPlayersUse) {
  for (const std::string header : {"core/moves.hpp", "core/planner.hpp"}) {
    for (const std::string judge : {"core/referee.cpp", "core/referee.hpp", "core/metrics.cpp",
                                    "core/metrics.hpp", "core/reference/exact_search.cpp"}) {
      EXPECT_EQ(said_of_include(judge, header),
                judge + ":1: " + header + ": a judge must not reach what players use\n");
    }
    EXPECT_EQ(said_of_include("core/catalogue.hpp", header), "");
  }
}

TEST(FloorPlan, NeitherIsReachedThroughAnotherHeader) {
  const Tree tree = {
      {"algorithms/a.cpp", "#include \"algorithms/a.hpp\"\n"},
      {"algorithms/a.hpp", "#include \"core/b.hpp\"\n"},
      {"core/b.hpp", "#include \"core/c.hpp\"\n#include \"core/b.hpp\"\n"},
      {"core/c.hpp", "#include \"core/record.hpp\"\n"},
      {"core/record.hpp", "#include \"core/planner.hpp\"\n"},
      {"core/referee.cpp", "#include \"core/record.hpp\"\n"},
  };
  EXPECT_EQ(lines(complaints(tree)),
            "algorithms/a.cpp: core/record.hpp through core/c.hpp: a player must not reach what judges it\n"
            "algorithms/a.hpp: core/record.hpp through core/c.hpp: a player must not reach what judges it\n"
            "core/referee.cpp: core/planner.hpp through core/record.hpp: a judge must not reach what players "
            "use\n");
}

TEST(FloorPlan, RandomNumbersComeFromTheStreams) {
  for (const std::string line :
       {"std::uniform_int_distribution<int> d(0, 5);", "std::normal_distribution<> d;",
        "std::random_device r;", "std::mt19937 g(1);", "mt19937_64 g;", "std::default_random_engine e;",
        "int i = rand();", "int i = std::rand ();", "srand(5);", "#include <random>",
        "#define X std::mt19937"}) {
    for (const std::string room : {"core", "scenarios", "algorithms", "baselines", "results", "bench"}) {
      EXPECT_NE(said(room + "/a.cpp", line), "") << line;
    }
  }
  EXPECT_EQ(lines(complaints("core/a.cpp", "int a;\nstd::mt19937 g;\n")),
            "core/a.cpp:2: mt19937: random numbers come from core/stream.hpp\n");
}

TEST(FloorPlan, WordsThatOnlyLookLikeRandomNumbersPass) {
  for (const std::string line :
       {"// No std::uniform_int_distribution, no rand().", "int operand(int);", "x = brand(1);",
        "int rand = 5;", "log(\"rand() and std::mt19937\");", "show(length_distribution);",
        "char quote = '\"';  // rand()", "const int million = 1'000'000;  // rand()",
        "#include <vector>  // not rand()"}) {
    EXPECT_EQ(said("core/a.cpp", line), "") << line;
  }
  EXPECT_NE(said("core/a.cpp", "f(\"quote \\\" inside\"); rand();"), "");
  EXPECT_NE(said("core/a.cpp", "char c = '\"'; rand();"), "");
}

TEST(FloorPlan, ATreeOnDiskIsReadWithAllItsFolders) {
  const std::filesystem::path root =
      std::filesystem::temp_directory_path() / ("pathrace_floor_plan_" + std::to_string(getpid()));
  std::filesystem::create_directories(root / "algorithms/aco/deep");
  std::filesystem::create_directories(root / "runs");
  std::ofstream(root / "algorithms/aco/deep/a.cpp") << "#include \"results/row.hpp\"\n";
  std::ofstream(root / "algorithms/aco/list.def") << "#include \"bench/a.hpp\"\n";
  std::ofstream(root / "runs/a.cpp") << "#include \"results/row.hpp\"\n";
  const std::string found = lines(complaints(testing::read_tree(root)));
  std::filesystem::remove_all(root);
  EXPECT_EQ(found,
            "algorithms/aco/deep/a.cpp:1: results/row.hpp: algorithms must not include results\n"
            "algorithms/aco/list.def:1: bench/a.hpp: algorithms must not include bench\n");
}

}  // namespace
}  // namespace pathrace
