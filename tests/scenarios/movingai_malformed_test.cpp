// What the readers say of files that are none: where, which value, what was expected - on one line.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "scenarios/movingai/map_file.hpp"
#include "scenarios/movingai/scen_file.hpp"
#include "tests/scenarios/movingai_files.hpp"

namespace pathrace::scenarios {
namespace {

using pathrace::testing::message_of;
using namespace std::string_literals;

struct Malformed {
  std::string what;
  std::string text;
  int line;
  std::vector<std::string> words;  // each of them is in the message
};

bool is_one_printable_line(const std::string& message) {
  return std::all_of(message.begin(), message.end(),
                     [](char character) { return character >= 0x20 && character < 0x7f; });
}

void expect_refused(const Malformed& malformed, const std::string& name, const std::string& message) {
  SCOPED_TRACE(malformed.what + ": " + message);
  ASSERT_NE(message, "") << "was read without an error";
  const std::string where = name + ":" + std::to_string(malformed.line) + ": ";
  EXPECT_EQ(message.substr(0, where.size()), where);
  EXPECT_TRUE(is_one_printable_line(message));
  EXPECT_LT(message.size(), 200U);
  for (const std::string& word : malformed.words) {
    EXPECT_NE(message.find(word), std::string::npos) << "does not say " << word;
  }
}

std::string map_header(const std::string& height, const std::string& width) {
  return "type octile\nheight " + height + "\nwidth " + width + "\nmap\n";
}

const std::string side_range = "expected a whole number from 1 to 16384";

const std::vector<Malformed>& malformed_maps() {
  static const std::vector<Malformed> maps = {
      {"empty", "", 1, {"the file is empty", "expected 'type octile'"}},
      {"only blanks", " \n\r\n\t\n", 1, {"the file is empty"}},
      {"ends after type", "type octile\n", 2, {"ends inside the header"}},
      {"ends after height", "type octile\nheight 2\n", 3, {"ends inside the header"}},
      {"ends after width", "type octile\nheight 2\nwidth 2", 4, {"ends inside the header", "'map'"}},
      {"no map line", "type octile\nheight 2\nwidth 2\n..\n..\n", 4, {"'..' in the header", "'map'"}},
      {"no type", "height 2\nwidth 2\nmap\n..\n..\n", 3, {"'map' without 'type'"}},
      {"no height", "type octile\nwidth 2\nmap\n..\n..\n", 3, {"'map' without 'height'"}},
      {"no width", "type octile\nheight 2\nmap\n..\n..\n", 3, {"'map' without 'width'"}},
      {"blank line in the header", "type octile\n\nheight 2\n", 2, {"'' in the header"}},
      {"map with a value", "type octile\nheight 2\nwidth 2\nmap x\n..\n", 4, {"'map x' in the header"}},
      {"two types", "type octile\ntype octile\nheight 1\n", 2, {"'type' again", "line 1"}},
      {"two heights", "type octile\nheight 2\nheight 3\n", 3, {"'height' again", "line 2"}},
      {"two widths", "type octile\nwidth 2\nheight 2\nwidth 2\n", 4, {"'width' again", "line 2"}},
      {"another type", "type hexagon\nheight 1\nwidth 1\nmap\n.\n", 1, {"'hexagon'", "'octile'"}},
      {"a type without a value", "type\nheight 1\nwidth 1\nmap\n.\n", 1, {"type ''", "'octile'"}},
      {"height of zero", map_header("0", "2"), 2, {"height '0'", side_range}},
      {"width of zero", map_header("2", "0"), 3, {"width '0'", side_range}},
      {"height below zero", map_header("-5", "2"), 2, {"height '-5'", side_range}},
      {"width below zero", map_header("2", "-1"), 3, {"width '-1'", side_range}},
      {"height in letters", map_header("two", "2"), 2, {"height 'two'", side_range}},
      {"width with letters", map_header("2", "2x"), 3, {"width '2x'", side_range}},
      {"width with a fraction", map_header("2", "2.5"), 3, {"width '2.5'", side_range}},
      {"height without a value", map_header("", "2"), 2, {"height ''", side_range}},
      {"height twice on one line", map_header("2 3", "2"), 2, {"height '2 3'", side_range}},
      {"height beyond 32 bits", map_header("4294967298", "2"), 2, {"height '4294967298'", side_range}},
      {"width beyond 64 bits", map_header("2", "99999999999999999999"), 3, {"width '999", side_range}},
      {"height one too large", map_header("16385", "1"), 2, {"height '16385'", side_range}},
      {"width in billions", map_header("1", "2000000000"), 3, {"width '2000000000'", side_range}},
      {"both sides large", map_header("16384", "16384"), 3, {"16384x16384", "at most 134217728"}},
      {"no rows", map_header("2", "2"), 5, {"ends after 0 rows", "expected 2"}},
      {"a row missing", map_header("3", "2") + "..\n..\n", 7, {"ends after 2 rows", "expected 3"}},
      {"a row missing before blank lines", map_header("2", "2") + "..\n\n\n", 6, {"ends after 1 rows"}},
      {"a row too many", map_header("1", "2") + "..\n@.\n", 6, {"'@.' after the last row", "1 rows"}},
      {"a row after a blank line", map_header("1", "2") + "..\n\n..\n", 6, {"after the last row"}},
      {"a row too short", map_header("2", "3") + "...\n..\n", 6, {"2 cells '..'", "expected 3"}},
      {"a row too long", map_header("2", "3") + "....\n...\n", 5, {"4 cells '....'", "expected 3"}},
      {"an empty row", map_header("2", "3") + "\n...\n", 5, {"0 cells ''", "expected 3"}},
      {"height and width exchanged", map_header("2", "3") + "..\n..\n..\n", 5, {"2 cells", "expected 3"}},
      {"an unknown letter", map_header("1", "3") + ".x.\n", 5, {"'x' in column 1", ". G S W @ O T"}},
      {"a space among the cells", map_header("1", "3") + ". .\n", 5, {"' ' in column 1"}},
      {"a NUL among the cells", map_header("1", "3") + "..\0"s, 5, {"'\\x00' in column 2"}},
      {"a byte above ASCII", map_header("1", "3") + "\xe9..", 5, {"'\\xe9' in column 0"}},
      {"an escape sequence", map_header("1", "4") + "\x1b[2J", 5, {"'\\x1b' in column 0"}},
      {"binary from the first byte", "\x7f"s + "ELF\x02\x01\0\0\n\xff\xfe"s, 1, {R"(\x7fELF\x02\x01\x00)"}},
      {"one endless line", std::string(100000, 'z'), 1, {"'zzzz", "zzz...'"}},
      {"an endless binary value", map_header(std::string(5000, '\xff'), "2"), 2, {"\\xff...'"}},
      {"a row of NULs", map_header("1", "2") + std::string(60, '\0'), 5, {"60 cells", "\\x00...'"}},
      {"far more than the header says",
       map_header("1", "1") + std::string(5000, '.'),
       4,
       {"5033 bytes", "at most 4102", "1x1"}},
      {"UTF-16", "\xff\xfet\0y\0p\0e\0"s, 1, {"UTF-16", "expected UTF-8"}},
      {"UTF-16 without a mark", "t\0y\0p\0e\0"s, 1, {"UTF-16", "expected UTF-8"}},
      {"UTF-16, high bytes first", "\xfe\xff\0t\0y"s, 1, {"UTF-16"}},
      {"a picture", "P5\n2 2\n255\n\x01\x02\x03\x04", 1, {"'P5' in the header"}},
      {"a scen file", "version 1\n0\tx.map\t8\t8\t0\t0\t1\t1\t1.41421\n", 1, {"'version 1' in the header"}},
  };
  return maps;
}

std::string scen_with(const std::string& line) {
  return "version 1\n0\tx.map\t8\t8\t0\t0\t1\t1\t1.41421\n" + line + "\n";
}

const std::string whole = "expected a whole number";
const std::string amount = "expected a number, 0 or more";

const std::vector<Malformed>& malformed_scens() {
  static const std::vector<Malformed> scens = {
      {"empty", "", 1, {"the file is empty", "expected 'version 1'"}},
      {"no version", "0\tx.map\t8\t8\t0\t0\t1\t1\t1.41421\n", 1, {"'0\\x09x.map", "expected 'version 1'"}},
      {"version 2", "version 2\n", 1, {"'version 2'", "expected 'version 1'"}},
      {"version without a number", "version\n", 1, {"'version'", "expected 'version 1'"}},
      {"version with more", "version 1 beta\n", 1, {"'version 1 beta'"}},
      {"a blank line first", "\nversion 1\n", 1, {"''", "expected 'version 1'"}},
      {"no query", "version 1\n", 2, {"expected a query"}},
      {"eight fields", scen_with("0\tx.map\t8\t8\t0\t0\t1\t1"), 3, {"8 fields", "expected 9"}},
      {"ten fields", scen_with("0\tx.map\t8\t8\t0\t0\t1\t1\t2\t3"), 3, {"10 fields", "expected 9"}},
      {"one field", scen_with("end"), 3, {"1 fields 'end'", "expected 9"}},
      {"a spaced map name between spaces", scen_with("0 my own.map 8 8 0 0 1 1 2"), 3, {"10 fields"}},
      {"bucket in letters", scen_with("x x.map 8 8 0 0 1 1 2"), 3, {"bucket 'x'", whole}},
      {"width in letters", scen_with("0 x.map w 8 0 0 1 1 2"), 3, {"width 'w'", whole}},
      {"height with a fraction", scen_with("0 x.map 8 8.5 0 0 1 1 2"), 3, {"height '8.5'", whole}},
      {"start x empty", scen_with("0\tx.map\t8\t8\t\t0\t1\t1\t2"), 3, {"start x ''", whole}},
      {"start y in hexadecimal", scen_with("0 x.map 8 8 0 0x1 1 1 2"), 3, {"start y '0x1'", whole}},
      {"goal x beyond int",
       scen_with("0 x.map 8 8 0 0 2147483648 1 2"),
       3,
       {"goal x '2147483648'", "32 bits"}},
      {"goal y below int", scen_with("0 x.map 8 8 0 0 1 -2147483649 2"), 3, {"goal y '-2147483649'", whole}},
      {"bucket beyond 64 bits", scen_with("99999999999999999999 x.map 8 8 0 0 1 1 2"), 3, {"bucket '999"}},
      {"optimum in letters", scen_with("0 x.map 8 8 0 0 1 1 far"), 3, {"optimum 'far'", amount}},
      {"optimum below zero", scen_with("0 x.map 8 8 0 0 1 1 -1.5"), 3, {"optimum '-1.5'", amount}},
      {"optimum nan", scen_with("0 x.map 8 8 0 0 1 1 nan"), 3, {"optimum 'nan'", amount}},
      {"optimum inf", scen_with("0 x.map 8 8 0 0 1 1 inf"), 3, {"optimum 'inf'", amount}},
      {"optimum beyond double", scen_with("0 x.map 8 8 0 0 1 1 1e999"), 3, {"optimum '1e999'", amount}},
      {"optimum with a comma", scen_with("0 x.map 8 8 0 0 1 1 1,41421"), 3, {"optimum '1,41421'", amount}},
      {"a NUL in a number", scen_with("0 x.map 8 8 0 0 1 1\0 2"s), 3, {"goal y '1\\x00'", whole}},
      {"a NUL alone", std::string(1, '\0'), 1, {"'\\x00'"}},
      {"binary", "\x89PNG\r\n\x1a\n\0\0\0"s, 1, {"'\\x89PNG'"}},
      {"one endless line", scen_with(std::string(100000, '7')), 3, {"1 fields '777", "777...'"}},
      {"a map file", "type octile\nheight 1\nwidth 1\nmap\n.\n", 1, {"'type octile'", "'version 1'"}},
  };
  return scens;
}

TEST(MovingAiMalformed, EveryMalformedMapIsRefusedWithItsLineItsValueAndWhatWasExpected) {
  for (const Malformed& malformed : malformed_maps()) {
    expect_refused(malformed, "bad.map",
                   message_of<InputError>([&] { MapFile::parse(malformed.text, "bad.map"); }));
  }
}

TEST(MovingAiMalformed, EveryMalformedScenIsRefusedWithItsLineItsValueAndWhatWasExpected) {
  for (const Malformed& malformed : malformed_scens()) {
    expect_refused(malformed, "bad.scen",
                   message_of<InputError>([&] { ScenFile::parse(malformed.text, "bad.scen"); }));
  }
}

TEST(MovingAiMalformed, AFileSaysTheSameAsItsText) {
  const pathrace::testing::TemporaryFolder folder;
  for (const Malformed& malformed : malformed_maps()) {
    const std::string file = folder.write("bad.map", malformed.text).string();
    expect_refused(malformed, file, message_of<InputError>([&] { MapFile::read(file); }));
  }
  for (const Malformed& malformed : malformed_scens()) {
    const std::string file = folder.write("bad.scen", malformed.text).string();
    expect_refused(malformed, file, message_of<InputError>([&] { ScenFile::read(file); }));
  }
}

TEST(MovingAiMalformed, AMapCutAnywhereIsRefusedUnlessOnlyItsLastLineEndIsGone) {
  const std::string text = map_header("2", "12") + "............\n@@@@@@@@@@@@\n";
  EXPECT_NO_THROW(MapFile::parse(text, "x.map"));
  EXPECT_NO_THROW(MapFile::parse(text.substr(0, text.size() - 1), "x.map"));
  for (std::size_t size = 0; size + 1 < text.size(); ++size) {
    EXPECT_THROW(MapFile::parse(text.substr(0, size), "x.map"), InputError) << size << " bytes";
  }
}

TEST(MovingAiMalformed, AFileNameWithALineEndStaysOnOneLine) {
  const std::string message = message_of<InputError>([] { MapFile::parse("", "two\nlines.map"); });
  EXPECT_EQ(message, "two\\x0alines.map:1: the file is empty; expected 'type octile'");
}

TEST(MovingAiMalformed, AnotherMapsNameIsShownCutAndPrintable) {
  const ScenFile scen =
      ScenFile::parse(scen_with("0 " + std::string(300, 'm') + "\x1b.map 8 8 0 0 1 1 2"), "bad.scen");
  const std::string message = message_of<InputError>([&] { require_same_map(scen, "x.map"); });
  expect_refused({"another map", "", 3, {"names map 'mmm", "...'", "expected 'x.map'"}}, "bad.scen", message);
}

}  // namespace
}  // namespace pathrace::scenarios
