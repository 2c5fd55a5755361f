#include "core/utf8.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pathrace {
namespace {

TEST(Utf8, KnowsHowManyBytesALetterHas) {
  EXPECT_EQ(letter_size("a\xC3\xA9"), 1U);
  EXPECT_EQ(letter_size("\xC3\xA9"), 2U);
  EXPECT_EQ(letter_size("\xE2\x82\xAC"), 3U);
  EXPECT_EQ(letter_size("\xF0\x9F\x90\x9C"), 4U);
  EXPECT_EQ(letter_size(""), 0U);
  EXPECT_EQ(code_point("a", 1), 0x61U);
  EXPECT_EQ(code_point("\xE2\x82\xAC", 3), 0x20ACU);
  EXPECT_EQ(code_point("\xF0\x9F\x90\x9C", 4), 0x1F41CU);
}

TEST(Utf8, NeverLooksBeyondTheText) {
  const std::string_view euro = "\xE2\x82\xAC";
  EXPECT_EQ(letter_size(euro.substr(0, 1)), 0U);
  EXPECT_EQ(letter_size(euro.substr(0, 2)), 0U);
}

TEST(Utf8, CountsLettersAndStrayBytes) {
  EXPECT_EQ(letter_count(""), 0U);
  EXPECT_EQ(letter_count("as"), 2U);
  EXPECT_EQ(letter_count("\xC3\xA9t\xC3\xA9"), 3U);
  EXPECT_EQ(letter_count("\xFF\xFE!"), 3U);
}

TEST(Utf8, ShortensTextInItsMiddle) {
  EXPECT_EQ(shortened("abcdef", 6), "abcdef");
  EXPECT_EQ(shortened("abcdefg", 6), "abc\u2026fg");
  EXPECT_EQ(shortened("abcdefg", 5), "ab\u2026fg");
  EXPECT_EQ(shortened("abcdefg", 2), "a\u2026");
  EXPECT_EQ(shortened("abcdefg", 1), "\u2026");
  EXPECT_EQ(shortened("\u00e9\u00e8\u00ea\u00eb", 3), "\u00e9\u2026\u00eb");
  EXPECT_EQ(shortened("", 1), "");
}

}  // namespace
}  // namespace pathrace
