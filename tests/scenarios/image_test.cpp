// Pictures, sample by sample: the expected values are the bytes that the test wrote.
#include "scenarios/image/image_file.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "scenarios/image/png_writer.hpp"
#include "tests/scenarios/picture_bytes.hpp"
#include "tests/support/maps.hpp"

namespace pathrace::scenarios {
namespace {

using namespace std::string_literals;
using testing::big_endian;
using testing::bmp;
using testing::little_endian;
using testing::png;
using testing::png_chunk;
using Samples = std::vector<std::uint32_t>;

void expect_image(const std::string& bytes, int width, int height, std::uint32_t white,
                  const Samples& samples) {
  const GreyImage image = parse_image(bytes, "x");
  EXPECT_EQ(image.width, width);
  EXPECT_EQ(image.height, height);
  EXPECT_EQ(image.white, white);
  EXPECT_EQ(image.samples, samples);
}

TEST(Pnm, BytesAndTextSayTheSame) {
  expect_image("P5\n3 2\n255\n"s + "\x00\x01\x7f\x80\xfe\xff"s, 3, 2, 255, {0, 1, 127, 128, 254, 255});
  expect_image("P2\n3 2\n255\n0 1 127\n128 254 255\n", 3, 2, 255, {0, 1, 127, 128, 254, 255});
}

TEST(Pnm, AnyGreatestValueIsKept) {
  expect_image("P2 2 1 1 0 1", 2, 1, 1, {0, 1});
  expect_image("P5 2 1 15 \x03\x0f"s, 2, 1, 15, {3, 15});
}

TEST(Pnm, SixteenBitsAreReadHighByteFirstAndKeptExactly) {
  Samples samples;
  std::string raster;
  for (std::uint32_t i = 0; i < 65536; i += 257) {
    samples.push_back(i);
    raster += big_endian(i, 2);
  }
  samples.push_back(258);
  raster += "\x01\x02";
  expect_image("P5\n1 " + std::to_string(samples.size()) + "\n65535\n" + raster, 1,
               static_cast<int>(samples.size()), 65535, samples);
  expect_image("P5\n1 1\n256\n\x01\x00"s, 1, 1, 256, {256});
  expect_image("P2\n2 1\n65535\n65535 40000\n", 2, 1, 65535, {65535, 40000});
}

TEST(Pnm, CommentsMayStandBetweenTheNumbersOfTheHeader) {
  expect_image("P5 # a map\n#\n2# width\n# 9 9\n 1\n# the greatest\r\n255\n#a", 2, 1, 255, {'#', 'a'});
  expect_image("P2\r\n#c\r\n1 1\r\n7\r\n#c\r\n5\r\n", 1, 1, 7, {5});
}

TEST(Pnm, AFirstSampleThatLooksLikeABlankIsASample) {
  expect_image("P5\n2 1\n255\n\n ", 2, 1, 255, {10, 32});
}

TEST(Pnm, ColoursAreSummed) {
  expect_image("P3 2 1 255  1 2 3  255 255 255", 2, 1, 765, {6, 765});
  expect_image("P6 1 1 255 \x0a\x14\x1e"s, 1, 1, 765, {60});
}

TEST(Pnm, ALineEndOfTwoBytesBelongsToTheHeader) {
  expect_image("P5\r\n2 2\r\n255\r\n\xfe\x00\xcd\xfe"s, 2, 2, 255, {254, 0, 205, 254});
  expect_image("P5 1 1 255\r\n\x0a"s, 1, 1, 255, {10});
}

TEST(Pnm, ACommentBetweenTheHeaderAndTheSamplesIsPassedOver) {
  const Samples samples = {254, 0, 205, 254};
  for (const std::string header :
       {"P5\n2 2\n255 # max\n", "P5\n2 2\n255# max\n", "P5\n2 2\n255\n# a\n#b\r\n"}) {
    expect_image(header + "\xfe\x00\xcd\xfe"s, 2, 2, 255, samples);
  }
}

TEST(Pnm, LineEndsBehindTheSamplesArePassedOver) {
  expect_image("P5\n2 1\n255\n\x07\x0a\n\n"s, 2, 1, 255, {7, 10});
  expect_image("P5\r\n2 1\r\n255\r\n\x07\x0a\r\n"s, 2, 1, 255, {7, 10});
  expect_image("P2\n2 1\n255\n7 10\n\n# done\n", 2, 1, 255, {7, 10});
}

TEST(Pnm, InBitsOneIsBlackAndZeroWhite) {
  expect_image("P1\n# bits\n5 2\n0 1 0\n11 10001\n", 5, 2, 1, {1, 0, 1, 0, 0, 0, 1, 1, 1, 0});
  // Rows are padded to whole bytes: 01001011 1....... and 11111111 0.......
  expect_image("P4\n9 2\n\x4b\xff\xff\x00"s, 9, 2, 1, {1, 0, 1, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1});
}

TEST(Png, ChunksThatAMapDoesNotNeedAreNotUnpacked) {
  // A text chunk whose compressed data is broken, a profile likewise.
  const std::string chunks = png_chunk("zTXt", "k\0\0broken"s) + png_chunk("iCCP", "p\0\0broken"s);
  expect_image(png({2, 1, 8, 0, chunks}, "\x07\x08", 2), 2, 1, 255, {7, 8});
}

TEST(Png, GreysOfEveryDepth) {
  expect_image(png({9, 1, 1, 0, {}}, "\xa5\x80"s, 2), 9, 1, 255, {255, 0, 255, 0, 0, 255, 0, 255, 255});
  expect_image(png({4, 1, 2, 0, {}}, "\x1b", 1), 4, 1, 255, {0, 85, 170, 255});
  expect_image(png({2, 1, 4, 0, {}}, "\x2f", 1), 2, 1, 255, {34, 255});
  expect_image(png({2, 2, 8, 0, {}}, "\x00\x01\xfe\xff"s, 2), 2, 2, 255, {0, 1, 254, 255});
  expect_image(png({2, 1, 16, 0, {}}, "\x12\x34\xff\xfe"s, 4), 2, 1, 65535, {0x1234, 0xfffe});
}

TEST(Png, ColoursAreSummedAtTheirDepth) {
  expect_image(png({2, 1, 8, 2, {}}, "\x01\x02\x03\xff\xff\xff"s, 6), 2, 1, 765, {6, 765});
  expect_image(png({2, 1, 16, 2, {}}, "\x00\x01\x00\x02\x01\x00\xff\xff\xff\xff\xff\xff"s, 12), 2, 1, 196605,
               {1 + 2 + 256, 3 * 65535});
}

TEST(Png, InterlacedPicturesArePutTogether) {
  // Adam7 on 2x2 pixels: 0,0 in pass one, 1,0 in pass six, the second row in pass seven.
  expect_image(testing::png_of_raster({2, 2, 8, 0, {}, 1}, "\0\x0a\0\x0b\0\x0c\x0d"s), 2, 2, 255,
               {10, 11, 12, 13});
}

TEST(Png, AFilteredRowIsRestored) {
  // Filter 1: each byte is the difference from the one before; filter 2: from the one above.
  expect_image(testing::png_of_raster({3, 2, 8, 0, {}}, "\x01\x05\x01\xff\x02\x01\x01\x01"s), 3, 2, 255,
               {5, 6, 5, 6, 7, 6});
}

TEST(Png, GammaIsNotApplied) {
  expect_image(png({1, 1, 8, 0, png_chunk("gAMA", big_endian(100000, 4))}, "\x40", 1), 1, 1, 255, {64});
}

TEST(Png, PalettesAreLookedUp) {
  const std::string palette = png_chunk("PLTE", "\x01\x02\x03\x0a\x14\x1e"s);
  expect_image(png({3, 1, 1, 3, palette}, "\x40", 1), 3, 1, 765, {6, 60, 6});
  expect_image(png({2, 1, 8, 3, palette}, "\x01\x00"s, 2), 2, 1, 765, {60, 6});
}

TEST(Png, AlphaIsKeptAside) {
  const GreyImage grey = parse_image(png({2, 1, 8, 4, {}}, "\x07\xff\x08\x00"s, 4), "x");
  EXPECT_EQ(grey.samples, (Samples{7, 8}));
  EXPECT_EQ(grey.opaque, 255);
  EXPECT_EQ(grey.alpha, (std::vector<std::uint16_t>{255, 0}));
  const GreyImage colour = parse_image(png({1, 1, 16, 6, {}}, "\x00\x01\x00\x02\x00\x03\x80\x01"s, 8), "x");
  EXPECT_EQ(colour.samples, Samples{6});
  EXPECT_EQ(colour.opaque, 65535);
  EXPECT_EQ(colour.alpha, std::vector<std::uint16_t>{0x8001});
  const std::string clear_entry = png_chunk("PLTE", "\x01\x02\x03\x0a\x14\x1e"s) + png_chunk("tRNS", "\x00"s);
  const GreyImage palette = parse_image(png({2, 1, 8, 3, clear_entry}, "\x00\x01"s, 2), "x");
  EXPECT_EQ(palette.samples, (Samples{6, 60}));
  EXPECT_EQ(palette.alpha, (std::vector<std::uint16_t>{0, 255}));
}

TEST(Bmp, TwentyFourBitsFromTheBottomUp) {
  // Two rows of two pixels, six bytes and two of padding each; the first row in the file is the lowest.
  const std::string rows = "\x01\x02\x03\x04\x05\x06\x00\x00\xff\xff\xff\x0a\x0a\x0a\x00\x00"s;
  expect_image(bmp({2, 2, 24, 0, {}, 0}, rows), 2, 2, 765, {765, 30, 6, 15});
  expect_image(bmp({2, 0xfffffffeU, 24, 0, {}, 0}, rows), 2, 2, 765, {6, 15, 765, 30});
}

TEST(Bmp, ThirtyTwoBitsHaveAlphaOnlyByAMask) {
  expect_image(bmp({1, 1, 32, 0, {}, 0}, "\x01\x02\x03\x04"s), 1, 1, 765, {6});
  EXPECT_TRUE(parse_image(bmp({1, 1, 32, 0, {}, 0}, "\x01\x02\x03\x04"s), "x").alpha.empty());
  // Masks for red, green and blue in the three upper bytes.
  const std::string masks =
      little_endian(0xff000000U, 4) + little_endian(0xff0000U, 4) + little_endian(0xff00U, 4);
  expect_image(bmp({1, 1, 32, 3, masks, 0}, "\x01\x02\x03\x04"s), 1, 1, 765, {9});
  std::string longer = bmp({1, 1, 32, 3, masks + little_endian(0xffU, 4), 0}, "\x01\x02\x03\x04"s);
  longer[14] = 56;  // a header that counts its masks
  const GreyImage image = parse_image(longer, "x");
  EXPECT_EQ(image.samples, Samples{9});
  EXPECT_EQ(image.opaque, 255);
  EXPECT_EQ(image.alpha, std::vector<std::uint16_t>{1});
}

TEST(Bmp, PalettesOfOneFourAndEightBits) {
  const std::string two = "\x01\x02\x03\x00\x0a\x14\x1e\x00"s;
  expect_image(bmp({9, 1, 1, 0, two, 0}, "\xa5\x80\x00\x00"s), 9, 1, 765, {60, 6, 60, 6, 6, 60, 6, 60, 60});
  expect_image(bmp({3, 1, 4, 0, two, 2}, "\x10\x10\x00\x00"s), 3, 1, 765, {60, 6, 60});
  expect_image(bmp({2, 1, 8, 0, two, 2}, "\x01\x00\x00\x00"s), 2, 1, 765, {60, 6});
}

TEST(PngWriter, EveryRandomGridIsReadBack) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    Stream stream = Stream(3).fork(i);
    const int width = stream.between(1, 40);
    const OccupancyGrid grid = testing::random_grid(stream.fork(0), width, stream.between(1, 40), 0.4);
    std::ostringstream out;
    write_png(out, grid);
    const GreyImage image = parse_image(out.str(), "x.png");
    ASSERT_EQ(image.width, grid.width());
    ASSERT_EQ(image.height, grid.height());
    ASSERT_EQ(image.white, 255U);
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        ASSERT_EQ(image.samples[image.index(x, y)], grid.is_free({x, y}) ? 255U : 0U) << i;
      }
    }
  }
}

}  // namespace
}  // namespace pathrace::scenarios
