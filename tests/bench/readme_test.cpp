// README.md: its commands work as they are written, its pictures repeat from their captions, its code builds.
//
// A command is what stands between backticks or in a block of `sh` and begins with `./pathrace`. All of them
// run one after another, as a reader would type them, in a folder that looks like a checkout: `pathrace` is
// the binary itself, because the launcher has tests of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/png_picture.hpp"
#include "tests/support/process.hpp"

namespace pathrace::bench {
namespace {

namespace fs = std::filesystem;
using testing::Finished;
using testing::ScratchFolder;

const fs::path root = PATHRACE_SOURCE_DIR;

std::string read(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

// The lines of README.md, by the language of the block of code that they stand in; "" outside of blocks.
std::vector<std::pair<std::string, std::string>> lines() {
  std::vector<std::pair<std::string, std::string>> all;
  std::istringstream text(read(root / "README.md"));
  std::string language;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) {
      language = line.substr(3);
    } else {
      all.emplace_back(language, line);
    }
  }
  return all;
}

// What stands between backticks.
std::vector<std::string> spans(const std::string& line) {
  std::vector<std::string> found;
  for (std::size_t begin = line.find('`'); begin != std::string::npos; begin = line.find('`', begin)) {
    const std::size_t end = line.find('`', begin + 1);
    if (end == std::string::npos) break;
    found.push_back(line.substr(begin + 1, end - begin - 1));
    begin = end + 1;
  }
  return found;
}

std::vector<std::string> commands() {
  std::vector<std::string> found;
  for (const auto& [language, line] : lines()) {
    for (const std::string& text : language == "sh" ? std::vector<std::string>{line} : spans(line)) {
      if (text.starts_with("./pathrace ")) {
        found.push_back(text.substr(0, text.find_last_not_of(' ', text.find('#') - 1) + 1));
      }
    }
  }
  return found;
}

// Commands that run in another form here, and why.
const std::map<std::string, std::string>& stand_ins() {
  static const std::map<std::string, std::string> all = {
      {"./pathrace test", ""},   // this is it; tests of the launcher see what it calls
      {"./pathrace micro", ""},  // a program of its own, which CI builds and runs
      // Some ten seconds, and many minutes with sanitizers; smoke runs in other tests.
      {"./pathrace run", "./pathrace run --dry-run"},
      {"./pathrace run --maps examples", "./pathrace run --maps examples --dry-run"},
  // Minutes. Without OMPL it is refused, as it should be.
#ifdef PATHRACE_OMPL
      {"./pathrace run campaigns/leaderboard.toml", "./pathrace run campaigns/leaderboard.toml --dry-run"},
#else
      {"./pathrace run campaigns/leaderboard.toml", ""},
#endif
  };
  return all;
}

// SVG to the byte; PNG to the pixel, for libraries compress in their own ways.
bool same_picture(const fs::path& a, const fs::path& b) {
  if (a.extension() != ".png") return read(a) == read(b);
  const testing::Pixels left = testing::png_pixels(read(a));
  const testing::Pixels right = testing::png_pixels(read(b));
  return left.width == right.width && left.bytes == right.bytes;
}

class Readme : public ::testing::Test {
 protected:
  Readme() {
    fs::create_symlink(PATHRACE_BINARY, scratch_ / "pathrace");
    for (const char* folder : {"campaigns", "examples"}) {
      fs::create_directory_symlink(root / folder, scratch_ / folder);
    }
    fs::create_directory(scratch_ / "docs");
  }

  Finished type(const std::string& command) const {
    return testing::run_program("/bin/bash", {"-c", "cd '" + scratch_.path().string() + "' && " + command});
  }

  ScratchFolder scratch_;
};

TEST_F(Readme, EveryCommandWorksAsWritten) {
  const std::vector<std::string> all = commands();
  EXPECT_GT(all.size(), 15U);
  for (const std::string& command : all) {
    const auto stand_in = stand_ins().find(command);
    const std::string typed = stand_in != stand_ins().end() ? stand_in->second : command;
    if (typed.empty()) continue;
    const Finished finished = type(typed);
    EXPECT_EQ(finished.exit_code, 0) << command << '\n' << finished.err;
  }
  for (const auto& [command, typed] : stand_ins()) {
    EXPECT_NE(std::find(all.begin(), all.end(), command), all.end()) << command << " is not in README.md";
  }
}

TEST_F(Readme, PicturesRepeatFromTheirCaptions) {
  std::string picture;  // that awaits its caption
  int repeated = 0;
  for (const auto& [language, line] : lines()) {
    if (const std::size_t at = line.find("](docs/"); line.starts_with("![") && at != std::string::npos) {
      EXPECT_EQ(picture, "") << "has no caption with its command";
      picture = line.substr(at + 2, line.find(')', at) - at - 2);
    } else if (!picture.empty() && line.starts_with("*`")) {
      const Finished finished = type(spans(line).at(0));
      ASSERT_EQ(finished.exit_code, 0) << finished.err;
      EXPECT_TRUE(same_picture(scratch_ / picture, root / picture)) << picture << " is not what " << line;
      picture.clear();
      ++repeated;
    }
  }
  EXPECT_EQ(picture, "") << "has no caption with its command";
  EXPECT_EQ(repeated, 2);
}

TEST_F(Readme, TheCampaignIsTheExample) {
  std::string campaign;
  for (const auto& [language, line] : lines()) {
    if (language == "toml") campaign += line + '\n';
  }
  EXPECT_EQ(campaign, read(root / "examples/campaign.toml"));
}

// The route of README.md and the plan that the same table names ask for the same way.
TEST_F(Readme, TheProgramPrintsItsRoute) {
  const Finished finished = type(PATHRACE_README_ROUTE);
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_TRUE(finished.out.find("\n0.05 0.05\n") != std::string::npos) << finished.out;  // the start's cell
  EXPECT_TRUE(finished.out.ends_with("\n5.05 2.05\n")) << finished.out;
}

}  // namespace
}  // namespace pathrace::bench
