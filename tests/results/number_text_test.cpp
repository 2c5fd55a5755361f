#include "results/number_text.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/stream.hpp"

namespace pathrace::results {
namespace {

TEST(NumberText, IsTheShortestThatReadsBack) {
  EXPECT_EQ(print_number(0), "0");
  EXPECT_EQ(print_number(-0.0), "-0");
  EXPECT_EQ(print_number(19), "19");
  EXPECT_EQ(print_number(0.1), "0.1");
  EXPECT_EQ(print_number(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(print_number(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(print_number(std::bit_cast<double>(0xFFF8000000000123U)), "nan:fff8000000000123");
}

TEST(NumberText, ReadsBackBitForBitForAnyBits) {
  Stream stream(20240607);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = stream.bits();
    EXPECT_EQ(std::bit_cast<std::uint64_t>(parse_number(print_number(std::bit_cast<double>(bits)))), bits);
  }
  const std::uint64_t nan = 0x7FF0000000000001U;
  EXPECT_EQ(std::bit_cast<std::uint64_t>(parse_number(print_number(std::bit_cast<double>(nan)))), nan);
}

TEST(NumberText, IsNothingElse) {
  for (const char* text : {"", " 1", "1 ", "1,5", "0x10", "one", "+1", "nan:", "nan:3ff0000000000000"}) {
    EXPECT_THROW(parse_number(text), InputError) << text;
  }
}

TEST(CountText, IsAnUnsignedNumberOfSixtyFourBits) {
  EXPECT_EQ(parse_count("0"), 0U);
  EXPECT_EQ(parse_count("18446744073709551615"), 18446744073709551615U);
  for (const char* text : {"", "-1", "18446744073709551616", "1.0", "a"}) {
    EXPECT_THROW(parse_count(text), InputError) << text;
  }
}

TEST(HexText, IsSixteenLowerCaseDigits) {
  EXPECT_EQ(parse_hex("00000000000000ff"), 255U);
  EXPECT_EQ(parse_hex("ffffffffffffffff"), 18446744073709551615U);
  for (const char* text : {"", "ff", "00000000000000FF", "0x000000000000ff", "000000000000000000ff"}) {
    EXPECT_THROW(parse_hex(text), InputError) << text;
  }
}

TEST(NumberText, ComplaintsStayOnOneShortLine) {
  const std::string text = "a\nb" + std::string(1000, 'x');
  try {
    parse_number(text);
    FAIL();
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_LT(message.size(), 120U);
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_NE(message.find("'a?bxxx"), std::string::npos);
  }
}

}  // namespace
}  // namespace pathrace::results
