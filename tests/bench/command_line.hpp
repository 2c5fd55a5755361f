// What tests of the command line share: calling the binary, and what a refusal looks like.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/process.hpp"

namespace pathrace::bench {

constexpr const char* small_map = "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n";

inline testing::Finished pathrace(const std::vector<std::string>& arguments) {
  return testing::run_program(PATHRACE_BINARY, arguments);
}

// Bad input: exit code 2 (or 3), nothing on stdout, one line on stderr that holds all these words.
inline void expect_refusal(const testing::Finished& finished, const std::vector<std::string>& words,
                           int code = 2) {
  EXPECT_EQ(finished.exit_code, code) << finished.out << finished.err;
  EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  EXPECT_TRUE(finished.err.starts_with("pathrace: ")) << finished.err;
  for (const std::string& word : words) {
    EXPECT_NE(finished.err.find(word), std::string::npos) << "'" << word << "' is not in: " << finished.err;
  }
}

}  // namespace pathrace::bench
