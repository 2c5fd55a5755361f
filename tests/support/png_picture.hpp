// A PNG file, read back.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pathrace::testing {

/// What a PNG file's first 33 bytes say: its signature and its header, decoded by hand.
struct PngHeader {
  bool signature = false;
  bool begins_with_header = false;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  int bit_depth = 0;
  int colour_type = 0;  ///< 2 is red, green, blue
  int interlace = 0;
};
PngHeader png_header(const std::string& file);

/// The names of its chunks in order; throws std::runtime_error when they do not end with the file.
std::vector<std::string> png_chunks(const std::string& file);

/// Red, green, blue of each pixel, row by row from the top.
struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
};
/// Decoded by libpng; throws std::runtime_error with its words.
Pixels png_pixels(const std::string& file);

}  // namespace pathrace::testing
