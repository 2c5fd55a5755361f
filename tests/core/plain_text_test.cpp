#include "core/plain_text.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"

namespace pathrace {
namespace {

TEST(PlainText, LettersOfAnyLanguageArePlain) {
  for (const char* text : {"", "as:ants=20", "caf\xC3\xA9", "\xE8\x9A\x81", "\xF0\x9F\x90\x9C", "~ =+-@"}) {
    EXPECT_TRUE(is_plain_text(text)) << text;
    EXPECT_EQ(escape_controls(text), text);
  }
}

TEST(PlainText, WhatCommandsATerminalOrIsNoTextIsNot) {
  const std::pair<std::string, std::string> cases[] = {
      {"\x1b[31mred", "\\x1b[31mred"},        // CSI
      {"a\nb", "a\\x0ab"},                    // a line end
      {"\x7f", "\\x7f"},                      // DEL
      {"\xC2\x9B", "\\xc2\\x9b"},             // CSI as one C1 character, U+009B
      {"\xE2\x80\xA8", "\\xe2\\x80\\xa8"},    // line separator, U+2028
      {"a\xE2\x80\xAE", "a\\xe2\\x80\\xae"},  // right-to-left override, U+202E
      {"a\xEF\xBB\xBF", "a\\xef\\xbb\\xbf"},  // byte order mark, U+FEFF
      {"\xFFok", "\\xffok"},                  // no UTF-8
      {"\xE2\x82", "\\xe2\\x82"},             // half a letter
      {std::string(1, '\0'), "\\x00"},
  };
  for (const auto& [text, escaped] : cases) {
    EXPECT_FALSE(is_plain_text(text)) << escaped;
    EXPECT_EQ(escape_controls(text), escaped);
  }
}

TEST(PlainText, ANameThatIsNotPlainIsRefusedInOneLine) {
  EXPECT_NO_THROW(require_plain_name("x.toml", "label", "=1+1"));
  try {
    require_plain_name("a\tb.toml", "label", "two\nlines");
    FAIL() << "was taken";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "a\\x09b.toml: label 'two\\x0alines'; expected a name without control characters");
  }
}

}  // namespace
}  // namespace pathrace
