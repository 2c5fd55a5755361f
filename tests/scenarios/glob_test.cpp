// Patterns against names; the oracle is the C library's fnmatch.
#include "scenarios/glob.hpp"

#include <fnmatch.h>
#include <gtest/gtest.h>

#include <string>

#include "core/stream.hpp"

namespace pathrace::scenarios {
namespace {

TEST(Glob, StarsQuestionMarksAndSetsStandForAnythingButASlash) {
  EXPECT_TRUE(glob_matches("trap-*/20/*", "trap-u/20/7"));
  EXPECT_TRUE(glob_matches("*/*", "a/b"));
  EXPECT_FALSE(glob_matches("*", "a/b"));
  EXPECT_FALSE(glob_matches("a?b", "a/b"));
  EXPECT_FALSE(glob_matches("a[!x]b", "a/b"));
  EXPECT_TRUE(glob_matches("dense/[12]0-[!3]0/?", "dense/20-20/7"));
  EXPECT_TRUE(glob_matches("[]x]", "]"));
  EXPECT_TRUE(glob_matches("a[b", "a[b"));
  EXPECT_TRUE(glob_matches("\\*", "*"));
  EXPECT_FALSE(glob_matches("\\*", "a"));
  EXPECT_TRUE(glob_matches("", ""));
  EXPECT_TRUE(glob_matches("***", ""));
  EXPECT_FALSE(glob_matches("a", ""));
}

TEST(Glob, AgreesWithTheCLibraryOnRandomPatterns) {
  const std::string symbols = "aab/*?";
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    Stream stream = Stream(1).fork(i);
    std::string pattern;
    std::string text;
    for (std::size_t n = stream.below(8); n > 0; --n) pattern += symbols[stream.below(6)];
    for (std::size_t n = stream.below(8); n > 0; --n) text += symbols[stream.below(4)];
    ASSERT_EQ(glob_matches(pattern, text), fnmatch(pattern.c_str(), text.c_str(), FNM_PATHNAME) == 0)
        << "'" << pattern << "' and '" << text << "'";
  }
}

TEST(Glob, ManyStarsTakeNoTime) {
  std::string pattern;
  for (int i = 0; i < 100; ++i) pattern += "*a";
  EXPECT_FALSE(glob_matches(pattern + "b", std::string(10'000, 'a')));  // exponential by trying every split
}

}  // namespace
}  // namespace pathrace::scenarios
