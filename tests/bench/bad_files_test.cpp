// Files that are none, or too much: one line at once, whatever the command.
#include <sys/stat.h>

#include <filesystem>

#include "tests/bench/command_line.hpp"

namespace pathrace::bench {
namespace {

using testing::ScratchFolder;

TEST(BadFiles, DevicesPipesAndFoldersAreNoCampaign) {
  const ScratchFolder scratch;
  const std::string pipe = scratch / "pipe.toml";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  expect_refusal(pathrace({"run", pipe}), {"pipe.toml", "not a regular file"});
  expect_refusal(pathrace({"run", "/dev/zero"}), {"/dev/zero", "not a regular file"});
  expect_refusal(pathrace({"run", scratch / "."}), {"is a folder"});
  expect_refusal(pathrace({"run", scratch / "none.toml"}), {"none.toml", "no such file"});
}

TEST(BadFiles, APipeIsNoMap) {
  const ScratchFolder scratch;
  for (const char* name : {"pipe.map", "pipe.csv", "pipe.pgm", "pipe.yaml"}) {
    const std::string pipe = scratch / name;
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    expect_refusal(pathrace({"scenarios", "check", pipe}), {name, "not a regular file"});
  }
}

TEST(BadFiles, MoreBytesThanAnyFileNeedsAreRefusedUnread) {
  const ScratchFolder scratch;
  for (const char* name : {"huge.map", "huge.csv", "huge.png", "huge.yaml", "huge.scen", "huge.toml"}) {
    const std::string file = scratch.file(name, "x");
    std::filesystem::resize_file(file, std::uintmax_t{1} << 36);  // of zeros that no disk holds
    expect_refusal(pathrace({"scenarios", "check", file}), {name});
  }
}

TEST(BadFiles, NothingThatATerminalObeysIsRepeated) {
  const testing::Finished finished = pathrace({"plan", "--scenario", "\x1b[31m/1", "--planner", "astar"});
  expect_refusal(finished, {"\\x1b[31m"});
  EXPECT_EQ(finished.err.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace pathrace::bench
