#include "bench/output_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "core/error.hpp"
#include "tests/support/process.hpp"

namespace pathrace::bench {
namespace {

using testing::ScratchFolder;

std::string content(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const std::string& file, const std::string& text) {
  OutputFile out(file);
  out.stream() << text;
  out.commit();
}

TEST(OutputFile, IsWholeOrAsItWas) {
  const ScratchFolder scratch;
  scratch.file("table.csv", "old");
  {
    OutputFile out(scratch / "table.csv");
    out.stream() << "half of the new";
  }
  EXPECT_EQ(content(scratch / "table.csv"), "old");
  write(scratch / "table.csv", "new");
  EXPECT_EQ(content(scratch / "table.csv"), "new");
  EXPECT_FALSE(std::filesystem::exists(scratch / "table.csv.part"));
}

TEST(OutputFile, FollowsNoLinkOfEitherName) {
  const ScratchFolder scratch;
  const std::string precious = scratch.file("precious", "precious");
  std::filesystem::create_symlink(precious, scratch / "table.csv.part");
  std::filesystem::create_symlink(precious, scratch / "table.csv");
  write(scratch / "table.csv", "rows");
  EXPECT_EQ(content(precious), "precious");
  EXPECT_EQ(content(scratch / "table.csv"), "rows");
  EXPECT_FALSE(std::filesystem::is_symlink(scratch / "table.csv"));
}

TEST(OutputFile, TakesThePlaceOfWhatAKilledRunLeft) {
  const ScratchFolder scratch;
  scratch.file("table.csv.part", "half, and much longer than what comes");
  write(scratch / "table.csv", "rows");
  EXPECT_EQ(content(scratch / "table.csv"), "rows");
}

TEST(OutputFile, SaysWhatCannotBeWritten) {
  const ScratchFolder scratch;
  EXPECT_THROW(OutputFile(scratch / "no/table.csv"), EnvironmentError);
  std::filesystem::create_directory(scratch / "folder");
  OutputFile out(scratch / "folder");
  out.stream() << "rows";
  EXPECT_THROW(out.commit(), EnvironmentError);
}

}  // namespace
}  // namespace pathrace::bench
