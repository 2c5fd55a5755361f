// The campaigns that come with the project can be run.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "bench/campaign.hpp"
#include "bench/roster.hpp"
#include "bench/trial_plan.hpp"

namespace pathrace::bench {
namespace {

TEST(Campaigns, EveryFileInTheirFolderIsNamedAfterItsCampaignAndCanBePlanned) {
  const scenarios::Library library;
  std::size_t files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(PATHRACE_SOURCE_DIR) + "/campaigns")) {
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    const Campaign campaign = parse_campaign(text.str(), entry.path().filename().string());
    EXPECT_EQ(campaign.name, entry.path().stem().string());
    EXPECT_NO_THROW(plan_trials(campaign, library, roster())) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 2U);
}

}  // namespace
}  // namespace pathrace::bench
