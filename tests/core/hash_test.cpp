#include "core/hash.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

namespace pathrace {
namespace {

using namespace std::string_view_literals;

std::uint64_t hash_of(std::string_view text) {
  return Hasher().add(text).value();
}

TEST(Hasher, TheSameFieldsGiveTheSameHash) {
  EXPECT_EQ(Hasher().add(1).add("a"sv).value(), Hasher().add(1).add("a"sv).value());
}

TEST(Hasher, TheOrderOfFieldsMatters) {
  EXPECT_NE(Hasher().add(1).add(2).value(), Hasher().add(2).add(1).value());
  EXPECT_NE(Hasher().add("a"sv).add("b"sv).value(), Hasher().add("b"sv).add("a"sv).value());
}

TEST(Hasher, WhereATextIsSplitMatters) {
  EXPECT_NE(Hasher().add("ab"sv).add("c"sv).value(), Hasher().add("a"sv).add("bc"sv).value());
  EXPECT_NE(Hasher().add("12345678"sv).add(""sv).value(), Hasher().add(""sv).add("12345678"sv).value());
}

TEST(Hasher, AnEmptyTextIsAField) {
  EXPECT_NE(Hasher().add(""sv).value(), Hasher().value());
}

// Both are one word of zeros; only the length before it tells them apart.
TEST(Hasher, TheLengthOfATextMatters) {
  EXPECT_NE(hash_of(std::string_view("\0", 1)), hash_of(std::string_view("\0\0", 2)));
  EXPECT_NE(hash_of("a"), hash_of(std::string_view("a\0", 2)));
}

TEST(Hasher, EveryByteOfATextMatters) {
  const std::string text = "dense/20-30/17 and more";
  std::set<std::uint64_t> hashes{hash_of(text)};
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string changed = text;
    changed[i] = static_cast<char>(changed[i] ^ '\x80');
    hashes.insert(hash_of(changed));
  }
  EXPECT_EQ(hashes.size(), text.size() + 1);
}

TEST(Hasher, HowManyZerosWereAddedMatters) {
  std::set<std::uint64_t> hashes;
  Hasher hasher;
  for (int i = 0; i < 100; ++i) {
    hashes.insert(hasher.value());
    hasher.add(0);
  }
  EXPECT_EQ(hashes.size(), 100U);
}

TEST(Hasher, NumbersAreHashedByTheirBits) {
  EXPECT_EQ(Hasher().add(-1).value(), Hasher().add(~std::uint64_t{0}).value());
  EXPECT_EQ(Hasher().add(1.0).value(), Hasher().add(std::uint64_t{0x3FF0000000000000}).value());
  EXPECT_NE(Hasher().add(0.0).value(), Hasher().add(-0.0).value());
}

TEST(Hasher, ReadingTheValueDoesNotChangeIt) {
  Hasher hasher;
  hasher.add(5);
  const std::uint64_t first = hasher.value();
  EXPECT_EQ(hasher.value(), first);
}

TEST(Hex, IsSixteenLowerCaseDigits) {
  EXPECT_EQ(hex(0), "0000000000000000");
  EXPECT_EQ(hex(0xABCDEF0123U), "000000abcdef0123");
  EXPECT_EQ(hex(~std::uint64_t{0}), "ffffffffffffffff");
}

}  // namespace
}  // namespace pathrace
