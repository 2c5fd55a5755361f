// Files that cannot be read at all, or should not be.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "core/error.hpp"
#include "scenarios/movingai/map_file.hpp"
#include "scenarios/movingai/scen_file.hpp"
#include "tests/scenarios/movingai_files.hpp"

namespace pathrace::scenarios {
namespace {

namespace fs = std::filesystem;
using pathrace::testing::message_of;
using pathrace::testing::TemporaryFolder;

template <typename Error>
void expect_both_refuse(const fs::path& file, const std::string& message) {
  EXPECT_EQ(message_of<Error>([&] { MapFile::read(file); }), message);
  EXPECT_EQ(message_of<Error>([&] { ScenFile::read(file); }), message);
}

TEST(MovingAiFile, AMissingFileIsNamed) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "nowhere.map";
  expect_both_refuse<InputError>(file, file.string() + ": no such file");
  expect_both_refuse<InputError>(file / "below", (file / "below").string() + ": no such file");
}

TEST(MovingAiFile, AFileBelowAFileIsMissing) {
  const TemporaryFolder folder;
  const fs::path below = folder.write("x.map", "") / "y.map";
  expect_both_refuse<InputError>(below, below.string() + ": no such file");
}

TEST(MovingAiFile, AFolderIsNoFile) {
  const TemporaryFolder folder;
  expect_both_refuse<InputError>(folder.path(), folder.path().string() + ": is a folder; expected a file");
}

TEST(MovingAiFile, APipeIsRefusedRatherThanWaitedFor) {
  const TemporaryFolder folder;
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  expect_both_refuse<InputError>(pipe, pipe.string() + ": is not a regular file; expected one");
  expect_both_refuse<InputError>("/dev/zero", "/dev/zero: is not a regular file; expected one");
}

TEST(MovingAiFile, ANameThatNoFileCanHaveIsBadInput) {
  const std::string name(5000, 'n');
  expect_both_refuse<InputError>(name, name + ": cannot be read: File name too long");
}

TEST(MovingAiFile, AFileWithoutPermissionIsTheEnvironmentsFault) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read every file";
  const TemporaryFolder folder;
  const fs::path file = folder.write("secret.map", "type octile\nheight 1\nwidth 1\nmap\n.\n");
  fs::permissions(file, fs::perms::none);
  expect_both_refuse<EnvironmentError>(file, file.string() + ": cannot be read: Permission denied");
}

// The files below are holes: they take no disk, but reading one whole would take as much memory.
constexpr std::uintmax_t huge = std::uintmax_t{1} << 40;

TEST(MovingAiFile, AHugeFileWithASmallHeaderIsRefusedUnread) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("huge.map", "type octile\nheight 2\nwidth 3\nmap\n");
  fs::resize_file(file, huge);
  EXPECT_EQ(
      message_of<InputError>([&] { MapFile::read(file); }),
      file.string() + ":4: the file holds 1099511627776 bytes; expected at most 4116 for a map of 3x2 cells");
}

TEST(MovingAiFile, AHugeFileWithoutAHeaderIsRefusedUnread) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("huge.map", "");
  fs::resize_file(file, huge);
  const std::string message = message_of<InputError>([&] { MapFile::read(file); });
  EXPECT_EQ(message.substr(0, file.string().size() + 12), file.string() + ":1: '\\x00\\x0");
}

TEST(MovingAiFile, AHugeScenFileIsRefusedUnread) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("huge.scen", "version 1\n");
  fs::resize_file(file, huge);
  EXPECT_EQ(message_of<InputError>([&] { ScenFile::read(file); }),
            file.string() + ":1: the file holds 1099511627776 bytes; expected at most 67108864");
}

TEST(MovingAiFile, AFileIsReadLikeItsText) {
  const TemporaryFolder folder;
  const std::string text = "type octile\nheight 2\nwidth 3\nmap\n.@W\nW.@\n";
  const MapFile map = MapFile::read(folder.write("x.map", text));
  const MapFile same = MapFile::parse(text, "x.map");
  EXPECT_EQ(*map.ground(), *same.ground());
  EXPECT_EQ(*map.water(), *same.water());
  const fs::path file = folder.write("x.map.scen", "version 1\n0 x.map 3 2 0 0 0 0 0\n");
  EXPECT_EQ(ScenFile::read(file).file, file);
  EXPECT_EQ(ScenFile::read(file).queries.size(), 1U);
}

TEST(MovingAiFile, AMapLongerThanTheLongestHeaderIsReadWhole) {
  const TemporaryFolder folder;
  std::string text = "type octile\nheight 100\nwidth 100\nmap\n";
  for (int y = 0; y < 100; ++y) text += std::string(99, '@') + ".\n";
  const MapFile map = MapFile::read(folder.write("x.map", text));
  EXPECT_EQ(map.ground()->free_cells(), 100);
  EXPECT_TRUE(map.ground()->is_free({99, 99}));
}

}  // namespace
}  // namespace pathrace::scenarios
