// What the readers of pictures, yaml and text say of files that are none: one printable line with the file,
// the value and what was expected.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "scenarios/image/image_file.hpp"
#include "scenarios/map_reader.hpp"
#include "tests/scenarios/movingai_files.hpp"
#include "tests/scenarios/picture_bytes.hpp"

namespace pathrace::scenarios {
namespace {

using namespace std::string_literals;
using testing::big_endian;
using testing::bmp;
using testing::little_endian;
using testing::message_of;
using testing::png;
using testing::png_chunk;
using testing::png_magic;
using testing::TemporaryFolder;

struct Malformed {
  std::string file;
  std::string bytes;
  std::vector<std::string> words;  // each of them is in the message
};

void expect_refused(const Malformed& malformed, const TemporaryFolder& folder) {
  const std::filesystem::path file = folder.write(malformed.file, malformed.bytes);
  ::testing::internal::CaptureStderr();
  const std::string message = message_of<InputError>([&] { read_map(file); });
  const std::string noise = ::testing::internal::GetCapturedStderr();
  SCOPED_TRACE(malformed.bytes.substr(0, 60) + "\n -> " + message);
  EXPECT_EQ(noise, "");
  EXPECT_TRUE(message.starts_with(file.string() + ":"));
  EXPECT_TRUE(std::all_of(message.begin(), message.end(), [](char c) { return c >= 0x20 && c < 0x7f; }));
  EXPECT_LT(message.size(), file.string().size() + 220);
  for (const std::string& word : malformed.words) {
    EXPECT_NE(message.find(word), std::string::npos) << "does not say " << word;
  }
}

std::string corrupted(std::string bytes, std::size_t at) {
  bytes[at] = static_cast<char>(bytes[at] ^ 1);
  return bytes;
}

const std::string small_png = png({2, 2, 8, 0, {}}, "\x00\x01\xfe\xff"s, 2);

std::vector<Malformed> malformed_pnm() {
  return {
      {"a.pgm", "", {"the file is empty", "expected a PNG, BMP or Netpbm"}},
      {"b.pgm", "hello world", {"'hello wo'", "expected a PNG, BMP or Netpbm"}},
      {"c.pgm", "\0\1\2\3"s, {"'\\x00\\x01\\x02\\x03'"}},
      {"d.pgm", "P", {":1: begins with 'P'", "P2 or P5"}},
      {"e.pgm", "P7\nWIDTH 8\n", {"'P7\\x0a'", "P2 or P5"}},
      {"f.pgm", "P55 1 1 255 x", {"'P55'"}},
      {"g.pgm", "P5\n", {":2: the file ends; expected the width"}},
      {"h.pgm", "P5\n# only a comment", {":2: the file ends"}},
      {"i.pgm", "P5\n-2 3\n255\n", {":2: '-2'", "the width", "from 1"}},
      {"j.pgm", "P5\n2 0\n255\n", {":2: '0'", "the height"}},
      {"k.pgm", "P5\n2 2\n0\n", {":3: '0'", "the greatest value", "1 to 65535"}},
      {"l.pgm", "P5\n2 2\n65536\n", {":3: '65536'", "1 to 65535"}},
      {"m.pgm", "P5\n2 2\n255\nabc", {"holds 3 bytes of samples; expected 4"}},
      {"n.pgm", "P5\n2 2\n300\nabcdefg", {"holds 7 bytes of samples; expected 8"}},
      {"o.pgm", "P5\n2 2\n255", {"holds 0 bytes of samples; expected 4"}},
      {"p.pgm", "P5\n16385 1\n255\n", {"16385x1", "1 to 16384"}},
      {"q.pgm", "P5\n16384 16384\n255\n", {"16384x16384", "134217728"}},
      {"r.pgm", "P5\n99999999999 1\n255\n", {"'99999999999'"}},
      {"s.pgm", "P2\n2 2\n9\n1 2\n3 10\n", {":5: '10'", "0 to 9"}},
      {"t.pgm", "P2\n2 2\n9\n1 2\nx 4\n", {":5: 'x'", "a sample"}},
      {"u.pgm", "P2\n2 2\n9\n11 2\n3\n", {"'11'"}},
      {"v.pgm", "P2\n4096 4096\n9\n1 2\n3\n", {"expected 33554431"}},
      {"x.pgm", "P5 1 1 255 \x07rest"s, {"holds 5 bytes of samples; expected 1"}},
      {"y.pgm",
       "P5\n2 1\n255\nab"
       "P5\n2 1\n255\nab",
       {"holds 15 bytes", "expected 2", "no second picture"}},
      {"z.pgm", "P5\n2 1\n255\n\nab\n", {"holds 4 bytes of samples; expected 2"}},  // where do they begin?
      {"z1.pgm", "P5\r\n2 1\r\n255\r\na", {"holds 1 bytes of samples; expected 2"}},
      {"z2.pgm", "P2\n2 1\n9\n1 2 3\n", {":4: '3\\x0a' behind the last sample"}},
      {"z3.pbm", "P1\n2 2\n0120", {":3: '2'; expected a pixel, 0 or 1"}},
      {"z4.pbm", "P1\n2 2\n010", {":3: the file ends; expected a pixel, 0 or 1"}},
      {"z5.pbm", "P1\n2 1\n0 1 1", {"'1' behind the last sample"}},
      {"z6.pbm", "P4\n9 2\nabc", {"holds 3 bytes of samples; expected 4"}},
      {"z7.pbm", "P1\n999999999 999999999\n0", {"999999999x999999999"}},
      {"w.pgm", "P5\n2 1\n9\n\x09\x0a", {"sample 10 at byte 1", "expected at most 9"}},
  };
}

std::vector<Malformed> malformed_png() {
  std::string huge = png({1, 1, 8, 0, {}}, "\x00"s, 1);
  const std::string huge_header =
      png_chunk("IHDR", big_endian(70000, 4) + big_endian(1, 4) + "\x08\x00\x00\x00\x00"s);
  huge.replace(8, huge_header.size(), huge_header);
  return {
      {"a.png", png_magic, {"a damaged PNG", "ends too early"}},
      {"b.png", "\x89PNGjunk", {"a damaged PNG"}},
      {"c.png", small_png.substr(0, 20), {"ends too early"}},
      {"d.png", small_png.substr(0, small_png.size() - 20), {"ends too early"}},
      {"e.png", corrupted(small_png, 50), {"a damaged PNG"}},
      {"f.png", corrupted(small_png, 17), {"a damaged PNG", "CRC"}},
      {"g.png", huge, {"70000x1", "1 to 16384"}},
      {"h.png", png({3, 3, 8, 0, {}}, "\x00\x01\xfe"s, 3), {"a damaged PNG"}},
      {"i.png", png({1, 1, 8, 3, {}}, "\x00"s, 1), {"a damaged PNG", "PLTE"}},
      {"j.png", png({1, 1, 7, 0, {}}, "\x00"s, 1), {"a damaged PNG"}},
      {"l.png",
       png_magic + big_endian(0x7fffffff, 4) + "zTXtabcdefgh"s,
       {"inside the chunk 'zTXt' of 2147483647 bytes"}},
      {"m.png",
       png_magic + png_chunk("IHDR", big_endian(4096, 4) + big_endian(4096, 4) + "\x08\0\0\0\0"s) +
           png_chunk("IDAT", std::string(100, 'x')) + png_chunk("IEND", ""),
       {"4096x4096 pixels in 100 compressed bytes; expected at least 16256"}},  // 2^24 / 1032
      {"n.jpg.png", "\xff\xd8\xff\xe0JFIF", {"is a JPEG", "expected a PNG, BMP or Netpbm"}},
      {"o.gif.png", "GIF89a", {"is a GIF"}},
      {"p.tif.png", "II*\0"s, {"is a TIFF"}},
      {"q.webp.png", "RIFF\1\2\3\4WEBPVP8", {"is a WebP"}},
      {"k.png", png({0, 1, 8, 0, {}}, "", 1), {"a damaged PNG"}},
  };
}

std::vector<Malformed> malformed_bmp() {
  const std::string pixel = "\x01\x02\x03\x00"s;
  std::string old = bmp({1, 1, 24, 0, {}, 0}, pixel);
  old[14] = 12;
  return {
      {"a.bmp", "BM", {"a BMP of 2 bytes", "at least 54"}},
      {"b.bmp", bmp({2, 2, 24, 0, {}, 0}, pixel), {"a BMP of 58 bytes", "at least 70"}},
      {"c.bmp", bmp({2, 2, 8, 1, std::string(1024, '\0'), 0}, pixel), {"compression 1", "expected none"}},
      {"d.bmp", bmp({1, 1, 16, 0, {}, 0}, pixel), {"16 bits", "1, 4, 8, 24 or 32"}},
      {"e.bmp", bmp({0, 1, 24, 0, {}, 0}, pixel), {"0x1"}},
      {"f.bmp", bmp({0x80000000U, 1, 24, 0, {}, 0}, pixel), {"-2147483648x1"}},
      {"g.bmp", bmp({1, 0x80000000U, 24, 0, {}, 0}, pixel), {"1x2147483648"}},
      {"h.bmp", old, {"header of 12 bytes", "40 or more"}},
      {"i.bmp",
       bmp({1, 1, 8, 0, "\x01\x02\x03\x00"s, 1}, "\x05\x00\x00\x00"s),
       {"colour 5 in the row at byte 58", "the palette's 1"}},
      {"j.bmp", bmp({1, 1, 8, 0, {}, 257}, pixel), {"palette of 257 colours"}},
      {"k.bmp", bmp({1, 1, 32, 3, std::string(12, '\0'), 0}, pixel), {"colour mask 0x00000000"}},
  };
}

std::vector<Malformed> malformed_yaml() {
  const std::string image = "image: x.pgm\n";
  const std::string place = "resolution: 0.05\norigin: [0, 0, 0]\n";
  return {
      {"a.yaml", "", {":1: nothing at the top", "expected a map of image"}},
      {"b.yaml", "- image\n- resolution\n", {":1: a list of 2", "expected a map"}},
      {"c.yaml", "just words", {":1: 'just words'"}},
      {"d.yaml", image + "origin: [0, 0\n", {":3: no yaml, in column 1"}},
      {"e.yaml", "resolution: 1\nimage: x: y\n", {":2: no yaml, in column 9"}},
      {"f.yaml", place, {":1: no 'image'"}},
      {"g.yaml", "# a map\nimage: gone.pgm\n" + place, {":2: image '", "gone.pgm'", "no such file"}},
      {"h.yaml", "image: [x]\n" + place, {":1: image a list of 1", "the path of a picture"}},
      {"i.yaml", image + "origin: [0, 0, 0]\n", {":1: no 'resolution'"}},
      {"j.yaml", image + "resolution: 0\norigin: [0, 0, 0]\n", {":2: resolution '0'", "above 0"}},
      {"k.yaml", image + "resolution: -0.05\norigin: [0, 0, 0]\n", {":2: resolution '-0.05'"}},
      {"l.yaml", image + "resolution: .nan\norigin: [0, 0, 0]\n", {":2: resolution '.nan'"}},
      {"m.yaml", image + "resolution: coarse\norigin: [0, 0, 0]\n", {":2: resolution 'coarse'"}},
      {"n.yaml", image + "resolution: 0.05\n", {":1: no 'origin'"}},
      {"o.yaml", image + "resolution: 0.05\norigin: [0, 0]\n", {":3: origin a list of 2", "[x, y, yaw]"}},
      {"p.yaml", image + "resolution: 0.05\norigin: [0, a, 0]\n", {":3: origin", "'a' is none"}},
      {"q.yaml", image + "resolution: 0.05\norigin: 0 0 0\n", {":3: origin '0 0 0'"}},
      {"r.yaml", image + place + "occupied_thresh: 1.5\n", {":4: occupied_thresh '1.5'", "0 to 1"}},
      {"s.yaml", image + place + "free_thresh: -0.1\n", {":4: free_thresh '-0.1'", "0 to 1"}},
      {"t.yaml",
       image + place + "occupied_thresh: 0.2\nfree_thresh: 0.6\n",
       {":5: free_thresh '0.6'", "at most occupied_thresh", "0.6 > 0.2"}},
      {"u.yaml", image + place + "negate: 2\n", {":4: negate '2'", "0 or 1"}},
      {"u1.yaml", image + place + "negate: [1]\n", {":4: negate a list of 1", "0 or 1"}},
      {"u2.yaml", "\xff\xfei\0m\0"s, {":1: UTF-16"}},
      {"v.yaml", image + place + "mode: tertiary\n", {":4: mode 'tertiary'", "trinary, scale or raw"}},
      {"w.yaml", image + place + "resolution: 0.1\n", {":4: 'resolution' again"}},
      {"x.yaml", "\x89PNG\r\n\x1a\n\0\0"s, {"; expected a map of image"}},
  };
}

std::vector<Malformed> malformed_text() {
  return {
      {"a.txt", "", {":1: the file is empty", "rows of 0 and 1"}},
      {"b.txt", "0101\n01\n", {":2: a row of 2 cells", "expected 4"}},
      {"c.txt", "0101\n0121\n", {":2: '2' in column 3", "expected 0 or 1"}},
      {"d.txt", "0101\n\n0101\n", {":2: a blank line"}},
      {"e.txt", "01 01\n", {":1: '01' in column 1", "with and without separators"}},
      {"f.csv", "0,1,,\n", {":1: an empty cell in column 5"}},
      {"g.csv", "0,,1\n", {":1: an empty cell in column 3"}},
      {"h.csv", "0,1\n0;x\n", {":2: 'x' in column 3"}},
      {"i.csv", "\0\1"s, {":1: '\\x00' in column 1"}},
      {"j.txt", std::string(16385, '0'), {":1: a map of 16385x1"}},
      {"k.csv", "x,y\n0,1\n", {":1: 'x' in column 1"}},
      {"l.csv", "0,1,5\n0,9,0\n", {":1: '5' in column 5", "cells have no weights"}},
      {"m.csv", "0,0.5\n", {":1: '0.5' in column 3", "cells have no weights"}},
      {"n.csv", "-1 100\n", {":1: '-1' in column 1", "cells have no weights"}},
      {"o.csv", "\"0,1\n", {":1: a quote without its end in column 1"}},
      {"p.csv", "\"0\"1\n", {":1: '1' behind a quote in column 4"}},
      {"q.csv", "0,\"\"\n", {":1: an empty cell in column 3"}},
      {"r.csv",
       "\xff\xfe"
       "0\0,\0"
       "1\0"s,
       {":1: UTF-16 text", "expected UTF-8"}},
      {"s.txt",
       "\0"
       "0\0"
       "1\0\n"s,
       {":1: UTF-16 text"}},
      {"t.csv", "0,1e999\n", {":1: '1e999' in column 3"}},
  };
}

TEST(MalformedMaps, EachIsRefusedInOneLineThatNamesTheValueAndWhatWasExpected) {
  const TemporaryFolder folder;
  for (const auto& table :
       {malformed_pnm(), malformed_png(), malformed_bmp(), malformed_yaml(), malformed_text()}) {
    for (const Malformed& malformed : table) expect_refused(malformed, folder);
  }
}

TEST(MalformedMaps, APictureCutAnywhereIsRefused) {
  const std::string rows = "\x01\x02\x03\x04\x05\x06\x00\x00\xff\xff\xff\x0a\x0a\x0a\x00\x00"s;
  for (const std::string& whole :
       {small_png, bmp({2, 2, 24, 0, {}, 0}, rows), "P5\n2 2\n255\nabcd"s, "P2\n2 2\n9\n1 2 3 4"s}) {
    EXPECT_NO_THROW(parse_image(whole, "x"));
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_THROW(parse_image(whole.substr(0, size), "x"), InputError) << size << " of " << whole.size();
    }
  }
}

TEST(MalformedMaps, APictureWithAnyByteChangedIsReadOrRefusedAndNothingElse) {
  const std::string rows = "\x01\x02\x03\x04\x05\x06\x00\x00\xff\xff\xff\x0a\x0a\x0a\x00\x00"s;
  for (const std::string& whole :
       {small_png, bmp({2, 2, 24, 0, {}, 0}, rows), "P5\n2 2\n255\nabcd"s, "P2\n2 2\n9\n1 2 3 4"s}) {
    for (std::size_t at = 0; at < whole.size(); ++at) {
      for (const char byte : {'\0', '\x01', '\x7f', '\xff', '9'}) {
        std::string changed = whole;
        changed[at] = byte;
        try {
          parse_image(changed, "x");
        } catch (const InputError&) {  // fine
        }
      }
    }
  }
}

TEST(MalformedMaps, WhatIsNoFileIsNamed) {
  const TemporaryFolder folder;
  for (const std::string& extension : map_extensions()) {
    const std::string missing = (folder.path() / ("missing" + extension)).string();
    EXPECT_EQ(message_of<InputError>([&] { read_map(missing); }), missing + ": no such file");
    const std::string directory = (folder.path() / ("folder" + extension)).string();
    std::filesystem::create_directory(directory);
    EXPECT_EQ(message_of<InputError>([&] { read_map(directory); }),
              directory + ": is a folder; expected a file");
  }
}

TEST(MalformedMaps, AnUnknownExtensionIsAnsweredWithTheKnownOnes) {
  EXPECT_EQ(message_of<InputError>([] { read_map("plan.jpeg"); }),
            "plan.jpeg: the extension '.jpeg' is of no map; expected one of .map .yaml .yml .pgm .ppm .pbm "
            ".png .bmp "
            ".csv .txt");
}

TEST(MalformedMaps, AYamlSaysItsResolutionItself) {
  const TemporaryFolder folder;
  folder.write("x.pgm", "P2 1 1 9 9");
  const auto yaml = folder.write("x.yaml", "image: x.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n");
  MapOptions options;
  options.resolution = 0.1;
  EXPECT_NE(message_of<InputError>([&] { read_map(yaml, options); }).find("got 0.1"), std::string::npos);
}

}  // namespace
}  // namespace pathrace::scenarios
